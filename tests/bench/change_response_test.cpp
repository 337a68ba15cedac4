// SPDX-License-Identifier: GPL-2.0-or-later
// Shares of a change that are known, of pictures and references with noise and without.
#include "bench/change_response.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

namespace vigil::bench {

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// Without noise.
Reference exact(const std::vector<float>& picture) {
    Reference reference(picture.size());
    for (int batch = 0; batch < 2; ++batch)
        reference.add(picture);
    return reference;
}

/// The mean of 16 batches; its own standard deviation is `sigma`.
Reference noisy(const std::vector<float>& picture, double sigma, std::mt19937& random) {
    std::normal_distribution<double> noise(0.0, 4.0 * sigma);
    Reference reference(picture.size());
    for (int batch = 0; batch < 16; ++batch) {
        std::vector<float> values;
        for (const float value : picture)
            values.push_back(value + static_cast<float>(noise(random)));
        reference.add(values);
    }
    return reference;
}

constexpr glm::ivec2 size{240, 8};
constexpr std::size_t values = 3 * 240 * 8;

/// Gray tiles in turn of three values.
std::vector<float> picture(float first, float second, float third) {
    std::vector<float> rgb;
    for (std::size_t i = 0; i < values; ++i)
        rgb.push_back(i / 24 % 3 == 0 ? first : i / 24 % 3 == 1 ? second : third);
    return rgb;
}

std::vector<float> mix(const std::vector<float>& a, const std::vector<float>& b, float weight) {
    std::vector<float> mixed;
    for (std::size_t i = 0; i < a.size(); ++i)
        mixed.push_back((1.0f - weight) * a[i] + weight * b[i]);
    return mixed;
}

} // namespace

TEST(ChangeShown, IsTheWeightOfTheNewPicture) {
    const std::vector<float> before = picture(1.0f, 4.0f, 2.0f), after = picture(3.0f, 0.5f, 2.0f);
    for (const float weight : {0.0f, 0.25f, 0.9f, 1.0f}) {
        const ChangeShown shown =
            change_shown(mix(before, after, weight), exact(before), exact(after), size);
        EXPECT_NEAR(shown.brighter, weight, 1e-6);
        EXPECT_NEAR(shown.darker, weight, 1e-6);
    }
}

TEST(ChangeShown, TellsWhatComesFromWhatGoes) {
    const std::vector<float> before = picture(1.0f, 4.0f, 2.0f), after = picture(3.0f, 0.5f, 2.0f);
    // What becomes brighter is there, what becomes darker has not moved.
    const ChangeShown shown =
        change_shown(picture(3.0f, 4.0f, 2.0f), exact(before), exact(after), size);
    EXPECT_NEAR(shown.brighter, 1.0, 1e-6);
    EXPECT_NEAR(shown.darker, 0.0, 1e-6);
    const ChangeShown same = change_shown(before, exact(before), exact(before), size);
    EXPECT_TRUE(std::isnan(same.brighter));
    EXPECT_TRUE(std::isnan(same.darker));
}

TEST(ChangeShown, BrightPixelsDoNotDecide) {
    // All become twice as bright; the bright third of them shows it.
    const std::vector<float> before = picture(50.0f, 10.0f, 10.0f);
    const std::vector<float> after = picture(100.0f, 20.0f, 20.0f);
    const double shown =
        change_shown(picture(100.0f, 10.0f, 10.0f), exact(before), exact(after), size).brighter;
    EXPECT_NEAR(shown, 1.0 / 3.0, 0.02); // a little more, for the floor
}

TEST(ChangeShown, ReferencesMayHaveNoise) {
    std::mt19937 random(3);
    const std::vector<float> before = picture(1.0f, 3.0f, 2.0f), after = picture(2.0f, 2.0f, 2.0f);
    constexpr double sigma = 0.3;
    for (const float weight : {0.0f, 0.5f, 1.0f}) {
        const std::vector<float> seen = mix(before, after, weight);
        double sum = 0.0, squares = 0.0;
        constexpr int experiments = 20;
        for (int i = 0; i < experiments; ++i) {
            const ChangeShown shown =
                change_shown(seen, noisy(before, sigma, random), noisy(after, sigma, random), size);
            sum += shown.brighter;
            squares += shown.brighter * shown.brighter;
        }
        const double mean = sum / experiments;
        const double error = std::sqrt((squares / experiments - mean * mean) / experiments);
        EXPECT_LT(error, 0.01);
        EXPECT_NEAR(mean, weight, 4.0 * error) << weight;
    }
}

TEST(ChangeShown, ChangesThatAreSmallOrUnsureDoNotCount) {
    const std::vector<float> before = picture(1.0f, 1.0f, 1.0f);
    const auto shown = [&](const Reference& a, const Reference& b) {
        return change_shown(before, a, b, size).brighter;
    };
    EXPECT_TRUE(std::isnan(shown(exact(before), exact(picture(1.09f, 1.09f, 1.09f)))));
    EXPECT_NEAR(shown(exact(before), exact(picture(1.2f, 1.2f, 1.2f))), 0.0, 1e-6);
    // Less than three times the error of it.
    std::mt19937 random(8);
    EXPECT_TRUE(std::isnan(
        shown(noisy(before, 0.4, random), noisy(picture(1.2f, 1.2f, 1.2f), 0.4, random))));
}

TEST(ChangeShown, NoiseOfThePictureAveragesOut) {
    std::mt19937 random(4);
    const std::vector<float> before = picture(1.0f, 1.0f, 1.0f), after = picture(2.0f, 2.0f, 2.0f);
    std::vector<float> seen = mix(before, after, 0.5f);
    std::exponential_distribution<float> light(1.0f);
    for (float& value : seen)
        value *= light(random); // of mean 1, deviation 1
    const double error = 1.5 / std::sqrt(static_cast<double>(values));
    EXPECT_NEAR(change_shown(seen, exact(before), exact(after), size).brighter, 0.5, 4.0 * error);
}

TEST(Lag, IsTheFirstFrameThatShowsNineTenths) {
    EXPECT_EQ(lag_of(std::vector<double>{0.95, 1.0}), 1.0);
    EXPECT_EQ(lag_of(std::vector<double>{0.3, 0.7, 0.899, 0.9, 0.8}), 4.0);
    EXPECT_EQ(lag_of(std::vector<double>{0.3, 0.7, 0.8}), 4.0); // later
    EXPECT_TRUE(std::isnan(lag_of(std::vector<double>{0.3, nothing, 1.0})));
}

} // namespace vigil::bench
