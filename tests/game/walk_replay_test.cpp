// SPDX-License-Identifier: GPL-2.0-or-later
// The walks that come with the levels, replayed without a renderer: no walk leaves its level,
// stands in a wall, gets stuck or dies; each ends where it says, opens as many doors as it says,
// and ends there bit for bit each time. tools/walks makes them.
#include "common/file_system.h"
#include "formats/real_levels.h"
#include "walks/walk_report.h"

#include <glm/glm.hpp>
#include <gtest/gtest.h>

#include <filesystem>
#include <fmt/format.h>
#include <iostream>

namespace vigil {
namespace {

const std::filesystem::path sources = VIGIL_SOURCE_DIR;

/// Returns how many doors it opened.
int check_walk(const std::filesystem::path& basedir, const std::string& name,
               const std::filesystem::path& path) {
    SCOPED_TRACE(name);
    FileSystem files;
    files.mount_game(basedir, "baseq2");
    const std::shared_ptr<const Level> level = load_level(files, name);
    const Bytes bytes = read_file(path);
    const std::string text(bytes.begin(), bytes.end());
    const walks::WalkGoal goal = walks::read_goal(name, text);
    const client::Walk walk = client::Walk::parse(name, text);
    const walks::WalkReport report = walks::report_walk(level, walk);
    std::cout << fmt::format("{}: {}\n", name, report.text());
    EXPECT_EQ(report.outside, 0);
    // Rounding may leave it inside by a hair for a tick.
    EXPECT_LT(report.longest_in_solid, 3);
    EXPECT_LT(report.longest_stuck, player::ticks_per_second);
    EXPECT_EQ(report.deaths, 0);
    // It waits for doors, and no longer than they take.
    EXPECT_LT(report.longest_rest, 4 * player::ticks_per_second);
    EXPECT_LT(glm::distance(report.end.origin, goal.place), 16.0f);
    EXPECT_EQ(report.doors_opened, goal.doors);
    // Through the level, not around the start.
    EXPECT_GT(report.way, 2000.0);
    EXPECT_EQ(walks::report_walk(level, walk).end, report.end);
    return report.doors_opened;
}

TEST(WalkReplay, ShippedLevels) {
    int levels = 0;
    for (const auto& entry : std::filesystem::directory_iterator(sources / "baseq2" / "maps")) {
        if (entry.path().extension() != ".bsp") continue;
        const std::string name = entry.path().stem().string();
        check_walk(sources, name, sources / "baseq2" / "walks" / (name + ".walk"));
        ++levels;
    }
    EXPECT_GE(levels, 11);
}

TEST(WalkReplay, RealLevels) {
    const auto folder = real_levels_folder();
    if (!folder) GTEST_SKIP() << "the real levels are not here";
    int doors = 0;
    for (const RealLevel& real : real_levels)
        doors +=
            check_walk(*folder, real.name,
                       sources / "tests" / "data" / "walks" / (std::string(real.name) + ".walk"));
    EXPECT_GT(doors, 10);
}

/// The report sees what walks must not do.
TEST(WalkReplay, FindsWhoRunsAgainstAWall) {
    FileSystem files;
    files.mount_game(sources, "baseq2");
    const std::shared_ptr<const Level> level = load_level(files, "warehouse");
    const walks::WalkReport report =
        walks::report_walk(level, client::Walk::parse("w", "3000 400 0 0 0 0 0 0\n"));
    EXPECT_GT(report.longest_stuck, 300);
    const walks::WalkReport rests =
        walks::report_walk(level, client::Walk::parse("w", "300 0 0 0 0 0 0 0\n"));
    EXPECT_EQ(rests.longest_stuck, 0);
    EXPECT_GT(rests.longest_rest, 200);
}

} // namespace
} // namespace vigil
