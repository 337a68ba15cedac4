// SPDX-License-Identifier: GPL-2.0-or-later
// From a point to its leaf and back to the leaf's square: random points, points on borders and the
// ends of the unit square, in even, random and deepest trees.
#include "quadtree.h"

#include <gtest/gtest.h>

#include <set>

namespace vigil::test {
namespace {

using namespace shader;

/// The leaf that the bit field finds is the oracle's, and its square holds the point.
void expect_found(const Quadtree& tree, uvec4 field, vec2 uv) {
    const CdqPlace place = cdq_find(field, uv);
    const Quadtree::Node& leaf = tree.find(dvec2(uv));
    ASSERT_EQ(place.node, leaf.number) << uv.x << ' ' << uv.y;
    ASSERT_EQ(place.depth, leaf.depth) << uv.x << ' ' << uv.y;
    const CdqCell cell = cdq_cell(field, place.node);
    ASSERT_EQ(cell.depth, place.depth);
    ASSERT_EQ(cell.size, std::ldexp(1.0f, -static_cast<int>(cell.depth)));
    for (int axis = 0; axis < 2; ++axis) {
        ASSERT_GE(uv[axis], cell.corner[axis]);
        ASSERT_LT(uv[axis], cell.corner[axis] + cell.size);
    }
}

class Find : public testing::TestWithParam<uint32_t> {
protected:
    Dice dice_{GetParam()};
    const std::vector<Quadtree> trees_ = various_trees(GetParam(), sanitized ? 1 : 20, dice_);
};

TEST_P(Find, RandomPointsLieInTheSquareOfTheirLeaf) {
    for (const Quadtree& tree : trees_) {
        const uvec4 field = tree.field();
        for (int i = 0; i < (sanitized ? 2000 : 20000); ++i)
            ASSERT_NO_FATAL_FAILURE(expect_found(
                tree, field, vec2(dice_.between(0.0f, 1.0f), dice_.between(0.0f, 1.0f))));
    }
}

TEST_P(Find, BordersBelongToTheUpperLeaf) {
    for (const Quadtree& tree : trees_) {
        const uvec4 field = tree.field();
        for (const Quadtree::Node* node : tree.nodes()) {
            if (node->is_inner()) continue;
            const vec2 first(node->corner), end(node->corner + node->size);
            const vec2 last(std::nextafter(end.x, 0.0f), std::nextafter(end.y, 0.0f));
            for (const vec2 uv : {first, last, vec2(first.x, last.y), vec2(last.x, first.y)})
                ASSERT_EQ(cdq_find(field, uv).node, node->number) << uv.x << ' ' << uv.y;
            for (const vec2 uv : {vec2(end.x, first.y), vec2(first.x, end.y)}) {
                if (uv.x >= 1.0f || uv.y >= 1.0f) continue; // outside the square
                ASSERT_NE(cdq_find(field, uv).node, node->number) << uv.x << ' ' << uv.y;
            }
        }
    }
}

TEST_P(Find, PointsOnAndBesideEveryGridLineAreFound) {
    // 0, OCTAHEDRAL_MAX, and multiples of every power of two down to the smallest leaf.
    std::set<float> values{0.0f, std::nextafter(0.0f, 1.0f), OCTAHEDRAL_MAX};
    for (int depth = 1; depth <= static_cast<int>(CDQ_MAX_DEPTH) + 1; ++depth)
        for (const float line : {std::ldexp(1.0f, -depth), 0.5f + std::ldexp(0.5f, -depth),
                                 0.5f - std::ldexp(0.5f, -depth), 1.0f - std::ldexp(1.0f, -depth)})
            for (const float value : {line, std::nextafter(line, 0.0f), std::nextafter(line, 1.0f)})
                if (value < 1.0f) values.insert(value);
    for (const Quadtree& tree : trees_) {
        const uvec4 field = tree.field();
        for (const float x : values)
            for (const float y : values)
                ASSERT_NO_FATAL_FAILURE(expect_found(tree, field, vec2(x, y)));
    }
}

TEST_P(Find, LeavesTileTheSquare) {
    for (const Quadtree& tree : trees_) {
        double area = 0.0;
        for (uint leaf = 0; leaf < cdq_leaf_count(GetParam()); ++leaf) {
            const CdqCell cell = cdq_cell(tree.field(), cdq_leaf(tree.field(), GetParam(), leaf));
            area += double(cell.size) * cell.size;
        }
        EXPECT_EQ(area, 1.0); // sums of powers of two are exact
    }
}

INSTANTIATE_TEST_SUITE_P(Sizes, Find, testing::ValuesIn(cdq_sizes));

} // namespace
} // namespace vigil::test
