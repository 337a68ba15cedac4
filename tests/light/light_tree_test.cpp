// SPDX-License-Identifier: GPL-2.0-or-later
// What a node of the light tree says of its lights: their energies, normals and boxes, added up.
// Shares of draws follow the energies, so a few percent that are lost on the way cost variance that
// no other test sees.
#include "refresh/vkpt/light/light_power.h"
#include "refresh/vkpt/light/light_tree.h"
#include "shared/random.h"
#include "shared/sampling.h"

#include <cmath>
#include <gtest/gtest.h>
#include <vector>

namespace vigil {
namespace {

/// Triangles of any direction, of sizes and radiances over two powers of ten each.
std::vector<shader::Light> some_lights(int count) {
    shader::Random random = shader::random_begin({count, 3}, 0, 0);
    const auto direction = [&] { return shader::sample_sphere(shader::random_next2(random)); };
    const auto power = [&] { return std::pow(10.0f, 2.0f * shader::random_next(random)); };
    std::vector<shader::Light> lights;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 at = 1000.0f * shader::random_next3(random);
        const float size = power();
        lights.push_back({at, size * direction(), size * direction(),
                          power() * (0.1f + shader::random_next3(random)), 0});
    }
    return lights;
}

class LightTreeOf : public testing::TestWithParam<int> {
protected:
    void SetUp() override {
        lights_ = some_lights(GetParam());
        tree_.build(lights_, 2);
    }

    /// Calls visit for every node that is in use.
    template <typename Visit> void for_each_node(Visit visit) const {
        std::vector<uint32_t> open{0};
        while (!open.empty()) {
            const uint32_t number = open.back();
            open.pop_back();
            const LightTreeNode& node = tree_.nodes()[number];
            visit(node, tree_.lights().subspan(node.first, node.count));
            if (node.right != 0) open.insert(open.end(), {number + 1, node.right});
        }
    }

    std::vector<shader::Light> lights_;
    LightTree tree_;
};

TEST_P(LightTreeOf, EnergiesAreThePowersOfTheirLights) {
    for_each_node([&](const LightTreeNode& node, std::span<const TreeLight> below) {
        double energy = 0.0;
        for (const TreeLight& light : below) {
            const float power = light_power(lights_[light.id]);
            ASSERT_FLOAT_EQ(light.energy, power);
            energy += static_cast<double>(power);
        }
        ASSERT_NEAR(static_cast<double>(node.energy) / energy, 1.0, 1e-5) << node.count;
    });
}

TEST_P(LightTreeOf, NormalsAndBoxesAreThoseOfTheirLights) {
    for_each_node([](const LightTreeNode& node, std::span<const TreeLight> below) {
        glm::vec3 lower = below.front().lower, upper = below.front().upper;
        glm::dvec3 sum(0.0);
        for (const TreeLight& light : below) {
            lower = glm::min(lower, light.lower);
            upper = glm::max(upper, light.upper);
            sum += glm::dvec3(light.normal);
        }
        ASSERT_EQ(node.lower, lower);
        ASSERT_EQ(node.upper, upper);
        ASSERT_LT(glm::length(glm::dvec3(node.normal_sum) - sum), 1e-5 * node.count);
    });
}

INSTANTIATE_TEST_SUITE_P(Counts, LightTreeOf, testing::Values(1, 2, 3, 500, 6000),
                         [](const auto& count) { return "Of" + std::to_string(count.param); });

TEST(LightPower, IsAreaTimesLuminance) {
    // A right triangle with legs of 6 and 8; Rec. 709 weighs red, green and blue so.
    const shader::Light light{{1, 2, 3}, {6, 0, 0}, {0, 0, 8}, {1, 0, 0}, 0};
    EXPECT_FLOAT_EQ(light_power(light), 24.0f * 0.2126f);
    shader::Light green = light, blue = light;
    green.radiance = {0, 10, 0};
    blue.radiance = {0, 0, 100};
    EXPECT_FLOAT_EQ(light_power(green), 240.0f * 0.7152f);
    EXPECT_FLOAT_EQ(light_power(blue), 2400.0f * 0.0722f);
}

} // namespace
} // namespace vigil
