// SPDX-License-Identifier: GPL-2.0-or-later
// Places to measure at: on routes, and where players start in real levels.
#include "bench/quality_places.h"

#include "common/file_system.h"
#include "formats/bsp_query.h"
#include "formats/real_levels.h"
#include "level/level.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

namespace vigil::bench {

namespace {

client::Route straight_route(double seconds) {
    return client::Route(
        {{0.0, glm::vec3(0.0f), glm::vec3(0.0f)},
         {seconds, glm::vec3(100.0f * static_cast<float>(seconds), 0.0f, 0.0f), glm::vec3(0.0f)}});
}

} // namespace

TEST(RoutePlaces, LieInTheMiddleOfEqualPartsAfterTheirWarmup) {
    const std::vector<Place> places = route_places(straight_route(20.0), 4, 16);
    ASSERT_EQ(places.size(), 4u);
    for (std::size_t i = 0; i < places.size(); ++i) {
        ASSERT_EQ(places[i].frames.size(), 17u);
        EXPECT_NEAR(places[i].measured().time_s, 2.5 + 5.0 * static_cast<double>(i), 1e-9);
        for (std::size_t frame = 1; frame < 17; ++frame)
            EXPECT_NEAR(places[i].frames[frame].time_s - places[i].frames[frame - 1].time_s,
                        1.0 / place_fps, 1e-9);
        EXPECT_NEAR(places[i].measured().origin.x, 100.0 * places[i].measured().time_s, 0.01);
    }
}

TEST(RoutePlaces, ShortRoutesStillHaveTheirFrames) {
    const std::vector<Place> places = route_places(straight_route(0.5), 3, 16);
    for (const Place& place : places) {
        ASSERT_EQ(place.frames.size(), 17u);
        EXPECT_EQ(place.measured().time_s, 0.5); // all that there is of warm-up comes before
        EXPECT_EQ(place.frames.front().time_s, 0.0);
    }
}

TEST(StartPlaces, AreInTheOpenInRealLevels) {
    const auto folder = real_levels_folder();
    if (!folder) GTEST_SKIP() << "no real levels: set VIGIL_SHARED";
    FileSystem files;
    files.mount_game(*folder, "baseq2");
    for (const RealLevel& real : real_levels) {
        const std::shared_ptr<const Level> level = load_level(files, real.name);
        const std::vector<Place> places = start_places(level->bsp, 5, 16);
        ASSERT_EQ(places.size(), 5u);
        for (std::size_t i = 0; i < places.size(); ++i) {
            ASSERT_EQ(places[i].frames.size(), 17u);
            for (const Pose& pose : places[i].frames)
                EXPECT_GE(cluster_at(level->bsp, pose.origin), 0) << real.name;
            for (std::size_t j = 0; j < i; ++j)
                EXPECT_FALSE(places[i].measured().origin == places[j].measured().origin &&
                             places[i].measured().angles == places[j].measured().angles)
                    << real.name << ": the same view twice";
        }
    }
}

} // namespace vigil::bench
