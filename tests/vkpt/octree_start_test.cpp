// SPDX-License-Identifier: GPL-2.0-or-later
// The octree before the first frame: a tree as the passes make them, fine where samples are
// expected.
#include "refresh/vkpt/guiding/octree_start.h"

#include "shared/random.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <numeric>

namespace vigil::vkpt {
namespace {

/// Places on the floor of a hall, 4096 units wide, as an eye 64 units above `below` sees them.
std::vector<glm::vec3> hall(glm::vec2 below) {
    std::vector<glm::vec3> places;
    shader::Random random = shader::random_begin(glm::uvec2(3, 5), 0, 0);
    while (places.size() < 1u << 14) {
        const glm::vec3 u = shader::random_next3(random);
        const glm::vec2 at = 4096.0f * glm::vec2(u) - 2048.0f;
        const float along = glm::distance(at, below);
        if (u.z * (along * along + 4096.0f) < 4096.0f) places.emplace_back(at, -64.0f);
    }
    return places;
}

OctreeNeeds needs() {
    OctreeNeeds needs;
    needs.corner = glm::vec3(-2100.0f);
    needs.scale = static_cast<float>(shader::octree_cell_size(0)) / 4200.0f;
    needs.samples = 60000.0f;
    needs.split = 40;
    needs.most_nodes = 4000;
    return needs;
}

/// The leaf with a position, and how deep it lies.
shader::OctreeDescent leaf_at(const OctreeStart& start, const OctreeNeeds& needs, glm::vec3 place) {
    const glm::uvec3 grid = shader::octree_grid(place, needs.corner, needs.scale);
    shader::OctreeDescent descent = shader::octree_root();
    while (descent.leaf == shader::NONE)
        shader::octree_descend(descent, start.nodes.at(descent.node), grid);
    return descent;
}

TEST(OctreeStart, WithoutPlacesIsTheRoot) {
    const OctreeStart start = start_octree({}, needs());
    ASSERT_EQ(start.nodes.size(), 1u);
    EXPECT_EQ(start.nodes[0] & 0xffu, shader::OCTREE_ALL_LEAVES);
    EXPECT_EQ(start.leaf_counts, std::vector<uint32_t>(8));
}

TEST(OctreeStart, IsFineWhereSamplesAreExpected) {
    const OctreeNeeds asked = needs();
    const OctreeStart start = start_octree(hall({0, 0}), asked);
    ASSERT_EQ(start.cells.size(), start.nodes.size());
    ASSERT_EQ(start.leaf_counts.size(), 8 * start.nodes.size());
    EXPECT_LT(start.nodes.size(), asked.most_nodes);
    // Breadth first, each cell that of its place in the tree.
    uint32_t next = 1;
    for (uint32_t node = 0; node < start.nodes.size(); ++node) {
        const shader::OctreeCell cell = shader::octree_unpack_cell(start.cells[node]);
        for (uint32_t child = 0; child < 8; ++child) {
            const uint32_t leaf = shader::octree_leaf(node, child);
            if (shader::octree_is_leaf(start.nodes[node], child)) {
                if (cell.depth + 1 < shader::OCTREE_MAX_DEPTH) {
                    EXPECT_LE(start.leaf_counts[leaf], asked.split) << leaf;
                }
                continue;
            }
            EXPECT_EQ(start.leaf_counts[leaf], 0u) << "an inner node";
            const uint32_t inner = shader::octree_inner_child(start.nodes[node], child);
            ASSERT_EQ(inner, next++);
            EXPECT_EQ(start.cells[inner],
                      shader::octree_pack_cell(shader::octree_child_cell(cell, child)));
        }
    }
    EXPECT_EQ(next, start.nodes.size());
    // As fine as that asks for, and no finer.
    EXPECT_GT(start.nodes.size(), 600u);
    EXPECT_LT(start.nodes.size(), 2300u);
    // Counts are rounded down.
    const double sum = std::accumulate(start.leaf_counts.begin(), start.leaf_counts.end(), 0.0);
    EXPECT_LE(sum, 60000.0);
    EXPECT_GT(sum, 55000.0);
    const uint32_t near = leaf_at(start, asked, {0, 0, -64}).depth;
    const uint32_t far = leaf_at(start, asked, {2000, 2000, -64}).depth;
    EXPECT_GE(near, far + 3u) << "at 30 times the distance";
}

TEST(OctreeStart, FollowsTheEye) {
    const OctreeStart start = start_octree(hall({1900, 1900}), needs());
    EXPECT_GT(leaf_at(start, needs(), {1900, 1900, -64}).depth,
              leaf_at(start, needs(), {0, 0, -64}).depth);
}

TEST(OctreeStart, HoldsNoMoreNodesThanItMay) {
    OctreeNeeds asked = needs();
    asked.most_nodes = 50;
    const OctreeStart start = start_octree(hall({0, 0}), asked);
    EXPECT_EQ(start.nodes.size(), 50u);
}

TEST(OctreeStart, IsNoFinerThanPlacesTell) {
    OctreeNeeds asked = needs();
    asked.samples = 1e9f;
    const std::vector<glm::vec3> places{{5, 5, 5}, {6, 5, 5}, {5, 6, 5}};
    EXPECT_EQ(start_octree(places, asked).nodes.size(), 1u);
}

TEST(OctreeStart, EndsWhereAllPlacesAreOnePoint) {
    const std::vector<glm::vec3> places(100, glm::vec3(5.0f));
    const OctreeStart start = start_octree(places, needs());
    EXPECT_EQ(start.nodes.size(), shader::OCTREE_MAX_DEPTH);
}

} // namespace
} // namespace vigil::vkpt
