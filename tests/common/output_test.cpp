// SPDX-License-Identifier: GPL-2.0-or-later
// Output paths stay in their folder, and files appear whole or not at all.
#include "common/output.h"

#include "common/error.h"
#include "full_disk.h"
#include "scratch_folder.h"

namespace vigil {
namespace {

namespace fs = std::filesystem;
using test::error_of;
using test::read_whole;
using test::ScratchFolder;

std::size_t files_in(const fs::path& folder) {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

TEST(Output, PathsStayInTheirFolderAndFoldersAreMade) {
    const ScratchFolder scratch;
    const std::string out = (scratch.path() / "new" / "out").string();
    EXPECT_EQ(output_path(out, "demos/run.dm2"), fs::path(out) / "demos/run.dm2");
    EXPECT_TRUE(fs::is_directory(fs::path(out) / "demos"));
    for (const std::string_view name :
         {std::string_view("../x"), std::string_view("a/../../x"), std::string_view("/etc/x"),
          std::string_view(""), std::string_view("a\\b"), std::string_view("c:x"),
          std::string_view("a\0b", 3), std::string_view("a/"), std::string_view("./a")})
        EXPECT_THROW(output_path(out, name), Error) << name;
    EXPECT_THROW(output_path("", "x"), Error);
    scratch.write("file", "text");
    EXPECT_THROW(output_path((scratch.path() / "file").string(), "x"), Error);
}

TEST(Output, WritesReplaceTheWholeFile) {
    const ScratchFolder scratch;
    const fs::path file = scratch.path() / "a" / "b.cfg";
    write_file(file, "a longer first text");
    write_file(file, "short");
    EXPECT_EQ(read_whole(file), "short");
    write_file(file, "");
    EXPECT_EQ(read_whole(file), "");
    EXPECT_EQ(files_in(file.parent_path()), 1u);
}

TEST(Output, AFailedWriteKeepsTheOldFileAndSaysWhy) {
    const ScratchFolder scratch;
    const fs::path file = scratch.write("shot.png", "old");

    std::string error;
    {
        const test::FullDisk disk(4096);
        error = error_of([&] { write_file(file, std::string(100'000, 'x')); });
    }

    EXPECT_NE(error.find("shot.png: cannot write: File too large"), std::string::npos) << error;
    EXPECT_EQ(read_whole(file), "old");
    EXPECT_EQ(files_in(scratch.path()), 1u);
}

TEST(Output, ReplacingAFolderFails) {
    const ScratchFolder scratch;
    fs::create_directories(scratch.path() / "shot.png" / "x");
    EXPECT_THROW(write_file(scratch.path() / "shot.png", "text"), Error);
    EXPECT_EQ(files_in(scratch.path()), 1u);
}

TEST(Output, XdgFoldersFollowTheSpecification) {
    setenv("XDG_CONFIG_HOME", "/somewhere/config", 1);
    EXPECT_EQ(config_dir(), "/somewhere/config/vigil");
    setenv("XDG_CONFIG_HOME", "relative", 1);
    setenv("HOME", "/home/player", 1);
    unsetenv("XDG_CACHE_HOME");
    EXPECT_EQ(config_dir(), "/home/player/.config/vigil");
    EXPECT_EQ(cache_dir(), "/home/player/.cache/vigil");
    unsetenv("HOME");
    EXPECT_THROW(cache_dir(), Error);
}

} // namespace
} // namespace vigil
