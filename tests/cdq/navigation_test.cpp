// SPDX-License-Identifier: GPL-2.0-or-later
// Navigation of the bit field against nodes with pointers: the even tree, trees after random
// migrations (paper, figure 4), and the longest chains.
#include "quadtree.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace vigil::test {
namespace {

using namespace shader;

/// Child, parent, rank, cell and leaf number of every node are the oracle's.
void expect_same_navigation(const Quadtree& tree, uvec4 field) {
    uint inner = 0, leaves = 0;
    for (const Quadtree::Node* node : tree.nodes()) {
        ASSERT_EQ(cdq_rank(field, node->number), inner) << node->number;
        ASSERT_EQ(cdq_is_inner(field, node->number), node->is_inner()) << node->number;
        if (node->number >= 4) {
            ASSERT_EQ(cdq_parent(field, node->number), node->parent->number) << node->number;
        }
        if (node->is_inner()) {
            for (uint child = 0; child < 4; ++child)
                ASSERT_EQ(cdq_child(field, node->number, child), node->children[child]->number);
            ++inner;
        } else {
            ASSERT_EQ(cdq_leaf(field, tree.bits(), leaves), node->number) << leaves;
            ++leaves;
        }
        const CdqCell cell = cdq_cell(field, node->number);
        ASSERT_EQ(dvec2(cell.corner), node->corner) << node->number;
        ASSERT_EQ(double(cell.size), node->size) << node->number;
        ASSERT_EQ(cell.depth, node->depth) << node->number;
    }
    ASSERT_EQ(inner, cdq_inner_count(tree.bits()));
    ASSERT_EQ(leaves, cdq_leaf_count(tree.bits()));
}

class Navigation : public testing::TestWithParam<uint32_t> {};

TEST_P(Navigation, EvenTreeIsTheOracles) {
    const Quadtree tree(GetParam());
    EXPECT_EQ(cdq_even_tree(GetParam()), tree.field());
    expect_same_navigation(tree, cdq_even_tree(GetParam()));
    uint lowest = CDQ_MAX_DEPTH, highest = 0;
    for (const Quadtree::Node* node : tree.nodes()) {
        if (node->is_inner()) continue;
        lowest = std::min(lowest, node->depth);
        highest = std::max(highest, node->depth);
    }
    EXPECT_EQ(highest - lowest, 1u);
}

TEST_P(Navigation, OfTreesAfterRandomMigrations) {
    const uint32_t bits = GetParam(), steps = sanitized ? 25600 : 256000;
    Dice dice(bits);
    Quadtree tree(bits);
    uint32_t lowest_level = 0;
    Habit habit = Habit::Any;
    for (uint32_t step = 0, stretch = 0; step < steps; ++step) {
        // Stretches long enough to reach the extremes; others mix the shapes again.
        if (stretch-- == 0) {
            habit = static_cast<Habit>(dice.below(habit_count));
            stretch = dice.below(2 * bits);
        }
        const Migration chosen = choose_migration(tree, habit, dice);
        lowest_level += tree.nodes()[chosen.leaf]->depth + 1 == CDQ_MAX_DEPTH;
        tree.migrate(chosen.inner, chosen.leaf);
        if (step % 64 == 0) {
            ASSERT_NO_FATAL_FAILURE(expect_same_navigation(tree, tree.field()));
        }
    }
    // 7 inner nodes reach level 8.
    EXPECT_EQ(lowest_level > 100, bits > 32);
}

TEST_P(Navigation, LastTreeOfEveryChainIsFoundAgain) {
    // The longest chain towards each corner of the square, down to the limit of bits or depth.
    for (uint corner = 0; corner < 4; ++corner) {
        const float x = (corner & 1u) != 0u ? OCTAHEDRAL_MAX : 0.0f;
        const float y = (corner & 2u) != 0u ? OCTAHEDRAL_MAX : 0.0f;
        const Quadtree tree = tree_towards(GetParam(), dvec2(x, y));
        expect_same_navigation(tree, tree.field());
        const CdqPlace place = cdq_find(tree.field(), vec2(x, y));
        EXPECT_EQ(place.depth, std::min(CDQ_MAX_DEPTH, cdq_inner_count(GetParam()) + 1u));
        EXPECT_EQ(place.node, tree.find(dvec2(x, y)).number);
    }
}

INSTANTIATE_TEST_SUITE_P(Sizes, Navigation, testing::ValuesIn(cdq_sizes));

} // namespace
} // namespace vigil::test
