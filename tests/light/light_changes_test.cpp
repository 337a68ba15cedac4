// SPDX-License-Identifier: GPL-2.0-or-later
// How much a light has changed since the frame before.
#include "refresh/vkpt/light/light_changes.h"

#include <gtest/gtest.h>
#include <limits>

namespace vigil::test {
namespace {

shader::Light lamp(float brightness, float x = 0.0f) {
    shader::Light light{};
    light.v0 = {x, 0, 0};
    light.e1 = {1, 0, 0};
    light.e2 = {0, 1, 0};
    light.radiance = glm::vec3(brightness, 0.5f * brightness, 0.0f);
    return light;
}

TEST(LightChange, IsThePartOfTheBrightestThatDiffers) {
    EXPECT_EQ(light_change(lamp(2), lamp(2)), 0.0f);
    EXPECT_FLOAT_EQ(light_change(lamp(2), lamp(1)), 0.5f);
    EXPECT_FLOAT_EQ(light_change(lamp(1), lamp(2)), 0.5f);
    EXPECT_EQ(light_change(lamp(0), lamp(3)), 1.0f);
    EXPECT_EQ(light_change(lamp(3), lamp(0)), 1.0f);
}

TEST(LightChange, IsAllOfALampThatMoves) {
    EXPECT_EQ(light_change(lamp(2), lamp(2, 0.25f)), 1.0f);
    EXPECT_EQ(light_change(lamp(0), lamp(0, 8.0f)), 0.0f); // a dark one matters to nobody
}

TEST(LightChange, StaysInRangeAtTheExtremes) {
    constexpr float greatest = std::numeric_limits<float>::max();
    constexpr float least = std::numeric_limits<float>::denorm_min();
    EXPECT_EQ(light_change(lamp(greatest), lamp(0)), 1.0f);
    EXPECT_EQ(light_change(lamp(0), lamp(least)), 1.0f);
}

TEST(LightChanges, KnowTheFrameBefore) {
    LightChanges changes;
    const std::vector<shader::Light> first{lamp(1), lamp(2)};
    EXPECT_FALSE(changes.update(first, 1)) << "nothing came before";
    EXPECT_FALSE(changes.update(first, 1));
    const std::vector<shader::Light> more{lamp(1), lamp(1), lamp(5)};
    ASSERT_TRUE(changes.update(more, 2));
    EXPECT_EQ(std::vector<float>(changes.factors().begin(), changes.factors().end()),
              (std::vector<float>{0.0f, 0.5f, 1.0f}));
    // A change lasts for some frames.
    ASSERT_TRUE(changes.update(more, 2));
    EXPECT_EQ(std::vector<float>(changes.factors().begin(), changes.factors().end()),
              (std::vector<float>{0.0f, 0.25f, 0.5f}));
    for (int frame = 0; frame < 5; ++frame)
        changes.update(more, 2);
    EXPECT_FALSE(changes.update(more, 2));
    EXPECT_FALSE(changes.update(more, 3)) << "a revision without a difference";
    changes.forget();
    EXPECT_FALSE(changes.update(first, 4));
}

} // namespace
} // namespace vigil::test
