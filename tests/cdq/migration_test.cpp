// SPDX-License-Identifier: GPL-2.0-or-later
// Leaf migration on the bit field (paper, figure 4) against nodes with pointers: a million random
// migrations of each size (a tenth under sanitizers), and the extremes among them are counted.
#include "quadtree.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace vigil::test {
namespace {

using namespace shader;

uint32_t ones_of(uvec4 field) {
    uint32_t ones = 0;
    for (int word = 0; word < 4; ++word)
        ones += static_cast<uint32_t>(__builtin_popcount(field[word]));
    return ones;
}

std::string text_of(uvec4 field) {
    return fmt::format("{:08x} {:08x} {:08x} {:08x} (low word first)", field.x, field.y, field.z,
                       field.w);
}

/// Child, parent, rank, cell and leaf number of every node are the oracle's.
void expect_same_navigation(const Quadtree& tree, uvec4 field) {
    uint inner = 0, leaves = 0;
    const uvec4 starts = cdq_level_starts(field, tree.bits());
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
        ASSERT_EQ(cdq_depth(starts, node->number), node->depth) << node->number;
    }
    ASSERT_EQ(inner, cdq_inner_count(tree.bits()));
    ASSERT_EQ(leaves, cdq_leaf_count(tree.bits()));
}

class Migrations : public testing::TestWithParam<uint32_t> {};

TEST_P(Migrations, EvenTreeIsTheOracles) {
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

TEST_P(Migrations, EqualThoseOfNodesWithPointers) {
    const uint32_t bits = GetParam(), steps = sanitized ? 100000 : 1000000;
    Dice dice(bits);
    Quadtree tree(bits);
    uvec4 field = tree.field();
    uint32_t first_inner = 0, first_leaf = 0, last_leaf = 0, last_children = 0;
    uint32_t right_before = 0, right_after = 0, far_down = 0, far_up = 0, lowest_level = 0;
    Habit habit = Habit::Any;
    for (uint32_t step = 0, stretch = 0; step < steps; ++step) {
        // Stretches long enough to reach the extremes; others mix the shapes again.
        if (stretch-- == 0) {
            habit = static_cast<Habit>(dice.below(habit_count));
            stretch = dice.below(2 * bits);
        }
        const Migration chosen = choose_migration(tree, habit, dice);
        const uint32_t removed = tree.nodes()[chosen.inner]->children[0]->number;
        const uvec4 before = field;
        field = cdq_migrate(field, chosen.inner, chosen.leaf);
        const bool to_lowest = tree.nodes()[chosen.leaf]->depth + 1 == CDQ_MAX_DEPTH;
        tree.migrate(chosen.inner, chosen.leaf);
        ASSERT_EQ(field, tree.field())
            << text_of(before) << ": " << chosen.inner << " to " << chosen.leaf << " gives "
            << text_of(field) << ", not " << text_of(tree.field());
        ASSERT_EQ(ones_of(field), bits / 4 - 1);
        ASSERT_EQ(field & ~cdq_mask_below(bits), uvec4(0));
        if (step % 256 == 0) {
            ASSERT_NO_FATAL_FAILURE(expect_same_navigation(tree, field));
        }
        first_inner += chosen.inner == 0;
        first_leaf += chosen.leaf == 0;
        last_leaf += chosen.leaf == bits - 1;
        last_children += removed == bits - 4;
        right_before += chosen.leaf == removed - 1;
        right_after += chosen.leaf == removed + 4;
        far_down += chosen.leaf < 4 && removed == bits - 4;
        far_up += chosen.inner < 4 && chosen.leaf >= bits - 4;
        lowest_level += to_lowest;
    }
    // The extremes were among them.
    for (const uint32_t seen : {first_inner, first_leaf, last_leaf, last_children, right_before,
                                right_after, far_down, far_up})
        EXPECT_GT(seen, 100u);
    // 7 inner nodes reach level 8.
    EXPECT_EQ(lowest_level > 100, bits > 32);
}

TEST_P(Migrations, LastTreeOfEveryChainIsFoundAgain) {
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

INSTANTIATE_TEST_SUITE_P(Sizes, Migrations, testing::ValuesIn(cdq_sizes));

} // namespace
} // namespace vigil::test
