// SPDX-License-Identifier: GPL-2.0-or-later
// Where samples look for new lights: densities that add up to 1, reach every light that shines and
// no other, and lean towards power, change and nearness as they are told.
#include "refresh/vkpt/light/exploration.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

namespace vigil {
namespace {

const glm::vec3 far_eye{0.0f, 0.0f, 1e5f}; // so far that all lights are as near

shader::Light light_at(glm::vec3 position, float radiance, float size = 8.0f) {
    return {position, {size, 0, 0}, {0, size, 0}, glm::vec3(radiance), 0};
}

void expect_density(const std::vector<float>& weights, std::span<const shader::Light> lights) {
    ASSERT_EQ(weights.size(), lights.size());
    EXPECT_NEAR(std::accumulate(weights.begin(), weights.end(), 0.0), 1.0, 1e-5);
    for (size_t i = 0; i < weights.size(); ++i) {
        EXPECT_TRUE(std::isfinite(weights[i]));
        EXPECT_EQ(weights[i] > 0.0f, lights[i].radiance != glm::vec3(0.0f)) << i;
    }
}

TEST(Exploration, EnergyIsAreaTimesRadiance) {
    const std::vector<shader::Light> lights{light_at({0, 0, 0}, 1), light_at({50, 0, 0}, 3),
                                            light_at({0, 50, 0}, 1, 16), light_at({9, 9, 0}, 0)};
    const std::vector<float> weights = Exploration().weights(lights, far_eye, {1, 0, 0});
    expect_density(weights, lights);
    EXPECT_NEAR(weights[1] / weights[0], 3.0f, 0.01f);
    EXPECT_NEAR(weights[2] / weights[0], 4.0f, 0.01f);
}

TEST(Exploration, NearLightsByInverseSquare) {
    const std::vector<shader::Light> lights{light_at({100, 0, 0}, 1, 0.1f),
                                            light_at({300, 0, 0}, 1, 0.1f)};
    const std::vector<float> weights = Exploration().weights(lights, {0, 0, 0}, {0, 0, 1});
    expect_density(weights, lights);
    EXPECT_NEAR(weights[0] / weights[1], 9.0f, 0.05f);
}

TEST(Exploration, ChangesCountAndFade) {
    std::vector<shader::Light> lights(10, light_at({0, 0, 0}, 1));
    Exploration exploration;
    expect_density(exploration.weights(lights, far_eye, {1, 1, 0}), lights);
    EXPECT_FALSE(exploration.fading());       // the first frame is no change
    lights[2].v0.x += 1.0f;                   // moves
    lights[3].radiance *= 1.5f;               // brightens
    lights.push_back(light_at({0, 0, 0}, 1)); // appears
    const std::vector<float> changed = exploration.weights(lights, far_eye, {1, 1, 0});
    expect_density(changed, lights);
    EXPECT_TRUE(exploration.fading());
    EXPECT_GT(changed[2], 4.0f * changed[0]);
    EXPECT_GT(changed[3], 2.0f * changed[0]);
    EXPECT_LT(changed[3], changed[2]);
    EXPECT_NEAR(changed[10], changed[2], 1e-4f);
    // While the change fades nothing else happens; in the end only energy is left.
    std::vector<float> weights = changed;
    for (int frame = 0; frame < 20 && exploration.fading(); ++frame)
        weights = exploration.weights(lights, far_eye, {1, 1, 0});
    EXPECT_FALSE(exploration.fading());
    EXPECT_NEAR(weights[2], weights[0], 1e-6f);
}

TEST(Exploration, ALightThatGoesOutIsNotLookedFor) {
    std::vector<shader::Light> lights(3, light_at({0, 0, 0}, 1));
    Exploration exploration;
    exploration.weights(lights, far_eye, {});
    lights[1].radiance = glm::vec3(0.0f);
    expect_density(exploration.weights(lights, far_eye, {}), lights);
}

TEST(Exploration, AnyMixReachesEveryLight) {
    const std::vector<shader::Light> lights{light_at({0, 0, 0}, 1e-20f), light_at({5, 0, 0}, 1e20f),
                                            light_at({0, 5, 0}, 1, 0.0f)};
    for (const ExplorationMix& mix :
         {ExplorationMix{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1e6f, 1e-6f, 1}})
        expect_density(Exploration().weights(lights, {0, 0, 0}, mix), lights);
}

TEST(Exploration, ExtremesStayFinite) {
    const float most = std::numeric_limits<float>::max();
    const std::vector<shader::Light> lights{light_at({0, 0, 0}, most, 1e6f),
                                            light_at({0, 0, 0}, 1e-38f, 1e-6f),
                                            light_at({most, 0, 0}, 1)};
    expect_density(Exploration().weights(lights, {0, 0, 0}, {1, 1, 1}), lights);
    EXPECT_TRUE(Exploration().weights({}, {0, 0, 0}, {1, 1, 1}).empty());
}

} // namespace
} // namespace vigil
