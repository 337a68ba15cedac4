// SPDX-License-Identifier: GPL-2.0-or-later
// Replays inputs through every fuzz target without libFuzzer: the seeds, what once was a finding
// (regressions/TARGET/), and every real file of the project. So these are checked by any compiler,
// with the sanitizers in the sanitizer build.
#include "seeds.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

namespace vigil::fuzz {
namespace {

namespace fs = std::filesystem;

class Replay : public testing::TestWithParam<Target> {};

TEST_P(Replay, HasSeeds) {
    EXPECT_FALSE(built_seeds(GetParam()).empty() &&
                 found_seeds(GetParam(), VIGIL_SOURCE_DIR "/baseq2").empty() &&
                 found_seeds(GetParam(), VIGIL_SOURCE_DIR "/tests/data").empty());
}

TEST_P(Replay, Seeds) {
    for (const Bytes& seed : built_seeds(GetParam()))
        EXPECT_NO_THROW(GetParam().run(seed));
}

TEST_P(Replay, FilesOfTheProject) {
    for (const char* folder : {VIGIL_SOURCE_DIR "/baseq2", VIGIL_SOURCE_DIR "/tests/data"})
        for (const Bytes& file : found_seeds(GetParam(), folder))
            EXPECT_NO_THROW(GetParam().run(file));
}

TEST_P(Replay, Regressions) {
    const fs::path folder = fs::path(VIGIL_SOURCE_DIR "/tests/fuzz/regressions") / GetParam().name;
    if (!fs::is_directory(folder)) return; // nothing was ever found
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        SCOPED_TRACE(entry.path());
        std::ifstream file(entry.path(), std::ios::binary);
        const Bytes bytes(std::istreambuf_iterator<char>(file), {});
        EXPECT_NO_THROW(GetParam().run(bytes));
    }
}

INSTANTIATE_TEST_SUITE_P(Fuzz, Replay, testing::ValuesIn(targets().begin(), targets().end()),
                         [](const auto& row) { return std::string(row.param.name); });

} // namespace
} // namespace vigil::fuzz
