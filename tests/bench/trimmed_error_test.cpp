// SPDX-License-Identifier: GPL-2.0-or-later
// The trimmed error leaves out exactly the share of pixels that it says, and the reference's own
// variance is taken off what is left.
#include "bench/quality_estimate.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <vector>

namespace vigil::bench {

namespace {

/// A reference of 1 everywhere, without an error of its own.
Reference even_reference(std::size_t pixels) {
    Reference reference(3 * pixels);
    for (int batch = 0; batch < 2; ++batch)
        reference.add(std::vector<float>(3 * pixels, 1.0f));
    return reference;
}

} // namespace

TEST(TrimmedError, LeavesOutOnePixelInAThousand) {
    for (const std::size_t pixels : {1000u, 2000u, 10000u}) {
        const Reference reference = even_reference(pixels);
        const std::size_t left_out = pixels / 1000;
        std::vector<float> picture(3 * pixels, 1.5f); // an error of 0.25 everywhere
        for (std::size_t i = 0; i < left_out; ++i)
            picture[3 * i + 1] = 1000.0f + static_cast<float>(i);
        EXPECT_DOUBLE_EQ(picture_error(picture, reference).trimmed_mse, 0.25) << pixels;
        // One firefly more, of an error of 100 in one of three channels.
        picture[3 * left_out] = 11.0f;
        const auto kept = static_cast<double>(3 * (pixels - left_out));
        EXPECT_NEAR(picture_error(picture, reference).trimmed_mse, 0.25 + 99.75 / kept, 1e-9)
            << pixels;
    }
}

TEST(TrimmedError, IsWithoutTheReferencesVarianceAsTheWholeErrorIs) {
    // The reference is as noisy as the picture: with its variance errors would be twice as large.
    constexpr std::size_t values = 3000;
    constexpr double deviation = 0.3;
    std::mt19937 random(4);
    std::normal_distribution<double> noise;
    std::vector<float> picture(values);
    const auto draw = [&](double spread) {
        for (float& value : picture)
            value = static_cast<float>(1.0 + spread * noise(random));
    };
    double difference = 0.0, sum = 0.0;
    constexpr int experiments = 30;
    for (int experiment = 0; experiment < experiments; ++experiment) {
        Reference reference(values);
        for (int batch = 0; batch < 4; ++batch) {
            draw(2.0 * deviation);
            reference.add(picture);
        }
        draw(deviation);
        const PictureError error = picture_error(picture, reference);
        double total = 0.0, largest = 0.0; // squared distances of pixels
        for (std::size_t pixel = 0; pixel < values / 3; ++pixel) {
            double distance = 0.0;
            for (std::size_t i = 3 * pixel; i < 3 * pixel + 3; ++i)
                distance += std::pow(static_cast<double>(picture[i]) - reference.mean(i), 2.0);
            total += distance;
            largest = std::max(largest, distance);
        }
        const double whole = total / static_cast<double>(values) - reference.mean_variance();
        const double trimmed =
            (total - largest) / static_cast<double>(values - 3) - error.trimmed_variance;
        difference = std::max(
            {difference, std::abs(error.mse - whole), std::abs(error.trimmed_mse - trimmed)});
        sum += error.trimmed_mse;
        EXPECT_NEAR(error.trimmed_variance, reference.mean_variance(),
                    0.01 * deviation * deviation);
    }
    EXPECT_LT(difference, 1e-9);
    EXPECT_NEAR(sum / experiments, deviation * deviation, 0.05 * deviation * deviation);
}

} // namespace vigil::bench
