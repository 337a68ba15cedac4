// SPDX-License-Identifier: GPL-2.0-or-later
// The judge of means, judged itself on synthetic pictures: it accepts equal means, and it refuses
// biased ones and such as are too noisy to tell.
#include "judge.h"

#include <cmath>
#include <functional>
#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>
#include <random>

namespace vigil::test {
namespace {

constexpr int width = 12, height = 8;
constexpr Bounds bounds{0.015};

/// Pictures of 96 pixels, blocks of their own, with this relative noise of their mean.
PictureBatches noisy(double noise, int batches, std::uint32_t seed) {
    std::mt19937 random(seed);
    std::normal_distribution<float> normal(0.0f, static_cast<float>(noise * std::sqrt(batches)));
    PictureBatches result(width, height, 1);
    std::vector<float> rgb(3 * width * height);
    for (int batch = 0; batch < batches; ++batch) {
        for (std::size_t i = 0; i < rgb.size(); ++i)
            rgb[i] =
                (1.0f + 0.5f * std::sin(0.05f * static_cast<float>(i))) * (1.0f + normal(random));
        result.add(rgb);
    }
    return result;
}

/// A quiet picture and its reference; 1.6% between blocks.
PictureBatches sampled() {
    return noisy(0.014, 16, 1);
}
PictureBatches reference() {
    return noisy(0.008, 32, 2);
}

/// What the judge says against it.
std::string complaints(const std::function<void()>& judged) {
    testing::TestPartResultArray failures;
    {
        const testing::ScopedFakeTestPartResultReporter reporter(&failures);
        judged();
    }
    std::string text;
    for (int i = 0; i < failures.size(); ++i)
        text += failures.GetTestPartResult(i).message();
    return text;
}

std::string complaints_about(const PictureBatches& seen, const Bounds& demanded = bounds) {
    return complaints([&] { judge("", seen, reference(), demanded); });
}

std::string complaints_about(double factor, std::span<const std::size_t> blocks) {
    PictureBatches biased = sampled();
    biased.scale(factor, blocks);
    return complaints_about(biased);
}

TEST(Judge, AcceptsEqualMeans) {
    judge("batches", sampled(), reference(), bounds);
    judge("known values", sampled(), noisy(0.0, 2, 3).means(), bounds);
}

TEST(Judge, RefusesABiasInAnyPart) {
    for (const std::vector<std::size_t>& quadrant : quadrants(sampled()))
        for (const double factor : {0.95, 1.05})
            EXPECT_NE(complaints_about(factor, quadrant), "");
    for (const std::vector<std::size_t>& five :
         {std::vector<std::size_t>{0, 1, 2, 12, 13}, {52, 53, 54, 64, 65}})
        for (const double factor : {0.9, 1.1})
            EXPECT_NE(complaints_about(factor, five), "");
    PictureBatches biased = sampled();
    biased.scale(1.015);
    EXPECT_NE(complaints_about(biased), "");
}

TEST(Judge, RefusesWhatIsTooNoisyToTell) {
    EXPECT_NE(complaints_about(noisy(0.08, 16, 4)).find("a bias could hide"), std::string::npos);
    // In a part of the picture, though not in all of it.
    const std::string local = complaints_about(noisy(0.03, 16, 5), {0.03});
    EXPECT_EQ(local.find("a bias could hide"), std::string::npos) << local;
    EXPECT_NE(local.find("five"), std::string::npos) << local;
    // Black pictures agree, and tell nothing.
    PictureBatches black = sampled();
    black.scale(0.0);
    EXPECT_NE(complaints([&] { judge("", black, black, bounds); }), "");
}

TEST(Judge, RefusesDifferencesThatAreNoneOrTell) {
    std::vector<double> differences;
    std::mt19937 random(6);
    for (int i = 0; i < 24; ++i)
        differences.push_back(std::normal_distribution<double>(0.0, 0.04)(random));
    judge_differences("numbers", differences, 1.0, 0.05);
    EXPECT_NE(complaints([&] { judge_differences("", differences, 1.0, 0.02); }), "");
    for (double& difference : differences)
        difference += 0.06;
    EXPECT_NE(complaints([&] { judge_differences("", differences, 1.0, 0.05); }), "");
}

} // namespace
} // namespace vigil::test
