// SPDX-License-Identifier: GPL-2.0-or-later
// Camera, routes and the statistics of pass times.
#include "client/demo/route.h"
#include "client/measure/count_statistics.h"
#include "client/measure/pass_statistics.h"
#include "client/play/camera.h"
#include "common/error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace vigil::client {
namespace {

void expect_near(const glm::vec3& a, const glm::vec3& b, float tolerance) {
    for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(a[i], b[i], tolerance) << "component " << i;
}

TEST(ViewAxes, FollowQuakesAngles) {
    expect_near(view_axes({0, 0, 0}).forward, {1, 0, 0}, 1e-6f);
    expect_near(view_axes({0, 90, 0}).forward, {0, 1, 0}, 1e-6f);
    expect_near(view_axes({90, 0, 0}).forward, {0, 0, -1}, 1e-6f); // pitch down is positive
    expect_near(view_axes({0, 0, 0}).right, {0, -1, 0}, 1e-6f);
    expect_near(view_axes({0, 0, 90}).up, {0, -1, 0}, 1e-6f); // roll is clockwise
}

TEST(ViewAxes, AreOrthonormalAndRightHanded) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> degrees(-360.0f, 360.0f);
    for (int i = 0; i < 1000; ++i) {
        const ViewAxes axes = view_axes({degrees(random), degrees(random), degrees(random)});
        expect_near(glm::cross(axes.forward, axes.up), axes.right, 1e-5f);
        EXPECT_NEAR(glm::length(axes.forward), 1.0f, 1e-5f);
        EXPECT_NEAR(glm::dot(axes.forward, axes.up), 0.0f, 1e-5f);
    }
}

TEST(Camera, FliesAtItsSpeedWhateverKeysAreHeld) {
    Camera camera;
    FlightInput input;
    input.forward = 1.0f;
    input.right = 1.0f;
    camera.fly(input, 0.5f);
    EXPECT_NEAR(glm::length(camera.origin()), Camera::default_speed * 0.5f, 1e-3f);
    camera.set({}, {});
    camera.set_speed(1e9f);
    EXPECT_EQ(camera.speed(), Camera::fastest);
}

TEST(Camera, SetViewPosTextBringsItBack) {
    Camera camera;
    camera.set({1.25f, -2.5f, 1000.0f}, {-12.5f, 190.0f, 0.0f});
    EXPECT_EQ(camera.setviewpos_text(), "setviewpos 1.25 -2.50 1000.00 -12.50 -170.00 0.00");
}

TEST(CountStatistics, MeansOfRecentFramesOrOfAll) {
    CountStatistics recent(2), all(0);
    for (const double value : {1.0, 2.0, 6.0}) {
        const std::vector<refresh::FrameCount> counts{{"leaves", value}, {"depth", 3.0}};
        recent.add_frame(counts);
        all.add_frame(counts);
    }
    recent.add_frame({}); // guiding was off: no frame to count
    EXPECT_EQ(recent.frame_count(), 2u);
    ASSERT_EQ(recent.means().size(), 2u);
    EXPECT_EQ(recent.means()[0].name, "leaves");
    EXPECT_DOUBLE_EQ(recent.means()[0].value, 4.0);
    EXPECT_DOUBLE_EQ(all.means()[0].value, 3.0);
    EXPECT_DOUBLE_EQ(all.means()[1].value, 3.0);
    EXPECT_NE(all.table().find("mean of 3 frames"), std::string::npos);
    recent.clear();
    EXPECT_TRUE(recent.means().empty());
    EXPECT_EQ(recent.table(), "no frame has been counted");
}

TEST(Route, PassesThroughItsKeys) {
    const Route route = Route::parse("r", "0 0 0 0 0 0 0\n\n1 10 0 5 1 2 3 # c\n3 20 4 5 0 0 0");
    ASSERT_EQ(route.keys().size(), 3u);
    EXPECT_EQ(route.duration_s(), 3.0);
    for (const Route::Key& key : route.keys()) {
        expect_near(route.at(key.time_s).origin, key.origin, 1e-5f);
        expect_near(route.at(key.time_s).angles, key.angles, 1e-5f);
    }
    expect_near(route.at(-5.0).origin, {0, 0, 0}, 0.0f);
    expect_near(route.at(99.0).origin, {20, 4, 5}, 0.0f);
}

