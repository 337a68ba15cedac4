// SPDX-License-Identifier: GPL-2.0-or-later
// A level from files that a front end brings: nothing of it lies on a disk.
#include "common/error.h"
#include "common/file_system.h"
#include "common/memory_source.h"
#include "formats/small_level.h"
#include "level/level.h"

#include <gtest/gtest.h>

namespace vigil {
namespace {

using test::MemorySource;

TEST(InjectedFiles, HoldALevel) {
    FileSystem files;
    files.mount(std::make_unique<MemorySource>(
        MemorySource::Files{{"maps/small.bsp", write_level(small_level())}}));
    const auto level = load_level(files, "SMALL");
    EXPECT_EQ(level->name, "SMALL");
    EXPECT_EQ(level->bsp.faces.size(), 3u);
    EXPECT_TRUE(level->pvs.visible(1, 0));
    EXPECT_FALSE(level->pvs.visible(0, 1));
    EXPECT_THROW(load_level(files, "large"), Error);
    EXPECT_TRUE(list_levels(files).empty()); // this source cannot tell what it has
}

TEST(InjectedFiles, LieOverWhatWasMountedBefore) {
    FileSystem files;
    const auto mount = [&](MemorySource::Files content) {
        files.mount(std::make_unique<MemorySource>(std::move(content)));
    };
    mount({{"a.txt", {'1'}}, {"b.txt", {'1'}}});
    mount({{"b.txt", {'2'}}});
    EXPECT_EQ(files.read_text("a.txt"), "1");
    EXPECT_EQ(files.read_text("B.TXT"), "2");
    EXPECT_EQ(files.find("b.txt")->source, "memory");
    EXPECT_FALSE(files.exists("c.txt"));
    EXPECT_THROW(files.read("../a.txt"), Error); // a source is never asked for an unsafe path
}

} // namespace
} // namespace vigil
