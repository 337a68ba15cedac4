// SPDX-License-Identifier: GPL-2.0-or-later
// FLIP against what follows from its formulas, and against values that the authors' program gives.
#include "bench/display.h"
#include "bench/flip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace vigil::bench {

namespace {

constexpr glm::ivec2 size{96, 64};

/// A picture whose colour is color(x, y).
template <typename Color> std::vector<float> picture(const Color& color) {
    std::vector<float> rgb;
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x)
            for (const double value : color(x, y))
                rgb.push_back(static_cast<float>(value));
    return rgb;
}

using Rgb = std::array<double, 3>;

std::vector<float> flat(Rgb color) {
    return picture([=](int, int) { return color; });
}

std::vector<float> gray(double value) {
    return flat({value, value, value});
}

/// Black, and white from a column on.
std::vector<float> edge(int column) {
    return picture([=](int x, int) {
        const double value = x >= column ? 1.0 : 0.0;
        return Rgb{value, value, value};
    });
}

/// Structure everywhere, of a phase.
std::vector<float> pattern(int phase) {
    return picture([=](int x, int y) {
        return Rgb{(x * 7 + y * 3 + 4 * phase) % 32 / 31.0, (x * 5 + y * 11) % 24 / 23.0,
                   (x * y + phase) % 16 / 15.0};
    });
}

std::vector<float> noisy(double sigma) {
    std::minstd_rand random(7);
    std::normal_distribution<double> noise(0.0, sigma);
    return picture([&](int, int) {
        const double value = 0.5 + noise(random);
        return Rgb{value, value, value};
    });
}

} // namespace

TEST(Flip, SamePicturesDoNotDiffer) {
    for (const float value : flip_map(pattern(0), pattern(0), size))
        EXPECT_EQ(value, 0.0f);
}

TEST(Flip, GreenAgainstBlueIsTheLargestDifference) {
    EXPECT_NEAR(mean_flip(flat({0, 1, 0}), flat({0, 0, 1}), size), 1.0, 1e-6);
    EXPECT_LT(mean_flip(gray(0.0), gray(1.0), size), 1.0);
}

TEST(Flip, FlatGraysFollowFromTheirLightness) {
    // No features, no colour: HyAB is the difference of CIELAB's lightness, whatever the filter.
    const auto lightness = [](double y) { return 116.0 * std::cbrt(y) - 16.0; };
    // CIELAB of green is (87.74, -86.18, 83.18), of blue (32.30, 79.19, -107.86); Hunt's effect
    // scales the latter two by a hundredth of the first.
    const double largest = std::pow(
        55.44 + std::hypot(0.8774 * 86.18 + 0.3230 * 79.19, 0.8774 * 83.18 + 0.3230 * 107.86), 0.7);
    const double difference = std::pow(lightness(0.5) - lightness(0.25), 0.7);
    EXPECT_NEAR(mean_flip(gray(0.25), gray(0.5), size), 0.95 / (0.4 * largest) * difference, 2e-3);
}

TEST(Flip, AgreesWithTheAuthorsProgram) {
    // flip-evaluator 1.7, LDR, linear input, 67 pixels per degree; it computes in single precision.
    EXPECT_NEAR(mean_flip(pattern(0), pattern(1), size), 0.1715579, 2e-4);
    EXPECT_NEAR(mean_flip(gray(0.0), gray(1.0), size), 0.9673252, 2e-4);
    EXPECT_NEAR(mean_flip(gray(0.25), gray(0.5), size), 0.4519039, 2e-4);
    EXPECT_NEAR(mean_flip(edge(48), edge(49), size), 0.0344878, 2e-4);
    std::vector<float> point = gray(0.5);
    std::fill_n(point.begin() + 3 * (32 * size.x + 48), 3, 1.0f);
    EXPECT_NEAR(mean_flip(gray(0.5), point, size), 0.0003618, 2e-6);
}

TEST(Flip, IsSymmetricAndInRange) {
    const std::vector<float> map = flip_map(pattern(0), pattern(1), size);
    const std::vector<float> back = flip_map(pattern(1), pattern(0), size);
    for (std::size_t i = 0; i < map.size(); ++i) {
        EXPECT_GE(map[i], 0.0f);
        EXPECT_LE(map[i], 1.0f);
        EXPECT_NEAR(map[i], back[i], 1e-6f);
    }
}

TEST(Flip, AnEdgeThatMovesIsSeenWhereItIs) {
    const std::vector<float> near = flip_map(edge(48), edge(49), size);
    const std::vector<float> far = flip_map(edge(48), edge(52), size);
    double near_sum = 0.0, far_sum = 0.0;
    for (int x = 0; x < size.x; ++x) {
        const std::size_t at = 32u * size.x + x;
        near_sum += static_cast<double>(near[at]);
        far_sum += static_cast<double>(far[at]);
        if (std::abs(x - 48) > 30) {
            EXPECT_LT(near[at], 1e-3f) << x;
        }
    }
    EXPECT_GT(near[32u * size.x + 48], 0.2f);
    EXPECT_GT(far_sum, 1.5 * near_sum);
}

TEST(Flip, MoreNoiseIsWorseAndDistanceHidesIt) {
    const double little = mean_flip(gray(0.5), noisy(0.02), size);
    const double much = mean_flip(gray(0.5), noisy(0.1), size);
    EXPECT_GT(little, 0.005);
    EXPECT_GT(much, 1.5 * little);
    EXPECT_LT(mean_flip(gray(0.5), noisy(0.1), size, 134.0), much);
}

TEST(Display, ExposesByTheGeometricMeanOfTiles) {
    EXPECT_NEAR(exposure_of(gray(0.36), size), 0.5, 1e-6);
    // Half of the tiles 4 times as bright: the geometric mean doubles. Black ones say nothing.
    EXPECT_NEAR(exposure_of(picture([](int x, int) {
                                const double value = x < 48 ? 0.18 : 0.72;
                                return Rgb{value, value, value};
                            }),
                            size),
                0.5, 1e-5);
    EXPECT_NEAR(exposure_of(edge(48), size), 0.18, 1e-6);
}

TEST(Display, IsMonotoneAndClamped) {
    const std::vector<float> shown =
        displayed(std::vector<float>{0.0f, 0.1f, 1.0f, 10.0f, 1e9f}, 1.0);
    EXPECT_EQ(shown.front(), 0.0f);
    EXPECT_TRUE(std::ranges::is_sorted(shown));
    EXPECT_EQ(shown.back(), 1.0f);
    EXPECT_NEAR(shown[2], 0.8 * (2.51 * 0.8 + 0.03) / (0.8 * (2.43 * 0.8 + 0.59) + 0.14), 1e-6);
}

} // namespace vigil::bench
