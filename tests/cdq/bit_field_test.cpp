// SPDX-License-Identifier: GPL-2.0-or-later
// Rank, select, leaf, child and parent against naive loops: on random fields, on every 16-bit word,
// and on every tree that 32 bits can hold. Migration and sampling have tests of their own.
#include "quadtree.h"

#include <gtest/gtest.h>

#include <functional>

namespace vigil::test {
namespace {

using namespace shader;

bool bit(uvec4 field, uint position) {
    return (field[position / 32] >> position % 32 & 1u) == 1u;
}

std::vector<uint> positions_of(uvec4 field, bool value, uint end) {
    std::vector<uint> positions;
    for (uint position = 0; position < end; ++position)
        if (bit(field, position) == value) positions.push_back(position);
    return positions;
}

/// Words of every density: random, almost empty, almost full, empty, full.
uint any_word(Dice& dice) {
    switch (dice.below(6)) {
    case 0:
        return 0u;
    case 1:
        return ~0u;
    case 2:
        return 1u << dice.below(32);
    case 3:
        return ~(1u << dice.below(32));
    case 4:
        return dice.word() & dice.word() & dice.word();
    default:
        return dice.word();
    }
}

TEST(CdqBits, CountsOfTheFourSizes) {
    const std::array<uint, 4> leaves{25, 49, 73, 97}, inner{7, 15, 23, 31};
    for (size_t i = 0; i < cdq_sizes.size(); ++i) {
        EXPECT_EQ(cdq_leaf_count(cdq_sizes[i]), leaves[i]);
        EXPECT_EQ(cdq_inner_count(cdq_sizes[i]), inner[i]);
    }
}

TEST(CdqBits, MaskHoldsTheBitsBelow) {
    for (uint end = 0; end <= CDQ_MOST_BITS; ++end)
        for (uint position = 0; position < CDQ_MOST_BITS; ++position)
            ASSERT_EQ(bit(cdq_mask_below(end), position), position < end) << end;
}

TEST(CdqBits, SelectInAWordFindsEveryOneOfEveryHalf) {
    for (uint half = 0; half < 0x10000u; ++half)
        for (const uint word : {half, half << 16, half | ~half << 16}) {
            uint rank = 0;
            for (uint position = 0; position < 32; ++position)
                if ((word >> position & 1u) == 1u) {
                    ASSERT_EQ(cdq_select_in_word(word, rank), position) << word;
                    ++rank;
                }
        }
}

TEST(CdqBits, RankAndSelectAreCounting) {
    Dice dice(1);
    for (int round = 0; round < (sanitized ? 5000 : 100000); ++round) {
        const uvec4 field(any_word(dice), any_word(dice), any_word(dice), any_word(dice));
        uint ones = 0;
        for (uint position = 0; position < CDQ_MOST_BITS; ++position) {
            ASSERT_EQ(cdq_rank(field, position), ones) << position;
            ASSERT_EQ(cdq_is_inner(field, position), bit(field, position)) << position;
            if (!bit(field, position)) continue;
            ASSERT_EQ(cdq_select(field, ones), position);
            ++ones;
        }
    }
}

TEST(CdqBits, LeavesAreTheZeroes) {
    Dice dice(2);
    for (int round = 0; round < (sanitized ? 5000 : 100000); ++round)
        for (const uint bits : cdq_sizes) {
            const uvec4 field =
                uvec4(any_word(dice), any_word(dice), any_word(dice), any_word(dice)) &
                cdq_mask_below(bits);
            const std::vector<uint> zeroes = positions_of(field, false, bits);
            for (uint leaf = 0; leaf < zeroes.size(); ++leaf)
                ASSERT_EQ(cdq_leaf(field, bits, leaf), zeroes[leaf]) << bits;
        }
}

/// Calls `visit` with every breadth-first field of 7 inner nodes and 25 leaves: a node exists as
/// soon as enough inner nodes come before it.
void for_every_32_bit_tree(const std::function<void(uint)>& visit) {
    const std::function<void(uint, uint, uint)> extend = [&](uint field, uint position, uint ones) {
        if (ones == 7) return visit(field);
        if (position == 4 * (ones + 1)) return; // the tree would end here
        extend(field, position + 1, ones);
        extend(field | 1u << position, position + 1, ones + 1);
    };
    extend(0, 0, 0);
}

TEST(CdqBits, EveryTreeOf32BitsIsNavigatedRightly) {
    uint trees = 0;
    for_every_32_bit_tree([&](uint word) {
        // The oracle's way: nodes receive children in their order.
        if (trees++ % (sanitized ? 16 : 1) != 0) return;
        const uvec4 field(word, 0, 0, 0);
        std::array<uint, 32> depth{};
        depth.fill(1);
        uint next = 4, leaf = 0;
        double area = 0.0;
        for (uint node = 0; node < 32; ++node) {
            if ((word >> node & 1u) == 0u) {
                ASSERT_EQ(cdq_leaf(field, 32, leaf++), node) << word;
                const CdqCell cell = cdq_cell(field, node);
                ASSERT_EQ(cell.depth, depth[node]) << word;
                const CdqPlace place = cdq_find(field, cell.corner + 0.5f * cell.size);
                ASSERT_EQ(place.node, node) << word;
                ASSERT_EQ(place.depth, depth[node]) << word;
                area += double(cell.size) * cell.size;
                continue;
            }
            for (uint child = 0; child < 4; ++child, ++next) {
                ASSERT_EQ(cdq_child(field, node, child), next) << word;
                ASSERT_EQ(cdq_parent(field, next), node) << word;
                depth[next] = depth[node] + 1;
            }
        }
        ASSERT_EQ(next, 32u);
        ASSERT_EQ(leaf, 25u);
        ASSERT_EQ(area, 1.0); // sums of powers of two are exact
    });
    EXPECT_EQ(trees, 420732u); // C(32, 8) / 25 quaternary trees of 8 inner nodes, the root included
}

// On a GPU a loop without an end is a lost device.
TEST(CdqBits, WhatIsNoTreeEndsAsWell) {
    Dice dice(5);
    for (int round = 0; round < 10000; ++round) {
        const uvec4 field(any_word(dice), any_word(dice), any_word(dice), any_word(dice));
        for (uint node = 0; node < CDQ_MOST_BITS; ++node)
            ASSERT_LE(cdq_cell(field, node).depth, CDQ_MAX_DEPTH);
    }
}

} // namespace
} // namespace vigil::test
