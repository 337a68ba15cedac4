// SPDX-License-Identifier: GPL-2.0-or-later
// The quadtrees' oracle itself, on cases small enough to be worked out by hand.
#include "cdq_oracle.h"
#include "dice.h"
#include "shared/cdq.h"
#include "shared/guiding_types.h"

#include <gtest/gtest.h>

namespace vigil::test {
namespace {

/// Seven inner nodes below the root, as in fields of 32 bits. Six of them have four leaves: "1",
/// "2", "3", "00", "01" and "02".
const Squares even{"", "0", "1", "2", "3", "00", "01", "02"};

/// A ray through the middle of a square.
uint32_t ray_into(const Path& square, float contribution) {
    glm::uvec2 cell(0);
    uint32_t size = 4096;
    for (const char digit : square) {
        size /= 2;
        cell += size * glm::uvec2(static_cast<uint32_t>(digit - '0') & 1u,
                                  static_cast<uint32_t>(digit - '0') >> 1u);
    }
    return shader::ray_sample_pack(cell + size / 2, contribution);
}

QuadtreeLessons lessons_of(const std::vector<uint32_t>& rays) {
    QuadtreeLessons lessons;
    for (const uint32_t ray : rays)
        lessons.stored.push_back({ray, 0});
    return lessons;
}

AdaptedQuadtree adapted(const std::vector<uint32_t>& rays, float margin, uint32_t migrations = 1) {
    const AdaptedQuadtrees result = adapt_quadtree(even, lessons_of(rays), {migrations, margin});
    EXPECT_TRUE(result.exact);
    EXPECT_EQ(result.allowed.size(), 1u);
    return result.allowed.begin()->first;
}

TEST(CdqOracle, FieldsAreBreadthFirst) {
    EXPECT_EQ(field_of(even), glm::uvec4(0b1111111, 0, 0, 0));
    EXPECT_EQ(field_of(even), shader::cdq_even_tree(32));
    // Children of the root have the bits 0 to 3, those of "0" 4 to 7 and of "3" 8 to 11, those of
    // "03" 12 to 15 and of "30" 16 to 19, and so on.
    const Squares other{"", "0", "3", "03", "30", "301", "3012", "30121"};
    uint32_t bits = 0;
    for (const uint32_t inner : {0u, 3u, 7u, 8u, 17u, 22u, 25u})
        bits |= 1u << inner;
    EXPECT_EQ(field_of(other), glm::uvec4(bits, 0, 0, 0));
    EXPECT_EQ(squares_of(field_of(other), 32), other);
    EXPECT_EQ(squares_of({0b111111, 0, 0, 0}, 32), std::nullopt);      // an inner node too few
    EXPECT_EQ(squares_of({0b11111111, 0, 0, 0}, 32), std::nullopt);    // one too many
    EXPECT_EQ(squares_of({0x1f, 0x80000000, 0, 0}, 32), std::nullopt); // one that has no place
}

TEST(CdqOracle, TheBrightestLeafIsSplitForTheDarkestNode) {
    // Only "2" brought nothing.
    const std::vector<uint32_t> rays{ray_into("30", 8.0f), ray_into("10", 1.0f),
                                     ray_into("001", 1.0f), ray_into("013", 1.0f),
                                     ray_into("020", 1.0f)};
    const AdaptedQuadtree result = adapted(rays, 0.1f);
    EXPECT_EQ(result.inner, (Squares{"", "0", "1", "3", "00", "01", "02", "30"}));
    EXPECT_EQ(result.migrations, 1u);
}

TEST(CdqOracle, ContributionsCountSquared) {
    // Three of 2 are 12; one of 4 is 16.
    const std::vector<uint32_t> rays{ray_into("30", 4.0f), ray_into("10", 2.0f),
                                     ray_into("10", 2.0f), ray_into("10", 2.0f)};
    EXPECT_TRUE(adapted(rays, 0.1f).inner.contains("30"));
}

TEST(CdqOracle, AMigrationMustPayOff) {
    // The leaf brings 16, and inner nodes above leaves 4 at least; those a level below 16, as rays
    // are four times as dense there.
    std::vector<uint32_t> rays{ray_into("30", 4.0f)};
    for (const char* square : {"10", "20"})
        rays.push_back(ray_into(square, 2.0f));
    for (const char* square : {"000", "010", "020"})
        rays.push_back(ray_into(square, 4.0f));
    EXPECT_EQ(adapted(rays, 0.25f).inner, even);
    EXPECT_EQ(adapted(rays, 0.25f).migrations, 0u);
    EXPECT_EQ(adapted(rays, 0.26f).migrations, 1u);
    EXPECT_EQ(adapted(rays, 0.26f).inner, (Squares{"", "0", "2", "3", "00", "01", "02", "30"}));
}

TEST(CdqOracle, FurtherMigrationsStartFromTheFirst) {
    const AdaptedQuadtree result = adapted({ray_into("30", 4.0f)}, 0.1f, 3);
    // Of equal nodes the lowest slot goes, of the leaf's four quarters the first is split again.
    EXPECT_EQ(result.inner, (Squares{"", "0", "3", "01", "02", "30", "300", "301"}));
    EXPECT_EQ(result.migrations, 3u);
}

TEST(CdqOracle, ManyRaysArePassedOverEvenly) {
    std::vector<uint32_t> rays(2 * shader::GUIDE_MOST_RAYS + 3, ray_into("10", 0.125f));
    rays[0] = rays[3] = ray_into("20", 64.0f);
    rays[1] = ray_into("30", 512.0f); // passed over
    EXPECT_TRUE(adapted(rays, 1.0f).inner.contains("20"));
    EXPECT_FALSE(adapted(rays, 1.0f).inner.contains("30"));
}

TEST(CdqOracle, WithoutRaysNothingMoves) {
    EXPECT_EQ(adapted({}, 1.0f, 4).migrations, 0u);
}

TEST(CdqOracle, WhatRoundingDecidesIsOpen) {
    // Tenths are no floats: which of two such sums is larger is for the order of adding to say.
    std::vector<uint32_t> rays;
    for (const char* square : {"30", "20"})
        for (const float contribution : {1.2f, 1.7f, 2.4f})
            rays.push_back(ray_into(square, contribution));
    rays.push_back(ray_into("20", 1e-4f));
    const AdaptedQuadtrees result = adapt_quadtree(even, lessons_of(rays), {1, 0.1f});
    EXPECT_FALSE(result.exact);
    EXPECT_EQ(result.allowed.size(), 2u);
}

} // namespace
} // namespace vigil::test