TEST(Route, EvenKeysOnALineMoveEvenly) {
    const Route route = Route::parse("r", "0 0 0 0 0 0 0\n1 10 0 0 0 0 0\n2 20 0 0 0 0 0");
    for (double t = 0.0; t <= 2.0; t += 0.0625) {
        EXPECT_NEAR(route.at(t).origin.x, 10.0 * t, 1e-4);
    }
}

TEST(Route, MovesWithoutJumpsAndKinks) {
    const Route route =
        Route::parse("r", "0 0 0 0 0 0 0\n1 10 7 0 5 90 0\n1.5 0 9 3 0 45 0\n4 3 3 3 9 9 9");
    const double h = 1e-4;
    for (const double t : {1.0, 1.5}) {
        const glm::vec3 before = (route.at(t).origin - route.at(t - h).origin) / float(h);
        const glm::vec3 after = (route.at(t + h).origin - route.at(t).origin) / float(h);
        expect_near(before, after, 0.1f);
    }
}

TEST(Route, AnglesTakeTheShorterWay) {
    const Route route = Route::parse("r", "0 0 0 0 0 170 0\n1 0 0 0 0 -170 0\n2 0 0 0 0 170 0");
    for (double t = 0.0; t <= 2.0; t += 0.125) {
        EXPECT_GE(route.at(t).angles.y, 170.0f - 1e-3f) << t;
        EXPECT_LE(route.at(t).angles.y, 190.0f + 1e-3f) << t;
    }
    EXPECT_NEAR(route.at(1.0).angles.y, 190.0f, 1e-4f);
}

TEST(Route, CountsBothEnds) {
    const Route route = Route::parse("r", "2 0 0 0 0 0 0\n4 0 0 0 0 0 0");
    EXPECT_EQ(route.frame_count(20.0), 41);
    EXPECT_EQ(route.frame_count(0.4), 1);
    EXPECT_EQ(Route::parse("r", "0 1 2 3 4 5 6").frame_count(20.0), 1);
    const Route longest = Route::parse("r", "-1e6 0 0 0 0 0 0\n1e6 0 0 0 0 0 0");
    EXPECT_EQ(longest.frame_count(10000.0), 2147483647);
}

TEST(Route, NamesTheLineThatIsWrong) {
    const auto message = [](std::string_view text) -> std::string {
        try {
            Route::parse("bad.route", text);
        } catch (const Error& error) {
            return error.what();
        }
        return "accepted";
    };
    EXPECT_NE(message("0 0 0 0 0 0 0\n1 0 0 0 0 0").find("bad.route, line 2"), std::string::npos);
    EXPECT_NE(message("0 0 0 x 0 0 0").find("line 1"), std::string::npos);
    EXPECT_NE(message("0 0 0 nan 0 0 0").find("line 1"), std::string::npos);
    EXPECT_NE(message("1 0 0 0 0 0 0\n1 0 0 0 0 0 0").find("increase"), std::string::npos);
    EXPECT_NE(message("# nothing").find("no views"), std::string::npos);
    EXPECT_NE(message("0 0 0 2e6 0 0 0").find("numbers up to 1e+06"), std::string::npos);
    EXPECT_NE(message("1e30 0 0 0 0 0 0").find("line 1"), std::string::npos);
    EXPECT_NE(message("0 0 0 0 0 0 0\n1e-30 1e6 0 0 0 0 0").find("line 2: times must increase"),
              std::string::npos);
}

TEST(PassStatistics, SummarisesByRank) {
    PassStatistics statistics;
    EXPECT_EQ(statistics.table(), "no frames have been timed");
    for (int i = 1; i <= 100; ++i) {
        std::vector<refresh::PassTime> frame{{"a", double(i)}};
        if (i % 2 == 0) frame.push_back({"b", 101.0});
        statistics.add_frame(frame);
    }
    const std::vector<PassSummary> passes = statistics.summarize();
    ASSERT_EQ(passes.size(), 2u);
    EXPECT_EQ(passes[0].minimum, 1.0);
    EXPECT_EQ(passes[0].median, 50.0);
    EXPECT_EQ(passes[0].mean, 50.5);
    EXPECT_EQ(passes[0].p99, 99.0);
    EXPECT_EQ(passes[1].frames, 50u); // frames without the pass do not count as 0
    EXPECT_EQ(passes[1].mean, 101.0);
    EXPECT_NEAR(passes[0].share, 0.5, 1e-9);
    EXPECT_NE(statistics.table().find("all passes"), std::string::npos);
    statistics.clear();
    EXPECT_EQ(statistics.frame_count(), 0u);
}

} // namespace
} // namespace vigil::client
