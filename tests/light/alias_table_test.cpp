// SPDX-License-Identifier: GPL-2.0-or-later
// The alias table: the look-up's arithmetic, stored densities equal to drawn frequencies, exact
// zeros, any scale.
#include "refresh/vkpt/light/alias_table.h"

#include "common/error.h"
#include "shared/random.h"
#include "statistics.h"

#include <gtest/gtest.h>

#include <limits>
#include <numeric>

namespace vigil {
namespace {

using namespace shader;

/// Exact probability of each index under the look-up, by its arithmetic.
std::vector<double> probabilities(const std::vector<AliasEntry>& table) {
    std::vector<double> p(table.size(), 0.0);
    const double column = 1.0 / static_cast<double>(table.size());
    for (size_t i = 0; i < table.size(); ++i) {
        const double own = table[i].threshold / 4294967296.0;
        p[i] += own * column;
        p[table[i].alias] += (1.0 - own) * column;
    }
    return p;
}

void expect_valid(std::span<const float> weights, double tolerance) {
    const std::vector<AliasEntry> table = build_alias_table(weights);
    ASSERT_EQ(table.size(), weights.size());
    const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
    const std::vector<double> p = probabilities(table);
    double sum = 0.0;
    for (size_t i = 0; i < table.size(); ++i) {
        ASSERT_LT(table[i].alias, table.size());
        // The stored density is the one in use, and near the one asked for.
        ASSERT_NEAR(table[i].pdf, p[i], 1e-7 * p[i]) << i;
        ASSERT_NEAR(p[i], weights[i] / total, tolerance / static_cast<double>(table.size())) << i;
        ASSERT_EQ(weights[i] > 0.0f, p[i] > 0.0) << i;
        ASSERT_EQ(weights[i] > 0.0f, table[i].pdf > 0.0f) << i;
        sum += table[i].pdf;
    }
    EXPECT_NEAR(sum, 1.0, 1e-6);
}

TEST(AliasTable, SlotIsIntegerAndFractionOfOneProduct) {
    for (const uint count : {1u, 2u, 3u, 1000u, 999983u, 0xffffffffu}) {
        Random random = random_begin(uvec2(0, 0), 0, count);
        for (int i = 0; i < 1000; ++i) {
            uvec2 bits = random_next_bits(random);
            if (i == 0) bits = uvec2(0u);
            if (i == 1) bits = uvec2(0xffffffffu);
            const AliasSlot slot = alias_slot(bits, count);
            __extension__ using Wide = unsigned __int128;
            const Wide product = (Wide{bits.x} << 32 | bits.y) * count;
            ASSERT_EQ(slot.column, static_cast<uint>(product >> 64));
            ASSERT_EQ(slot.fraction, static_cast<uint>(product >> 32));
            ASSERT_LT(slot.column, count);
        }
    }
}

TEST(AliasTable, NothingToDrawIsEmpty) {
    EXPECT_TRUE(build_alias_table({}).empty());
    EXPECT_TRUE(build_alias_table(std::vector<float>(5, 0.0f)).empty());
}

TEST(AliasTable, RefusesBadWeights) {
    EXPECT_THROW(build_alias_table(std::vector<float>{1.0f, -1.0f}), Error);
    EXPECT_THROW(build_alias_table(std::vector<float>{std::numeric_limits<float>::infinity()}),
                 Error);
    EXPECT_THROW(build_alias_table(std::vector<float>{std::numeric_limits<float>::quiet_NaN()}),
                 Error);
}

TEST(AliasTable, SmallTables) {
    expect_valid(std::vector<float>{5.0f}, 1e-9);
    expect_valid(std::vector<float>{1.0f, 3.0f}, 1e-8);
    expect_valid(std::vector<float>{0.0f, 3.0f, 0.0f}, 1e-8);
    expect_valid(std::vector<float>(7, 0.1f), 1e-7);
    expect_valid(std::vector<float>{1e30f, 1e-30f, 1.0f}, 1e-8);
    expect_valid(std::vector<float>{3e38f, 3e38f, 3e38f}, 1e-7);
    expect_valid(std::vector<float>{1e-45f, 1e-45f}, 1e-8);
}

TEST(AliasTable, RandomTables) {
    Random random = random_begin(uvec2(0, 0), 0, 1);
    for (const size_t size : {10u, 1000u, 100000u}) {
        for (const float decades : {0.0f, 1.0f, 30.0f}) {
            std::vector<float> weights(size);
            for (float& weight : weights)
                weight = random_next(random) < 0.2f
                             ? 0.0f
                             : std::pow(10.0f, decades * (random_next(random) - 0.5f));
            // Positive weights may gain the least threshold, 2^-32 of a column each.
            expect_valid(weights, 1e-5);
        }
    }
}

TEST(AliasTable, AMillionEntriesWithOneGiant) {
    std::vector<float> weights(1000000, 1e-3f);
    weights[123456] = 1e9f;
    for (size_t i = 0; i < weights.size(); i += 3)
        weights[i] = 0.0f;
    weights[123456] = 1e9f;
    expect_valid(weights, 1e-3);
}

TEST(AliasTable, DrawsFollowTheDensitiesAndNeverHitZero) {
    Random random = random_begin(uvec2(0, 0), 0, 2);
    std::vector<float> weights(200);
    for (size_t i = 0; i < weights.size(); ++i)
        weights[i] = i % 5 == 0 ? 0.0f : 0.2f + random_next(random) * static_cast<float>(i % 7);
    const std::vector<AliasEntry> table = build_alias_table(weights);
    std::vector<uint64_t> counts(weights.size());
    for (int i = 0; i < 1000000; ++i) {
        const AliasSlot slot =
            alias_slot(random_next_bits(random), static_cast<uint>(table.size()));
        ++counts[alias_choose(table[slot.column], slot)];
    }
    std::vector<uint64_t> drawn;
    std::vector<double> expected;
    for (size_t i = 0; i < weights.size(); ++i) {
        if (weights[i] == 0.0f) {
            EXPECT_EQ(counts[i], 0u);
            continue;
        }
        drawn.push_back(counts[i]);
        expected.push_back(table[i].pdf);
    }
    EXPECT_LT(std::abs(test::chi_square_z(drawn, expected)), test::z_limit);
}

} // namespace
} // namespace vigil
