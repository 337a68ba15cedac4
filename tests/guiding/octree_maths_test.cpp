// SPDX-License-Identifier: GPL-2.0-or-later
// The octree's pure maths (shared/octree.h): packing, numbering, and the way from a position to a
// cell. The passes that use it are tested on the GPU.
#include "dice.h"
#include "octree_oracle.h"
#include "shared/octree.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

namespace vigil::test {
namespace {

using namespace shader;

constexpr uint last_cell = (1u << OCTREE_MAX_DEPTH) - 1u;

TEST(OctreeNode, LeavesAndInnerChildrenAreFoundForEveryMask) {
    for (const uint first : {0u, 1u, 12345u, 0xffffffu - 7u})
        for (uint mask = 0; mask < 256; ++mask) {
            const uint node = octree_node(mask, first);
            uint next = first;
            for (uint child = 0; child < 8; ++child) {
                const bool leaf = (mask >> child & 1u) == 1u;
                ASSERT_EQ(octree_is_leaf(node, child), leaf) << mask << ' ' << child;
                if (leaf) continue;
                ASSERT_EQ(octree_inner_child(node, child), next) << mask << ' ' << child;
                ++next;
            }
        }
}

TEST(OctreeNode, LeavesOfDifferentParentsHaveDifferentNumbers) {
    uint expected = 0;
    for (uint node = 0; node < 100; ++node)
        for (uint child = 0; child < 8; ++child)
            EXPECT_EQ(octree_leaf(node, child), expected++);
}

TEST(OctreeGrid, BordersBelongToTheUpperCell) {
    const vec3 corner(-1024.0f, 512.0f, 0.0f);
    const float scale = 16.0f; // a power of two: everything below is exact
    for (const uint cell : {0u, 1u, 2u, 1000u, 32767u, 32768u, last_cell}) {
        const vec3 border = corner + vec3(static_cast<float>(cell) / scale);
        const vec3 inside = border + vec3(0.5f / scale);
        EXPECT_EQ(octree_grid(border, corner, scale), uvec3(cell)) << cell;
        EXPECT_EQ(octree_grid(inside, corner, scale), uvec3(cell)) << cell;
    }
}

TEST(OctreeGrid, AxesAreIndependent) {
    EXPECT_EQ(octree_grid(vec3(1.5f, 200.0f, 30000.0f), vec3(0.0f), 1.0f), uvec3(1, 200, 30000));
}

TEST(OctreeGrid, PositionsOutsideCountAsTheOutermostCells) {
    const vec3 corner(100.0f);
    for (const float far : {1.0f, 1e3f, 1e9f, 1e30f, std::numeric_limits<float>::max(),
                            std::numeric_limits<float>::infinity()}) {
        EXPECT_EQ(octree_grid(corner - vec3(far), corner, 4.0f), uvec3(0)) << far;
        EXPECT_EQ(octree_grid(corner + vec3(16384.0f) + vec3(far), corner, 4.0f), uvec3(last_cell))
            << far;
    }
}

TEST(OctreeGrid, WhatIsNoNumberStaysInRange) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float inf = std::numeric_limits<float>::infinity();
    for (const vec3 position : {vec3(nan), vec3(-nan), vec3(nan, 8.0f, inf), vec3(-inf, nan, 3.0f)})
        for (const float scale : {1.0f, 0.0f, inf, nan}) {
            const uvec3 cell = octree_grid(position, vec3(0.0f), scale);
            for (int axis = 0; axis < 3; ++axis)
                EXPECT_LE(cell[axis], last_cell);
        }
    EXPECT_EQ(octree_grid(vec3(nan, 8.0f, inf), vec3(0.0f), 1.0f).y, 8u);
}

TEST(OctreeCells, DescentKeepsTheCellInsideDownToTheSmallest) {
    Dice dice(1);
    for (int round = 0; round < 2000; ++round) {
        // Corners and borders more often than chance would have it.
        uvec3 grid;
        for (int axis = 0; axis < 3; ++axis) {
            const uint any = dice.word() & last_cell;
            const std::array<uint, 5> choices{any, 0u, last_cell, 1u << (any & 15u),
                                              (1u << (any & 15u)) - 1u};
            grid[axis] = choices[dice.word() % choices.size()];
        }
        Path path;
        OctreeCell cell{uvec3(0), 0};
        for (uint depth = 0; depth < OCTREE_MAX_DEPTH; ++depth) {
            ASSERT_EQ(cell.depth, depth);
            const uint child = octree_child(grid, depth);
            ASSERT_LT(child, 8u);
            cell = octree_child_cell(cell, child);
            path = child_of(path, static_cast<int>(child));
            const Cube cube = cube_of(path);
            ASSERT_TRUE(cube.holds(ivec3(grid))) << path;
            ASSERT_EQ(ivec3(cell.corner), cube.lowest) << path;
            ASSERT_EQ(octree_cell_size(cell.depth), static_cast<uint>(cube.size)) << path;
        }
        ASSERT_EQ(cell.corner, grid);
        ASSERT_EQ(octree_cell_size(cell.depth), 1u);
    }
}

TEST(OctreeCells, EveryCellSurvivesPacking) {
    Dice dice(2);
    for (uint depth = 0; depth <= OCTREE_MAX_DEPTH; ++depth) {
        const uint size = octree_cell_size(depth);
        const uint last_corner = (1u << OCTREE_MAX_DEPTH) - size;
        for (int round = 0; round < 100; ++round) {
            OctreeCell cell{uvec3(0), depth};
            for (int axis = 0; axis < 3; ++axis)
                cell.corner[axis] = round == 0   ? 0
                                    : round == 1 ? last_corner
                                                 : dice.word() % (last_corner / size + 1) * size;
            const OctreeCell again = octree_unpack_cell(octree_pack_cell(cell));
            ASSERT_EQ(again.corner, cell.corner) << depth;
            ASSERT_EQ(again.depth, depth);
        }
    }
}

} // namespace
} // namespace vigil::test
