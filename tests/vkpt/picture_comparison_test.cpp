// SPDX-License-Identifier: GPL-2.0-or-later
// The statistics that judge the renderer, judged themselves: on synthetic pictures they accept
// equal means under fireflies, and they find a small bias and a single wrong block.
#include "picture_comparison.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace vigil::test {
namespace {

constexpr int width = 48, height = 32, block = 4;

/// Pictures whose pixels are mostly dark and sometimes bright, as if a small lamp were found by
/// chance `hit`.
PictureBatches lamp_pictures(double hit, int batches, std::uint32_t seed,
                             double bad_block_factor = 1.0) {
    std::mt19937 random(seed);
    std::binomial_distribution<int> hits(64, hit); // 64 paths a pixel
    PictureBatches result(width, height, block);
    std::vector<float> rgb(3 * width * height);
    for (int batch = 0; batch < batches; ++batch) {
        for (int i = 0; i < width * height; ++i) {
            const double level = 1.0 + 0.5 * std::sin(0.05 * i), found = hits(random);
            const bool bad = i % width < block && i / width < block;
            for (int c = 0; c < 3; ++c)
                rgb[static_cast<std::size_t>(3 * i + c)] = static_cast<float>(
                    level * found / (64.0 * hit) * (bad ? bad_block_factor : 1.0));
        }
        result.add(rgb);
    }
    return result;
}

TEST(PictureComparison, AcceptsEqualMeans) {
    for (std::uint32_t seed = 1; seed <= 20; ++seed) {
        const PictureBatches sampled = lamp_pictures(0.5, 16, 2 * seed),
                             rare = lamp_pictures(0.01, 32, 2 * seed + 1);
        const Comparison seen = compare(sampled, rare, seed % 3);
        EXPECT_EQ(seen.blocks, 96u);
        EXPECT_TRUE(seen.agrees(score_limit)) << seen.text();
    }
}

TEST(PictureComparison, FindsABiasOfSixErrors) {
    PictureBatches sampled = lamp_pictures(0.5, 16, 100);
    const PictureBatches rare = lamp_pictures(0.05, 32, 101);
    const double detectable = 6.5 * compare(sampled, rare, 0).bias_error;
    EXPECT_LT(detectable, 0.02);
    sampled.scale(1.0 + detectable);
    EXPECT_FALSE(compare(sampled, rare, 0).agrees(score_limit));
}

TEST(PictureComparison, FindsOneWrongBlock) {
    const PictureBatches good = lamp_pictures(0.5, 16, 200), bad = lamp_pictures(0.5, 16, 201, 1.5);
    const Comparison seen = compare(good, bad, 1);
    EXPECT_LT(std::abs(seen.bias_z), score_limit) << seen.text();
    EXPECT_FALSE(seen.agrees(score_limit)) << seen.text();
}

/// Blocks with normal noise of 2.5% each, as most tests have: what the four scores find.
PictureBatches even_pictures(double noise, std::uint32_t seed) {
    constexpr int batches = 16;
    std::mt19937 random(seed);
    std::normal_distribution<double> normal(1.0, noise * std::sqrt(batches));
    PictureBatches result(12, 8, 1);
    std::vector<float> rgb(std::size_t{3} * 12 * 8);
    for (int batch = 0; batch < batches; ++batch) {
        for (float& value : rgb)
            value = static_cast<float>(normal(random));
        result.add(rgb);
    }
    return result;
}

TEST(PictureComparison, RegionsHoldNeighbours) {
    const PictureBatches picture = even_pictures(0.0, 1);
    std::vector<int> times(96);
    for (const std::vector<std::size_t>& quadrant : quadrants(picture)) {
        EXPECT_EQ(quadrant.size(), 24u);
        for (const std::size_t block : quadrant)
            times[block] += 1;
    }
    EXPECT_EQ(times, std::vector<int>(96, 1));
    EXPECT_EQ(windows(picture).size(), 70u);
    EXPECT_EQ(windows(picture).back(), (std::vector<std::size_t>{81, 82, 83, 93, 94, 95}));
}

TEST(PictureComparison, FindsAWrongRegionThatNoOtherScoreSees) {
    const PictureBatches reference = even_pictures(0.01, 1);
    for (const auto& [blocks, factor] :
         {std::pair{quadrants(reference)[2], 1.05},
          std::pair{std::vector<std::size_t>{28, 29, 30, 40, 41}, 1.1}}) {
        PictureBatches biased = even_pictures(0.024, 2);
        EXPECT_TRUE(compare(biased, reference, 0).agrees(score_limit));
        biased.scale(factor, blocks);
        const Comparison seen = compare(biased, reference, 0);
        EXPECT_GT(seen.region_z, score_limit) << seen.text();
        EXPECT_LT(std::max({std::abs(seen.bias_z), seen.spread_z, seen.outlier_z}), score_limit)
            << seen.text();
    }
}

// Standard normal, or less: beyond 3 lie 1.35 of 1,000.
TEST(PictureComparison, RegionsAreAsQuietAsTold) {
    int beyond = 0;
    for (std::uint32_t seed = 0; seed < 1000; ++seed)
        beyond +=
            compare(even_pictures(0.02, 2 * seed), even_pictures(0.02, 2 * seed + 1), 0).region_z >
                    3.0
                ? 1
                : 0;
    EXPECT_LE(beyond, 6);
}

TEST(PictureComparison, ComparesExactlyWithoutNoise) {
    PictureBatches a(8, 8, 4), b(8, 8, 4);
    std::vector<float> picture(3 * 64, 2.0f);
    for (int i = 0; i < 4; ++i) {
        a.add(picture);
        b.add(picture);
    }
    EXPECT_TRUE(compare(a, b, 0).agrees(score_limit));
    EXPECT_EQ(compare(a, b, 0).blocks, 0u);
    b.scale(1.001);
    EXPECT_EQ(compare(a, b, 0).unequal, 4u);
    EXPECT_FALSE(compare(a, b, 0).agrees(score_limit));
}

TEST(PictureComparison, StudentsTBecomesNormal) {
    // Quantiles of Student's t with 30 degrees of freedom at the normal's 1, 2 and 3 sigma.
    EXPECT_NEAR(score_of_t(1.0174, 30.0), 1.0, 0.01);
    EXPECT_NEAR(score_of_t(2.0878, 30.0), 2.0, 0.02);
    EXPECT_NEAR(score_of_t(-3.2703, 30.0), -3.0, 0.03);
}

} // namespace
} // namespace vigil::test
