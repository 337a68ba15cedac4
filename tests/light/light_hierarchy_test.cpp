// SPDX-License-Identifier: GPL-2.0-or-later
// What the Light Hierarchy must be, whatever the lights: every light in one leaf, reached by its
// path; boxes and cones that hold all lights below them; no light out of reach that can contribute.
#include "refresh/vkpt/light/light_hierarchy.h"

#include "light_hierarchy_oracle.h"
#include "refresh/vkpt/light/light_power.h"
#include "shared/ltc.h"
#include "shared/random.h"
#include "shared/sampling.h"
#include "statistics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <limits>
#include <map>
#include <set>

namespace vigil::test {
namespace {

using shader::Light;
using shader::NONE;
using shader::Random;

glm::vec3 random_direction(Random& random) {
    return glm::normalize(shader::sample_sphere(shader::random_next2(random)));
}

/// Lamps as levels have them, and some that they should not have.
struct Scene {
    const char* name;
    std::vector<Light> lights;
};

/// Axis-parallel square lamps, two triangles each, on a grid of walls and ceilings.
std::vector<Light> lamps_in_a_hall(uint32_t count) {
    Random random = shader::random_begin({count, 1}, 0, 0);
    std::vector<Light> lights;
    while (lights.size() < count) {
        const glm::vec3 at = glm::floor(glm::vec3(2048, 2048, 256) * shader::random_next3(random));
        const auto axis = static_cast<glm::length_t>(shader::random_next_words(random).x >> 30) % 3;
        glm::vec3 e1(0.0f), e2(0.0f);
        e1[(axis + 1) % 3] = 16.0f;
        e2[(axis + 2) % 3] = shader::random_next(random) < 0.5f ? 8.0f : -8.0f;
        const glm::vec3 radiance = 10.0f * shader::random_next3(random) + 0.1f;
        lights.push_back({at, e1, e2, radiance, 0});
        lights.push_back({at + e1 + e2, -e1, -e2, radiance, 0});
    }
    lights.resize(count);
    return lights;
}

/// Triangles of any direction; sizes, energies and distances over many powers of ten.
std::vector<Light> wild_lights(uint32_t count) {
    Random random = shader::random_begin({count, 2}, 0, 0);
    std::vector<Light> lights;
    for (uint32_t i = 0; i < count; ++i) {
        const auto power = [&](float low, float high) {
            return std::pow(10.0f, low + (high - low) * shader::random_next(random));
        };
        const glm::vec3 at = power(0, 4) * random_direction(random);
        const glm::vec3 e1 = power(-3, 3) * random_direction(random);
        glm::vec3 e2 = power(-3, 3) * random_direction(random);
        if (i % 5 == 0) e2 = 0.3f * e1 + power(-6, -3) * random_direction(random); // a sliver
        lights.push_back({at, e1, e2, glm::vec3(power(-30, 30)), 0});
    }
    return lights;
}

/// Nothing but the same light.
std::vector<Light> same_lights(uint32_t count) {
    return std::vector<Light>(count, {{5, 6, 7}, {1, 0, 0}, {0, 1, 0}, {1, 2, 3}, 0});
}

/// Each so much nearer to the origin than the one before: cuts by area take off a few at a time.
std::vector<Light> nested_lights(float first, float ratio) {
    std::vector<Light> lights;
    float at = first;
    for (int i = 0; i < 250; ++i, at *= ratio)
        lights.push_back({{at, 0, 0}, {0, 0.1f * at, 0}, {0, 0, 0.1f * at}, glm::vec3(1.0f), 0});
    return lights;
}

/// Lights that light nothing, and two among them that do.
std::vector<Light> dead_lights() {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinity = std::numeric_limits<float>::infinity();
    const glm::vec3 x(1, 0, 0), y(0, 1, 0), white(1.0f), black(0.0f);
    return {
        {x, x, y, black, 0},
        {x, x, y, white, 0},
        {x, x, x, white, 0},
        {x, black, y, white, 0},
        {x, black, black, white, 0},
        {x, 2.0f * y, -3.0f * y, white, 0},
        {x, x, y, {nan, 0, 0}, 0},
        {{nan, 0, 0}, x, y, white, 0},
        {{infinity, 0, 0}, x, y, white, 0},
        {x, {0, 0, nan}, y, white, 0},
        {x, {infinity, 0, 0}, y, white, 0},
        {y, y, x, {0, 1e-20f, 0}, 0},
    };
}

std::vector<Scene> scenes() {
    std::vector<Scene> all;
    all.push_back({"none", {}});
    all.push_back(
        {"black", std::vector<Light>(7, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, glm::vec3(0), 0})});
    all.push_back({"one", lamps_in_a_hall(1)});
    all.push_back({"two", lamps_in_a_hall(2)});
    all.push_back({"three", wild_lights(3)});
    all.push_back({"nine", lamps_in_a_hall(9)});
    all.push_back({"hall", lamps_in_a_hall(700)});
    all.push_back({"wild", wild_lights(500)});
    all.push_back({"same", same_lights(300)});
    all.push_back({"nested", nested_lights(8192.0f, 0.93f)});
    all.push_back({"dead", dead_lights()});
    return all;
}

HierarchyWords words_of(const LightHierarchy& hierarchy) {
    return {hierarchy.header(), hierarchy.nodes(), hierarchy.leaf_lights(), hierarchy.places(),
            hierarchy.parents()};
}

bool shines(const Light& light) {
    const double area = glm::length(glm::cross(glm::dvec3(light.e1), glm::dvec3(light.e2)));
    const glm::dvec3 corner = glm::dvec3(light.v0);
    return area > 0.0 && std::isfinite(area) && std::isfinite(glm::dot(corner, corner)) &&
           shader::luminance(light.radiance) > 0.0f;
}

class LightHierarchyOf : public testing::TestWithParam<std::array<uint32_t, 2>> {
protected:
    LightHierarchyOptions options() const { return {GetParam()[0], GetParam()[1]}; }
};

TEST_P(LightHierarchyOf, HasEveryLightOnceAndItsPath) {
    LightHierarchy hierarchy;
    for (const Scene& scene : scenes()) {
        SCOPED_TRACE(scene.name);
        hierarchy.build(scene.lights, options());
        const HierarchyWords words = words_of(hierarchy);
        const uint32_t stride = shader::light_node_stride(words.header.groups);
        ASSERT_EQ(words.nodes.size(), size_t{words.header.node_count} * stride);
        ASSERT_EQ(words.parents.size(), words.header.node_count);
        ASSERT_EQ(words.places.size(), scene.lights.size());
        std::vector<uint32_t> met(scene.lights.size(), 0);
        uint32_t next_node = 1, leaves = 0;
        for (uint32_t node = 0; node < words.header.node_count; ++node) {
            const std::vector<OracleChild> children = decode_children(words, node);
            EXPECT_LE(children.size(), options().width);
            EXPECT_GE(children.size(), node == 0 ? 1u : 2u);
            for (const OracleChild& child : children) {
                const uint32_t edge = node * 4 * words.header.groups + child.number;
                if (child.inner) {
                    EXPECT_EQ(child.node, next_node++);
                    EXPECT_EQ(words.parents[child.node], edge);
                    continue;
                }
                ++leaves;
                const std::vector<uint32_t> ids = lights_of_leaf(words, child);
                EXPECT_GE(ids.size(), 1u);
                for (uint32_t i = 0; i < ids.size(); ++i) {
                    ASSERT_LT(ids[i], met.size());
                    ++met[ids[i]];
                    EXPECT_EQ(words.places[ids[i]], edge * words.header.leaf_size + i);
                }
            }
        }
        EXPECT_EQ(next_node, std::max(words.header.node_count, 1u));
        // Nodes are well filled: every one but the root takes a place and gives `width`.
        const uint32_t fewest = leaves / (options().width - 1) + 1;
        EXPECT_LE(words.header.node_count, 2 * fewest);
        uint32_t count = 0;
        for (uint32_t id = 0; id < met.size(); ++id) {
            const bool there = shines(scene.lights[id]);
            EXPECT_EQ(met[id], there ? 1u : 0u) << "light " << id;
            EXPECT_EQ(words.places[id] != NONE, there) << "light " << id;
            count += there;
        }
        EXPECT_EQ(words.header.light_count, count);
        if (count > 0) {
            EXPECT_EQ(words.parents[0], NONE);
        }
    }
}

TEST_P(LightHierarchyOf, HoldsItsLightsInBoxesAndCones) {
    LightHierarchy hierarchy;
    for (const Scene& scene : scenes()) {
        SCOPED_TRACE(scene.name);
        hierarchy.build(scene.lights, options());
        const HierarchyWords words = words_of(hierarchy);
        for (uint32_t id = 0; id < scene.lights.size(); ++id) {
            if (words.places[id] == NONE) continue;
            const Light& light = scene.lights[id];
            const glm::dvec3 v0(light.v0), e1(light.e1), e2(light.e2);
            const glm::dvec3 normal = glm::normalize(glm::cross(e1, e2));
            const uint32_t slots = 4 * words.header.groups;
            double energy_below = 0.0; // of the child one level below
            uint32_t edge = words.places[id] / words.header.leaf_size;
            for (uint32_t level = 0; edge != NONE; ++level) {
                ASSERT_LT(level, 100u);
                const uint32_t node = edge / slots;
                for (const OracleChild& child : decode_children(words, node)) {
                    if (child.number != edge % slots) continue;
                    for (const glm::dvec3& corner : {v0, v0 + e1, v0 + e2}) {
                        ASSERT_TRUE(glm::all(glm::lessThanEqual(child.lower, corner)));
                        ASSERT_TRUE(glm::all(glm::greaterThanEqual(child.upper, corner)));
                    }
                    // Shaders leave out 2e-7; see LIGHT_NODE_SLACK.
                    const double away = glm::length(normal - glm::normalize(child.axis));
                    ASSERT_LE(away, child.spread + 2e-7) << "light " << id << " level " << level;
                    ASSERT_NEAR(glm::length(child.axis), 1.0, 0.01);
                    ASSERT_GT(child.energy, 0.0);
                    ASSERT_LE(child.energy, 1.0);
                    energy_below = child.energy;
                }
                edge = words.parents[node];
            }
            EXPECT_GT(energy_below, 0.0);
        }
    }
}

/// The shares that the shader's own arithmetic, on the host, gives a light on its way to the root.
struct Path {
    double probability = 1.0;
    bool cut = false;   // some share is 0
    bool finite = true; // all importances and sums are
};

Path path_of(const HierarchyWords& words, uint32_t light, glm::vec3 position, glm::vec3 normal) {
    Path path;
    const uint32_t slots = 4 * words.header.groups;
    uint32_t edge = words.places[light] / words.header.leaf_size;
    while (edge != NONE) {
        const uint32_t at = edge / slots * shader::light_node_stride(words.header.groups);
        const shader::LightNode node = shader::light_node(words.nodes[at]);
        glm::vec4 importance[2] = {glm::vec4(0.0f), glm::vec4(0.0f)};
        for (uint32_t group = 0; group < words.header.groups; ++group)
            importance[group] = shader::light_group_importance(
                node, words.nodes[at + 3 * group + 1], words.nodes[at + 3 * group + 2],
                words.nodes[at + 3 * group + 3], position, normal);
        const shader::LightNodeWeights weights =
            shader::light_node_weights(importance[0], importance[1]);
        const float weight = shader::light_node_weight(weights, edge % slots);
        const float sum = shader::light_node_sum(weights);
        path.finite &= std::isfinite(sum) && weight <= sum && weight >= 0.0f;
        path.cut |= !(weight > 0.0f);
        path.probability *= static_cast<double>(weight / sum);
        edge = words.parents[edge / slots];
    }
    return path;
}

TEST_P(LightHierarchyOf, ReachesWhateverCanContribute) {
    LightHierarchy hierarchy;
    for (const Scene& scene : scenes()) {
        SCOPED_TRACE(scene.name);
        hierarchy.build(scene.lights, options());
        const HierarchyWords words = words_of(hierarchy);
        Random random = shader::random_begin({7, 7}, 0, 0);
        uint32_t contributing = 0;
        for (uint32_t i = 0; i < 400 && !scene.lights.empty(); ++i) {
            // Near some light or on it, in its plane or anywhere; facing its plane, along it or
            // anywhere.
            const uint32_t chosen =
                shader::random_next_words(random).x % static_cast<uint32_t>(scene.lights.size());
            const Light& near = scene.lights[chosen];
            if (!shines(near)) continue;
            const glm::vec2 at = 3.0f * shader::random_next2(random) - 1.0f;
            const glm::vec3 light_normal = shader::light_normal(near);
            glm::vec3 position = near.v0 + at.x * near.e1 + at.y * near.e2;
            glm::vec3 normal = random_direction(random);
            const uint32_t kind = i % 8;
            if (kind & 1) position += random_direction(random) * (kind & 2 ? 1e-3f : 30.0f);
            if (kind & 4) normal = kind & 1 ? -light_normal : light_normal;
            if (i % 3 == 0) position = shader::offset_ray_origin(position, normal);
            const shader::LtcSurface surface = shader::ltc_prepare_diffuse(position, normal, 0.5f);
            // All lights of small scenes, others in turn; and always the one that is near.
            const auto count = static_cast<uint32_t>(scene.lights.size());
            const uint32_t stride = std::max(count / 16, 1u);
            for (uint32_t k = i % stride; k < count + stride; k += stride) {
                const uint32_t id = k < count ? k : chosen;
                if (words.places[id] == NONE) continue;
                const Path path = path_of(words, id, position, normal);
                ASSERT_TRUE(path.finite) << "surface " << i << " light " << id;
                if (!(shader::ltc_importance(surface, scene.lights[id], false) > 0.0f)) continue;
                ++contributing;
                ASSERT_FALSE(path.cut) << "surface " << i << " light " << id;
            }
        }
        if (words.header.light_count > 7) {
            EXPECT_GT(contributing, 200u);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Shapes, LightHierarchyOf,
                         testing::Values(std::array{8u, 2u}, std::array{8u, 1u}, std::array{4u, 2u},
                                         std::array{2u, 1u}, std::array{3u, 5u},
                                         std::array{5u, 16u}, std::array{7u, 3u}),
                         [](const auto& shape) {
                             return fmt::format("Width{}Leaf{}", shape.param[0], shape.param[1]);
                         });

TEST(LightHierarchy, SharesAddUpAndPreferWhatMatters) {
    // Two groups of lamps, one near and one far, of equal energy: shares follow the squared
    // distance.
    std::vector<Light> lights;
    for (const float z : {100.0f, 1000.0f})
        for (int i = 0; i < 64; ++i)
            lights.push_back(
                {{0.01f * static_cast<float>(i), 0, z}, {0, 1, 0}, {1, 0, 0}, glm::vec3(1.0f), 0});
    LightHierarchy hierarchy;
    hierarchy.build(lights, {});
    const HierarchyWords words = words_of(hierarchy);
    double near = 0.0, far = 0.0;
    for (uint32_t id = 0; id < lights.size(); ++id)
        (id < 64 ? near : far) += path_of(words, id, {0, 0, 0}, {0, 0, 1}).probability / 2.0;
    // Leaves of two lights: each was counted for both.
    EXPECT_NEAR(near + far, 1.0, 0.02);
    EXPECT_NEAR(near / far, 100.0, 10.0);
}

TEST(LightHierarchy, OracleAgreesWithTheShadersArithmetic) {
    for (const LightHierarchyOptions options : {LightHierarchyOptions{8, 1}, {3, 1}}) {
        const std::vector<Light> lights = lamps_in_a_hall(700);
        LightHierarchy hierarchy;
        hierarchy.build(lights, options);
        const HierarchyWords words = words_of(hierarchy);
        Random random = shader::random_begin({9, 9}, 0, 0);
        uint32_t judged = 0;
        for (uint32_t i = 0; i < 300; ++i) {
            const shader::LtcSurface surface = shader::ltc_prepare_diffuse(
                glm::vec3(2048, 2048, 256) * shader::random_next3(random), random_direction(random),
                0.5f);
            const OracleProbabilities oracle = oracle_probabilities(words, lights, surface);
            if (oracle.doubtful) continue;
            ++judged;
            double sum = 0.0;
            for (uint32_t id = 0; id < lights.size(); ++id) {
                sum += oracle.by_light[id];
                if (shader::ltc_importance(surface, lights[id], true) > 0.0f) {
                    const double own =
                        path_of(words, id, surface.position, surface.normal).probability;
                    ASSERT_NEAR(own / oracle.by_light[id], 1.0, 1e-3) << i << " " << id;
                } else {
                    ASSERT_EQ(oracle.by_light[id], 0.0);
                }
            }
            EXPECT_LT(sum, 1.0 + 1e-9);
        }
        EXPECT_GT(judged, 250u);
    }
}

TEST(LightHierarchy, DrawsChildrenByTheirWeights) {
    Random random = shader::random_begin({3, 3}, 0, 0);
    constexpr uint32_t draws = 20000;
    for (uint32_t trial = 0; trial < 50; ++trial) {
        glm::vec4 importance[2];
        for (uint32_t i = 0; i < 8; ++i) {
            const glm::vec3 u = shader::random_next3(random);
            importance[i / 4][static_cast<glm::length_t>(i % 4)] =
                u.x < 0.3f ? 0.0f : std::pow(10.0f, 6.0f * u.y - 3.0f);
        }
        const shader::LightNodeWeights weights =
            shader::light_node_weights(importance[0], importance[1]);
        const float sum = shader::light_node_sum(weights);
        if (!(sum > 0.0f)) continue;
        std::vector<uint64_t> counts(8, 0);
        for (uint32_t draw = 0; draw < draws; ++draw)
            ++counts[shader::light_node_choose(weights, sum * shader::random_next(random)).child];
        std::vector<uint64_t> seen;
        std::vector<double> shares;
        for (uint32_t i = 0; i < 8; ++i) {
            const float weight = shader::light_node_weight(weights, i);
            // A share of its own for what may contribute, none for what may not.
            EXPECT_EQ(weight > 0.0f, importance[i / 4][static_cast<glm::length_t>(i % 4)] > 0.0f);
            if (weight == 0.0f) {
                EXPECT_EQ(counts[i], 0u);
            } else {
                EXPECT_GT(weight / sum, 1.0f / 4200.0f / 8.0f);
                seen.push_back(counts[i]);
                shares.push_back(static_cast<double>(weight / sum));
            }
        }
        if (seen.size() > 1) {
            EXPECT_LT(chi_square_z(seen, shares), z_limit) << "trial " << trial;
        }
        // The ends of the range.
        const float ends[] = {0.0f, sum, std::nextafter(sum, 2.0f * sum)};
        for (const float target : ends)
            EXPECT_GT(shader::light_node_weight(weights,
                                                shader::light_node_choose(weights, target).child),
                      0.0f);
    }
}

TEST(LightHierarchy, TheSameLightsGiveTheSameNodes) {
    const std::vector<Light> lights = lamps_in_a_hall(20000); // enough to be built by two threads
    LightHierarchy first, second;
    second.build(wild_lights(50), {3, 4}); // what was there before leaves no trace
    first.build(lights, {});
    second.build(lights, {});
    EXPECT_TRUE(std::ranges::equal(first.nodes(), second.nodes()));
    EXPECT_TRUE(std::ranges::equal(first.leaf_lights(), second.leaf_lights()));
    EXPECT_TRUE(std::ranges::equal(first.places(), second.places()));
    EXPECT_TRUE(std::ranges::equal(first.parents(), second.parents()));
}

/// Steps from the root to a light, at most and on average.
std::pair<uint32_t, double> depth_of(const HierarchyWords& words) {
    uint32_t deepest = 0;
    double sum = 0.0;
    for (const uint32_t place : words.places) {
        if (place == NONE) continue;
        uint32_t depth = 0;
        for (uint32_t edge = place / words.header.leaf_size; edge != NONE;
             edge = words.parents[edge / (4 * words.header.groups)])
            ++depth;
        deepest = std::max(deepest, depth);
        sum += depth;
    }
    return {deepest, sum / words.header.light_count};
}

TEST(LightHierarchy, StaysShallowForManyLights) {
    LightHierarchy hierarchy;
    hierarchy.build(lamps_in_a_hall(100000), {});
    const HierarchyWords words = words_of(hierarchy);
    EXPECT_EQ(words.header.light_count, 100000u);
    // 50,000 leaves of two lights would fill 7,143 nodes of eight children, six levels of them.
    EXPECT_LT(words.header.node_count, 14000u);
    const auto [deepest, mean] = depth_of(words);
    EXPECT_LT(mean, 7.5);
    EXPECT_LE(deepest, 12u);
}

TEST(LightHierarchy, DepthIsBoundedForTheWorstLights) {
    LightHierarchy hierarchy;
    for (const std::vector<Light>& lights : {nested_lights(1e30f, 0.5f), same_lights(100000)}) {
        hierarchy.build(lights, {2, 1});
        const auto [deepest, mean] = depth_of(words_of(hierarchy));
        EXPECT_LE(deepest, 64u + 17u);
        EXPECT_LE(mean, deepest);
    }
}

TEST(LightHierarchy, WorkOfABuildIsBounded) {
    // A light is looked at once in every node above it.
    LightTree tree;
    tree.build(lamps_in_a_hall(50000), 2);
    uint64_t passed = 0;
    std::vector<uint32_t> open{0};
    while (!open.empty()) {
        const LightTreeNode& node = tree.nodes()[open.back()];
        const uint32_t number = open.back();
        open.pop_back();
        passed += node.count;
        if (node.right == 0) continue;
        EXPECT_EQ(tree.nodes()[number + 1].first, node.first);
        EXPECT_EQ(tree.nodes()[node.right].first + tree.nodes()[node.right].count,
                  node.first + node.count);
        open.push_back(number + 1);
        open.push_back(node.right);
    }
    EXPECT_LT(static_cast<double>(passed), 1.6 * 50000 * std::log2(50000.0));
}

TEST(LightHierarchy, EnergiesAreRightToAnEighth) {
    for (int step = 0; step <= 240; ++step) {
        const float energy = std::exp2(-0.25f * static_cast<float>(step));
        const float tiny = std::ldexp(1.0f, -100);
        // Lights in one place, which share a node: one has an energy of 1.
        std::vector<Light> lights = same_lights(3);
        const float unit = light_power(lights[0]);
        lights[0].radiance /= unit;
        lights[1].radiance *= energy / unit;
        lights[2].radiance *= tiny / unit;
        LightHierarchy hierarchy;
        hierarchy.build(lights, {8, 1});
        for (const OracleChild& child : decode_children(words_of(hierarchy), 0)) {
            const uint32_t id = lights_of_leaf(words_of(hierarchy), child)[0];
            // What is smaller than that is not lost.
            const double expected[] = {1.0, static_cast<double>(energy), std::ldexp(1.0, -65)};
            EXPECT_NEAR(child.energy / expected[id], 1.0, id == 1 ? 0.126 : 1e-6);
        }
    }
}

} // namespace
} // namespace vigil::test
