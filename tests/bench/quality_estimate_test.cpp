// SPDX-License-Identifier: GPL-2.0-or-later
// Statistics of measurements, and errors that were planted in pictures and are found again although
// the reference is noisy. How often intervals hold the truth is in coverage_test.cpp.
#include "bench/quality_estimate.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <vector>

namespace vigil::bench {

namespace {

constexpr int views = 4;
constexpr int seeds = 8;

using Random = std::mt19937;

double normal(Random& random, double mean = 0.0, double deviation = 1.0) {
    return std::normal_distribution<double>(mean, deviation)(random);
}

Strata constant(double value) {
    return Strata(views, std::vector<double>(seeds, value));
}

} // namespace

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

TEST(Means, AreOfTheViewsMeans) {
    EXPECT_DOUBLE_EQ(mean_over_views({{1.0}, {2.0, 4.0}}), 2.0);
    EXPECT_DOUBLE_EQ(ratio_of_means({{1.0}, {2.0, 4.0}}, {{4.0}, {4.0, 4.0}}), 0.5);
    EXPECT_TRUE(std::isnan(ratio_of_means(constant(-1.0), constant(2.0))));
    EXPECT_TRUE(std::isnan(ratio_of_means(constant(1.0), constant(0.0))));
}

TEST(MedianInterval, AgreesWithPublishedRanks) {
    // The table of the sign test: two-sided 95%, from below and from above.
    const auto rank_of = [](int count) {
        std::vector<double> values(static_cast<std::size_t>(count));
        for (int i = 0; i < count; ++i)
            values[static_cast<std::size_t>(i)] = i + 1;
        std::ranges::reverse(values); // order is of no importance
        const Interval interval = median_interval(values);
        EXPECT_EQ(interval.value, 0.5 * (count + 1));
        if (!std::isnan(interval.low)) {
            EXPECT_EQ(interval.low + interval.high, count + 1.0);
        }
        return interval.low;
    };
    EXPECT_TRUE(std::isnan(rank_of(5)));
    EXPECT_EQ(rank_of(6), 1.0);
    EXPECT_EQ(rank_of(8), 1.0);
    EXPECT_EQ(rank_of(9), 2.0);
    EXPECT_EQ(rank_of(16), 4.0);
    EXPECT_EQ(rank_of(24), 7.0);
    EXPECT_EQ(rank_of(32), 10.0);
}

TEST(TypicalRun, NeedsFourViewsForAnInterval) {
    const std::vector<double> view = {1.0, 2.0, 3.0};
    const Interval three = typical_run({view, view, view});
    EXPECT_EQ(three.value, 2.0);
    EXPECT_TRUE(std::isnan(three.low) && std::isnan(three.high));
    const Interval four = typical_run({view, view, view, view});
    EXPECT_EQ(four.low, 1.0);
    EXPECT_EQ(four.high, 3.0);
    EXPECT_TRUE(std::isnan(typical_run({{1.0, NAN}, {2.0}, {3.0}, {4.0}}).value));
}

TEST(TypicalRatio, PairingTakesOutWhatTwoTechniquesShare) {
    Strata above = constant(0.0), below = constant(0.0);
    Random random(1);
    for (int view = 0; view < views; ++view)
        for (int seed = 0; seed < seeds; ++seed)
            above[view][seed] = 3.0 * (below[view][seed] = std::exp(normal(random)));
    const Comparison ratio = typical_ratio(above, below);
    EXPECT_NEAR(ratio.ratio.value, 3.0, 1e-12);
    EXPECT_NEAR(ratio.ratio.low, 3.0, 1e-9);
    EXPECT_NEAR(ratio.ratio.high, 3.0, 1e-9);
    EXPECT_NEAR(ratio.p, 2.0 * std::pow(0.5, 32), 1e-15);
}

TEST(TypicalRatio, HasTheChanceOfTheSignTest) {
    // 8 pairs of which 7 are above 1: 2 (1 + 8) / 2^8. One that is 1 speaks for neither.
    const Strata ones(4, {1.0, 1.0});
    EXPECT_NEAR(typical_ratio({{2, 2}, {2, 2}, {2, 2}, {2, 0.5}}, ones).p, 18.0 / 256.0, 1e-12);
    EXPECT_NEAR(typical_ratio({{2, 2}, {2, 2}, {2, 2}, {2, 1}}, ones).p, 18.0 / 256.0, 1e-12);
    EXPECT_NEAR(typical_ratio({{0.5, 0.5}, {0.5, 0.5}, {0.5, 0.5}, {0.5, 0.5}}, ones).p,
                2.0 / 256.0, 1e-12);
    EXPECT_EQ(typical_ratio(ones, ones).p, 1.0);
    EXPECT_EQ(typical_ratio({{2, 2}, {2, 2}, {0.5, 0.5}, {0.5, 0.5}}, ones).p, 1.0);
}

TEST(TypicalRatio, IsUnknownWhereADenominatorIsNotPositive) {
    EXPECT_TRUE(std::isnan(typical_ratio(constant(1.0), constant(-2.0)).ratio.value));
    EXPECT_TRUE(std::isnan(typical_ratio(constant(1.0), constant(0.0)).p));
    EXPECT_EQ(typical_ratio(constant(-1.0), constant(2.0)).ratio.value, -0.5);
}

TEST(RatioOverViews, IsTheGeometricMeanOfTheViewsMedians) {
    const Strata below = {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {2, 2, 2}};
    const Strata above = {{1, 1, 100}, {4, 4, 0}, {1, 1, 1}, {8, 8, 8}};
    const Interval over = ratio_over_views(above, below);
    EXPECT_NEAR(over.value, 2.0, 1e-12);
    // Logarithms to base 2 are 0, 2, 0, 2: their deviation is 2 / sqrt(3).
    EXPECT_NEAR(std::log2(over.high / over.value), 3.182446 / std::sqrt(3.0), 1e-5);
    EXPECT_NEAR(over.low * over.high, 4.0, 1e-9);
    EXPECT_TRUE(std::isnan(ratio_over_views({{1}, {2}, {3}}, {{1}, {1}, {1}}).low));
}

TEST(RunningMeans, AreOfAsManyAsThereAre) {
    const std::vector<double> values = {4, 2, 0, 6};
    EXPECT_EQ(running_means(values, 1), values);
    EXPECT_EQ(running_means(values, 2), (std::vector<double>{4, 3, 1, 3}));
    EXPECT_EQ(running_means(values, 9), (std::vector<double>{4, 3, 2, 3}));
    EXPECT_TRUE(running_means({}, 2).empty());
}

TEST(RatioOverFlights, CountsAFlightOnce) {
    // Frames of a flight: as many as one likes make no interval without six flights.
    const Strata ones(50, std::vector<double>(5, 1.0));
    EXPECT_TRUE(std::isnan(ratio_over_flights(ones, ones).low));
    Strata above(3, std::vector<double>(6));
    for (std::size_t frame = 0; frame < 3; ++frame)
        for (std::size_t flight = 0; flight < 6; ++flight)
            above[frame][flight] = static_cast<double>(flight + 1 + 10 * frame);
    const Interval ratio = ratio_over_flights(above, Strata(3, std::vector<double>(6, 1.0)));
    EXPECT_EQ(ratio.value, 13.5);
    EXPECT_EQ(ratio.low, 11.0);
    EXPECT_EQ(ratio.high, 16.0);
}

TEST(StandsOut, GoesByHolm) {
    // 0.01 x 4 and 0.012 x 3 are below 0.05, 0.03 x 2 is not, so neither is what follows.
    const std::vector<double> p = {0.03, 0.01, NAN, 0.04, 0.012};
    EXPECT_EQ(stands_out(p), (std::vector<bool>{false, true, false, false, true}));
    EXPECT_EQ(stands_out(std::vector<double>{0.02, 0.02, 0.02}),
              (std::vector<bool>{false, false, false}));
    EXPECT_EQ(stands_out(std::vector<double>{0.02}), std::vector<bool>{true});
    EXPECT_TRUE(stands_out({}).empty());
}

TEST(Times, AreOfSingleRuns) {
    EXPECT_EQ(times({{1, 2}, {3}}, {{4, 5}, {6}}), (Strata{{4, 10}, {18}}));
}

TEST(MissesLight, WhereAViewLacksMoreThanChanceExplains) {
    const std::vector<double> complete = {1.01, 0.98, 1.02, 0.99};
    EXPECT_FALSE(misses_light({complete, {0.97, 0.98, 0.97, 0.98}})); // lacks little
    EXPECT_TRUE(misses_light({complete, {0.51, 0.5, 0.52, 0.5}}));
    EXPECT_FALSE(misses_light({complete, {0.5, 0.5, 3.0, 0.5}})); // one frame met it
    EXPECT_FALSE(misses_light({{0.5}, {0.5}}));                   // one seed says nothing
}

TEST(MissesLight, TellsMeansThatAreFarTooLow) {
    // One frame in 50 meets light that makes half of the mean, and all of the error.
    Random random(11);
    constexpr double share = 0.02;
    std::bernoulli_distribution meets(share);
    const double truth = 0.25 / share;
    int low = 0, told = 0;
    for (int experiment = 0; experiment < 2000; ++experiment) {
        Strata mean_ratio(4), mse(4);
        for (int view = 0; view < 4; ++view)
            for (int seed = 0; seed < 4; ++seed) {
                const bool met = meets(random);
                mean_ratio[view].push_back(normal(random, met ? 0.5 + 0.5 / share : 0.5, 0.01));
                mse[view].push_back(normal(random, met ? 0.25 / (share * share) : 0.01, 0.001));
            }
        if (mean_over_views(mse) > 0.5 * truth) continue;
        ++low;
        told += misses_light(mean_ratio) ? 1 : 0;
    }
    EXPECT_GT(low, 1000);
    EXPECT_EQ(told, low);
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
