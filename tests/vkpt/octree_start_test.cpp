// SPDX-License-Identifier: GPL-2.0-or-later
// The octree before the first frame: a tree as the passes make them, fine where samples are
// expected.
#include "refresh/vkpt/guiding/octree_start.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numeric>

namespace vigil::vkpt {
namespace {

using shader::BvhTriangle;

/// The floor of a hall, 4096 units wide, as two triangles.
std::vector<BvhTriangle> hall() {
    BvhTriangle one{}, two{};
    one.v0 = {-2048, -2048, -64};
    one.e1 = {4096, 0, 0};
    one.e2 = {0, 4096, 0};
    two.v0 = {2048, 2048, -64};
    two.e1 = {-4096, 0, 0};
    two.e2 = {0, -4096, 0};
    return {one, two};
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

TEST(SurfacePoints, StandForTheAreaOfAllTriangles) {
    std::vector<BvhTriangle> triangles = hall();
    triangles.push_back({});                // no area
    triangles.push_back(triangles.front()); // no finite one
    triangles.back().e1.x = std::numeric_limits<float>::quiet_NaN();
    BvhTriangle small{};
    small.e1 = {1, 0, 0};
    small.e2 = {0, 1, 0};
    triangles.push_back(small);
    const std::vector<SurfacePoint> points = surface_points(triangles, 1000);
    EXPECT_NEAR(static_cast<double>(points.size()), 1001.0, 3.0);
    double area = 0.0;
    glm::dvec3 mean(0.0);
    for (const SurfacePoint& point : points) {
        area += static_cast<double>(point.area);
        mean += glm::dvec3(point.position) * static_cast<double>(point.area);
    }
    EXPECT_NEAR(area, 4096.0 * 4096.0 + 0.5, 10.0);
    EXPECT_NEAR(mean.x / area, 0.0, 20.0);
    EXPECT_NEAR(mean.y / area, 0.0, 20.0);
    EXPECT_NEAR(mean.z / area, -64.0, 1e-2);
}

TEST(OctreeStart, WithoutSurfacesIsTheRoot) {
    const OctreeStart start = start_octree({}, needs());
    ASSERT_EQ(start.nodes.size(), 1u);
    EXPECT_EQ(start.nodes[0] & 0xffu, shader::OCTREE_ALL_LEAVES);
    EXPECT_EQ(start.leaf_counts, std::vector<uint32_t>(8));
}

TEST(OctreeStart, IsFineWhereSamplesAreExpected) {
    const OctreeNeeds asked = needs();
    const std::vector<SurfacePoint> points = surface_points(hall(), 1u << 16);
    const OctreeStart start = start_octree(points, asked);
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
    OctreeNeeds asked = needs();
    const std::vector<SurfacePoint> points = surface_points(hall(), 1u << 16);
    asked.eye = {1900, 1900, 0};
    const OctreeStart start = start_octree(points, asked);
    EXPECT_GT(leaf_at(start, asked, {1900, 1900, -64}).depth,
              leaf_at(start, asked, {0, 0, -64}).depth);
}

TEST(OctreeStart, HoldsNoMoreNodesThanItMay) {
    OctreeNeeds asked = needs();
    asked.most_nodes = 50;
    const OctreeStart start = start_octree(surface_points(hall(), 1u << 16), asked);
    EXPECT_EQ(start.nodes.size(), 50u);
}

TEST(OctreeStart, EndsWhereAllSurfacesAreOnePoint) {
    const std::vector<SurfacePoint> points(100, {glm::vec3(5.0f), 1.0f});
    const OctreeStart start = start_octree(points, needs());
    EXPECT_EQ(start.nodes.size(), shader::OCTREE_MAX_DEPTH);
}

// A leaf has samples or none, whatever the eye is.
TEST(OctreeStart, StandsAnEyeThatIsNowhere) {
    const std::vector<SurfacePoint> points = surface_points(hall(), 1000);
    for (const float nowhere :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), 1e30f}) {
        OctreeNeeds asked = needs();
        asked.eye = glm::vec3(nowhere);
        const OctreeStart start = start_octree(points, asked);
        for (const uint32_t count : start.leaf_counts)
            EXPECT_LE(count, 60000u);
    }
}

} // namespace
} // namespace vigil::vkpt
