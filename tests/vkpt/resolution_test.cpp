// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/post/resolution.h"

#include <gtest/gtest.h>

namespace vigil::vkpt {
namespace {

/// Frames whose time goes with their pixels, seen `lag` frames later, as a renderer with frames in
/// flight sees them.
double milliseconds_after(Resolution& resolution, double full, int frames, size_t lag = 2) {
    std::vector<float> scales;
    for (int frame = 0; frame < frames; ++frame) {
        scales.push_back(resolution.scale());
        if (scales.size() <= lag) continue;
        const float shown = scales[scales.size() - 1 - lag];
        resolution.learn(full * shown * shown, shown);
    }
    return full * resolution.scale() * resolution.scale();
}

TEST(Resolution, TracesWhatThePlayerSets) {
    Resolution resolution;
    resolution.follow(100, 0.0f);
    EXPECT_FALSE(resolution.scales());
    EXPECT_EQ(resolution.traced({641, 361}), glm::uvec2(641, 361));
    resolution.follow(50, 0.0f);
    EXPECT_TRUE(resolution.scales());
    EXPECT_EQ(resolution.traced({640, 360}), glm::uvec2(320, 180));
    EXPECT_EQ(resolution.most_traced({640, 360}), glm::uvec2(320, 180));
    EXPECT_EQ(resolution.traced({1, 1}), glm::uvec2(1, 1)) << "never nothing";
    milliseconds_after(resolution, 1000.0, 100);
    EXPECT_EQ(resolution.traced({640, 360}), glm::uvec2(320, 180)) << "no rate was asked for";
}

TEST(Resolution, FindsTheScaleForARate) {
    for (const double full : {30.0, 60.0, 120.0, 400.0}) {
        Resolution resolution;
        resolution.follow(100, 30.0f);
        const double reached = milliseconds_after(resolution, full, 100);
        EXPECT_LT(reached, 1000.0 / 30.0) << full;
        if (full > 34.0) {
            EXPECT_GT(reached, 0.85 * 1000.0 / 30.0) << full;
        }
        // It stays where it is.
        const float scale = resolution.scale();
        milliseconds_after(resolution, full, 100);
        EXPECT_EQ(resolution.scale(), scale) << full;
    }
}

TEST(Resolution, KeepsWithinItsBounds) {
    Resolution resolution;
    resolution.follow(80, 60.0f);
    milliseconds_after(resolution, 1e6, 200);
    EXPECT_FLOAT_EQ(resolution.scale(), 0.25f);
    milliseconds_after(resolution, 0.1, 200);
    EXPECT_FLOAT_EQ(resolution.scale(), 0.8f) << "what the player set is the most";
    resolution.learn(0.0, 0.8f);
    resolution.learn(-1.0, 0.8f);
    EXPECT_FLOAT_EQ(resolution.scale(), 0.8f) << "a device without clocks";
}

TEST(Resolution, GoesBackWhenFramesAreFastAgain) {
    Resolution resolution;
    resolution.follow(100, 30.0f);
    milliseconds_after(resolution, 200.0, 100);
    EXPECT_LT(resolution.scale(), 0.5f);
    milliseconds_after(resolution, 20.0, 100);
    EXPECT_FLOAT_EQ(resolution.scale(), 1.0f);
}

} // namespace
} // namespace vigil::vkpt
