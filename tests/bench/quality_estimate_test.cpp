// SPDX-License-Identifier: GPL-2.0-or-later
// Intervals cover what they claim to, over many synthetic experiments with a known truth; errors
// that were planted in pictures are found again although the reference is noisy.
#include "bench/quality_estimate.h"

#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <random>

namespace vigil::bench {

namespace {

constexpr int views = 4;
constexpr int seeds = 8;

using Random = std::mt19937;

double normal(Random& random, double mean = 0.0, double deviation = 1.0) {
    return std::normal_distribution<double>(mean, deviation)(random);
}

/// Share of experiments whose interval holds the truth.
double coverage(double truth, const std::function<Interval(Random&)>& experiment) {
    Random random(5);
    constexpr int experiments = 1500;
    int covered = 0;
    for (int i = 0; i < experiments; ++i) {
        const Interval interval = experiment(random);
        covered += interval.low <= truth && truth <= interval.high;
    }
    return covered / static_cast<double>(experiments);
}

/// Four standard errors of a share of 95% over the experiments of coverage().
constexpr double tolerance = 0.0225;

Strata constant(double value) {
    return Strata(views, std::vector<double>(seeds, value));
}

} // namespace

TEST(Intervals, OfAProductAddTheirLogarithms) {
    const Interval result = product({2.0, 1.0, 4.0}, {3.0, 3.0, 3.0});
    EXPECT_DOUBLE_EQ(result.value, 6.0);
    EXPECT_DOUBLE_EQ(result.low, 3.0);
    EXPECT_DOUBLE_EQ(result.high, 12.0);
    const double three_four_five =
        product({1.0, std::exp(-3.0), std::exp(3.0)}, {1.0, std::exp(-4.0), std::exp(4.0)}).high;
    EXPECT_NEAR(std::log(three_four_five), 5.0, 1e-12);
    EXPECT_TRUE(std::isnan(product({1.0, NAN, NAN}, {1.0, 0.5, 2.0}).low));
}

TEST(PictureError, KnowsTheBrightPart) {
    // Ten pixels of which one is bright; errors of 1 there and 2 elsewhere.
    Reference reference(30);
    std::vector<float> picture(30, 1.0f);
    std::fill_n(picture.begin(), 3, 100.0f);
    reference.add(picture);
    reference.add(picture);
    for (std::size_t i = 0; i < picture.size(); ++i)
        picture[i] += i < 3 ? 1.0f : 2.0f;
    EXPECT_DOUBLE_EQ(picture_error(picture, reference).bright_mse, 1.0);
    Reference even(30);
    even.add(std::vector<float>(30, 1.0f));
    even.add(std::vector<float>(30, 1.0f));
    EXPECT_TRUE(std::isnan(picture_error(picture, even).bright_mse));
}

TEST(StudentT, AgreesWithPublishedTables) {
    EXPECT_NEAR(student_t_quantile(0.975, 1.0), 12.706205, 1e-4);
    EXPECT_NEAR(student_t_quantile(0.975, 3.0), 3.182446, 1e-5);
    EXPECT_NEAR(student_t_quantile(0.975, 10.0), 2.228139, 1e-5);
    EXPECT_NEAR(student_t_quantile(0.95, 28.0), 1.701131, 1e-5);
    EXPECT_NEAR(student_t_quantile(0.975, 1e4), 1.960201, 1e-4);
    EXPECT_NEAR(student_t_quantile(0.975, 1e6), 1.959966, 1e-5);
    EXPECT_NEAR(student_t_quantile(0.025, 3.0), -3.182446, 1e-5);
}

TEST(MeanInterval, CoversAtTheStatedRateWithUnequalViews) {
    const double truth = (1.0 + 2.0 + 3.0 + 4.0) / views;
    const double rate = coverage(truth, [](Random& random) {
        Strata values = constant(0.0);
        for (int view = 0; view < views; ++view)
            for (double& value : values[view])
                value = normal(random, 1.0 + view, 0.1 * std::pow(3.0, view));
        return mean_interval(values);
    });
    EXPECT_NEAR(rate, 0.95, tolerance);
}

TEST(MeanInterval, KnowsWhatItCannotKnow) {
    const Interval single = mean_interval({{1.0}, {2.0}});
    EXPECT_EQ(single.value, 1.5);
    EXPECT_TRUE(std::isnan(single.low) && std::isnan(single.high));
    const Interval exact = mean_interval(constant(2.0));
    EXPECT_EQ(exact.low, 2.0);
    EXPECT_EQ(exact.high, 2.0);
}

TEST(RatioInterval, CoversAtTheStatedRateForPairs) {
    // Each seed multiplies both techniques' errors by the same luck, and each by some of its own.
    const double rate = coverage(0.25, [](Random& random) {
        Strata above = constant(0.0), below = constant(0.0);
        for (int view = 0; view < views; ++view) {
            for (int seed = 0; seed < seeds; ++seed) {
                const double common = normal(random, 1.0 + view, 0.2);
                above[view][seed] = 0.25 * common * normal(random, 1.0, 0.1);
                below[view][seed] = common * normal(random, 1.0, 0.1);
            }
        }
        return ratio_interval(above, below);
    });
    EXPECT_NEAR(rate, 0.95, tolerance);
}

TEST(RatioInterval, PairingTakesOutWhatTwoTechniquesShare) {
    Strata above = constant(0.0), below = constant(0.0);
    Random random(1);
    for (int view = 0; view < views; ++view)
        for (int seed = 0; seed < seeds; ++seed)
            above[view][seed] = 3.0 * (below[view][seed] = std::exp(normal(random)));
    const Interval ratio = ratio_interval(above, below);
    EXPECT_NEAR(ratio.value, 3.0, 1e-12);
    EXPECT_NEAR(ratio.low, 3.0, 1e-9);
    EXPECT_NEAR(ratio.high, 3.0, 1e-9);
}

TEST(RatioInterval, HasNoIntervalWhereAnErrorIsNotPositive) {
    const Interval ratio = ratio_interval(constant(-1.0), constant(2.0));
    EXPECT_EQ(ratio.value, -0.5);
    EXPECT_TRUE(std::isnan(ratio.low));
}

TEST(RatioOverViews, CoversOtherViews) {
    // The truth is the geometric mean of all views there could be.
    const double rate = coverage(2.0, [](Random& random) {
        Strata above = constant(0.0);
        for (std::vector<double>& view : above) {
            const double ratio = 2.0 * std::exp(normal(random, 0.0, 0.7));
            for (double& value : view)
                value = ratio;
        }
        return ratio_over_views(above, constant(1.0));
    });
    EXPECT_NEAR(rate, 0.95, tolerance);
}

TEST(MedianRatio, CoversAndDoesNotMindInterruptions) {
    const double rate = coverage(1.05, [](Random& random) {
        Strata above = constant(0.0), below = constant(0.0);
        const auto interruption = [&] { return random() % 8 == 0 ? 5.0 : 1.0; };
        for (int view = 0; view < views; ++view) {
            for (int seed = 0; seed < seeds; ++seed) {
                above[view][seed] = 1.05 * normal(random, 10.0, 0.2) * interruption();
                below[view][seed] = normal(random, 10.0, 0.2) * interruption();
            }
        }
        return median_ratio(above, below);
    });
    EXPECT_GE(rate, 0.95 - tolerance); // order statistics cannot hit 95% exactly: 96.5% of 32 pairs
    EXPECT_LE(rate, 0.965 + tolerance);
}

TEST(MedianRatio, NeedsSixPairs) {
    EXPECT_TRUE(std::isnan(median_ratio({{1, 2, 3, 4, 5}}, {{1, 1, 1, 1, 1}}).low));
    const Interval six = median_ratio({{1, 2, 3, 4, 5, 6}}, {{1, 1, 1, 1, 1, 1}});
    EXPECT_EQ(six.value, 3.5);
    EXPECT_EQ(six.low, 1.0);
    EXPECT_EQ(six.high, 6.0);
}

TEST(Widened, AddsIndependentErrors) {
    const Interval wider = widened({10.0, 10.0 - 3.0, 10.0 + 3.0}, 4.0 / 1.959964);
    EXPECT_NEAR(wider.low, 5.0, 1e-6);
    EXPECT_NEAR(wider.high, 15.0, 1e-6);
}

TEST(MissesLight, WhereAViewLacksMoreThanChanceExplains) {
    const std::vector<double> complete = {1.01, 0.98, 1.02, 0.99};
    EXPECT_FALSE(misses_light({complete, {0.97, 0.98, 0.97, 0.98}})); // lacks little
    EXPECT_TRUE(misses_light({complete, {0.51, 0.5, 0.52, 0.5}}));
    EXPECT_FALSE(misses_light({complete, {0.5, 0.5, 3.0, 0.5}})); // one frame met it
    EXPECT_FALSE(misses_light({{0.5}, {0.5}}));                   // one seed says nothing
}

TEST(MissesLight, TellsIntervalsThatWouldBeFarTooNarrow) {
    // One frame in 50 meets light that makes half of the mean, and all of the error.
    Random random(11);
    constexpr double share = 0.02;
    std::bernoulli_distribution meets(share);
    const double truth = 0.25 / share;
    int narrow = 0, told = 0;
    for (int experiment = 0; experiment < 2000; ++experiment) {
        Strata mean_ratio(4), mse(4);
        for (int view = 0; view < 4; ++view)
            for (int seed = 0; seed < 4; ++seed) {
                const bool met = meets(random);
                mean_ratio[view].push_back(normal(random, met ? 0.5 + 0.5 / share : 0.5, 0.01));
                mse[view].push_back(normal(random, met ? 0.25 / (share * share) : 0.01, 0.001));
            }
        if (mean_interval(mse).high > truth) continue;
        ++narrow;
        told += misses_light(mean_ratio) ? 1 : 0;
    }
    EXPECT_GT(narrow, 1000);
    EXPECT_EQ(told, narrow);
}

TEST(PictureErrors, PlantedErrorIsFoundDespiteANoisyReference) {
    // The reference's own variance is half of the error that was planted; without taking it off,
    // the result would be 50% too large.
    constexpr std::size_t values = 300;
    constexpr int batches = 8;
    constexpr double deviation = 0.3;
    const double batch_deviation = deviation * std::sqrt(0.5 * batches);
    Random random(3);
    std::vector<double> truth(values);
    for (double& value : truth)
        value = 1.0 + normal(random, 0.0, 0.2);
    double sum = 0.0, squares = 0.0;
    constexpr int experiments = 400;
    for (int i = 0; i < experiments; ++i) {
        Reference reference(values);
        std::vector<float> picture(values);
        const auto draw = [&](double spread) {
            for (std::size_t j = 0; j < values; ++j)
                picture[j] = static_cast<float>(truth[j] + normal(random, 0.0, spread));
        };
        for (int batch = 0; batch < batches; ++batch) {
            draw(batch_deviation);
            reference.add(picture);
        }
        draw(deviation);
        const PictureError error = picture_error(picture, reference);
        sum += error.mse;
        squares += error.mse * error.mse;
    }
    const double mean = sum / experiments;
    const double error = std::sqrt((squares / experiments - mean * mean) / experiments);
    EXPECT_NEAR(mean, deviation * deviation, 4.0 * error);
    EXPECT_LT(error, 0.02 * mean); // or the line above would say nothing
}

TEST(PictureErrors, AreExactOnAnExactReference) {
    Reference reference(3);
    for (int batch = 0; batch < 2; ++batch)
        reference.add(std::vector<float>{1.0f, 2.0f, 3.0f});
    const PictureError error = picture_error(std::vector<float>{2.0f, 2.0f, 5.0f}, reference);
    EXPECT_DOUBLE_EQ(error.mse, 5.0 / 3.0);
    EXPECT_DOUBLE_EQ(relative_floor(reference), 0.2 * 0.2);
    EXPECT_DOUBLE_EQ(error.relative_mse, (1.0 / 1.04 + 4.0 / 9.04) / 3.0);
    EXPECT_DOUBLE_EQ(error.mean_ratio, 1.5);
    EXPECT_DOUBLE_EQ(relative_variance(reference), 0.0);
}

TEST(PictureErrors, FireflyIsTrimmed) {
    constexpr std::size_t pixels = 2000; // of which two are left out
    Reference reference(3 * pixels);
    std::vector<float> picture(3 * pixels, 1.0f);
    reference.add(picture);
    reference.add(picture);
    for (std::size_t i = 0; i < picture.size(); ++i)
        picture[i] = i % 2 == 0 ? 1.5f : 0.5f;
    picture[300] = 1000.0f;
    const PictureError error = picture_error(picture, reference);
    EXPECT_GT(error.mse, 100.0);
    EXPECT_DOUBLE_EQ(error.trimmed_mse, 0.25);
    EXPECT_EQ(error.trimmed_variance, 0.0);
    // Equal errors are no fireflies.
    EXPECT_DOUBLE_EQ(picture_error(std::vector<float>(3 * pixels, 1.0f), reference).trimmed_mse,
                     0.0);
}

TEST(Settle, FindsTheFrameAfterWhichNothingIsAbove) {
    const std::vector<double> curve = {9.0, 3.0, 1.05, 1.3, 1.09, 1.0, 1.0, 1.0, 1.0};
    const Settled settled = settle(curve, 4, 1.1);
    EXPECT_DOUBLE_EQ(settled.level, 1.0);
    EXPECT_EQ(settled.frame, 5); // frame 3 was low, but frame 4 not
}

TEST(Settle, SaysWhenNothingHasSettled) {
    const std::vector<double> falling = {5.0, 4.0, 1.0, 3.0};
    EXPECT_EQ(settle(falling, 2, 1.1).frame, 5);
    EXPECT_EQ(stays_below(falling, 0.0), static_cast<int>(falling.size()) + 1);
    EXPECT_EQ(settle(std::vector<double>(4, 1.0), 8, 1.1).frame, 1);
}

} // namespace vigil::bench
