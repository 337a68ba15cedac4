// SPDX-License-Identifier: GPL-2.0-or-later
// The threaded top level: following or skipping reaches exactly the instances whose boxes a ray
// enters.
#include "refresh/vkpt/scene/top_level.h"
#include "trace_scenes.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include <set>

namespace vigil::test {
namespace {

std::vector<TopLevelInstance> random_instances(std::uint32_t count, std::uint32_t seed) {
    std::mt19937 engine(seed);
    std::uniform_real_distribution<float> place(-2000.0f, 2000.0f);
    std::uniform_real_distribution<float> angle(0.0f, 6.28f);
    std::vector<TopLevelInstance> instances(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        instances[i].object_bounds.grow(glm::vec3(-16.0f, -8.0f, 0.0f));
        instances[i].object_bounds.grow(glm::vec3(16.0f, 8.0f, 56.0f));
        glm::mat4 m =
            glm::translate(glm::mat4(1.0f), {place(engine), place(engine), place(engine)});
        m = glm::rotate(m, angle(engine), glm::normalize(glm::vec3(1.0f, 2.0f, angle(engine))));
        instances[i].world_from_object = glm::mat4x3(m);
        instances[i].object_from_world = glm::mat4x3(glm::inverse(m));
        instances[i].bvh_root = 7 * i;
        instances[i].instance = i + 1;
    }
    return instances;
}

/// Instances visited by the walk of trace_bvh.glsl.
std::set<std::uint32_t> visit(const std::vector<shader::TopNode>& nodes, const shader::Ray& ray) {
    std::set<std::uint32_t> visited;
    const glm::vec3 inverse = shader::bvh_reciprocal3(ray.direction);
    for (std::uint32_t next = 0; next != shader::TOP_END;) {
        const shader::TopNode& node = nodes.at(next);
        const bool enters = shader::bvh_box_entry(node.lower, node.upper, ray.origin, inverse,
                                                  ray.t_min, ray.t_max) < 3e38f;
        const bool leaf = enters && node.instance != shader::NONE;
        if (leaf) {
            EXPECT_TRUE(visited.insert(node.instance).second);
            EXPECT_EQ(node.root, 7 * (node.instance - 1));
        }
        next = enters && !leaf ? next + 1 : node.skip;
    }
    return visited;
}

TEST(TopLevel, VisitsWhatTheRayEnters) {
    const auto instances = random_instances(500, 1);
    const auto nodes = build_top_level(instances);
    EXPECT_EQ(nodes.size(), 2 * instances.size() - 1);
    Bounds scene;
    scene.grow(glm::vec3(-2000.0f));
    scene.grow(glm::vec3(2000.0f));
    for (const shader::Ray& ray : random_rays(2000, scene, 2)) {
        const auto visited = visit(nodes, ray);
        const glm::vec3 inverse = shader::bvh_reciprocal3(ray.direction);
        for (const TopLevelInstance& instance : instances) {
            const Bounds box = transform_bounds(instance.object_bounds, instance.world_from_object);
            if (shader::bvh_box_entry(box.lower, box.upper, ray.origin, inverse, ray.t_min,
                                      ray.t_max) < 3e38f) {
                EXPECT_TRUE(visited.contains(instance.instance));
            }
        }
        EXPECT_LT(visited.size(), instances.size() / 4);
    }
}

TEST(TopLevel, NoneAndOne) {
    const shader::Ray ray{{0, 0, 0}, 0.0f, {1, 0, 0}, 1e30f};
    const auto none = build_top_level({});
    ASSERT_EQ(none.size(), 1u);
    EXPECT_TRUE(visit(none, ray).empty());

    std::vector<TopLevelInstance> one(1);
    one[0].object_bounds.grow(glm::vec3(10.0f, -1.0f, -1.0f));
    one[0].object_bounds.grow(glm::vec3(11.0f, 1.0f, 1.0f));
    one[0].instance = 1;
    EXPECT_EQ(visit(build_top_level(one), ray).size(), 1u);

    one[0].object_bounds = Bounds{}; // a model without triangles
    EXPECT_TRUE(visit(build_top_level(one), ray).empty());
}

} // namespace
} // namespace vigil::test
