// SPDX-License-Identifier: GPL-2.0-or-later
// References: mean and variance from batches, a number of batches that their own values do not
// decide, and files from which an interrupted run goes on.
#include "bench/reference.h"

#include "common/scratch_folder.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <gtest/gtest.h>
#include <random>
#include <utility>
#include <vector>

namespace vigil::bench {

namespace {

std::vector<float> batch(int number) {
    std::mt19937 random(number);
    std::vector<float> picture(6);
    for (float& value : picture)
        value = static_cast<float>(random() % 1000);
    return picture;
}

Reference reference_of(int first, int last, Reference reference = Reference(6)) {
    for (int number = first; number < last; ++number)
        reference.add(batch(number));
    return reference;
}

} // namespace

TEST(Reference, MeanAndVarianceAreThoseOfTheBatches) {
    const Reference reference = reference_of(0, 5);
    double mean_variance = 0.0;
    for (std::size_t i = 0; i < 6; ++i) {
        double sum = 0.0, squares = 0.0;
        for (int number = 0; number < 5; ++number)
            sum += static_cast<double>(batch(number)[i]);
        for (int number = 0; number < 5; ++number)
            squares += std::pow(static_cast<double>(batch(number)[i]) - sum / 5.0, 2.0);
        EXPECT_NEAR(reference.mean(i), sum / 5.0, 1e-9);
        EXPECT_NEAR(reference.variance(i), squares / (5.0 * 4.0), 1e-7);
        mean_variance += reference.variance(i) / 6.0;
    }
    EXPECT_NEAR(reference.mean_variance(), mean_variance, 1e-7);
}

TEST(Reference, PictureMeanHasTheErrorOfBatchMeans) {
    Reference reference(2);
    reference.add(std::vector<float>{1.0f, 3.0f}); // mean 2
    reference.add(std::vector<float>{4.0f, 4.0f}); // mean 4
    EXPECT_DOUBLE_EQ(reference.picture_mean(), 3.0);
    EXPECT_DOUBLE_EQ(reference.picture_mean_error(), 1.0);
}

TEST(Reference, GoesOnFromItsFileAsIfItHadNotStopped) {
    const test::ScratchFolder folder;
    const std::filesystem::path path = folder.path() / "cache" / "reference.bin";
    reference_of(0, 3).save(path, "this view");
    Reference resumed(6);
    ASSERT_TRUE(resumed.load(path, "this view"));
    EXPECT_EQ(resumed.batches(), 3);
    resumed = reference_of(3, 5, std::move(resumed));
    const Reference whole = reference_of(0, 5);
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_EQ(resumed.mean(i), whole.mean(i));
        EXPECT_EQ(resumed.variance(i), whole.variance(i));
    }
    EXPECT_EQ(resumed.picture_mean_error(), whole.picture_mean_error());
}

TEST(Reference, GetsAsManyBatchesAsThePilotAsksFor) {
    Reference pilot(1);
    for (const float value : {1.0f, 2.0f, 3.0f})
        pilot.add(std::vector<float>{value});
    // The variance of a batch is 1.
    EXPECT_EQ(batches_for(pilot, 0.1, 100), 10);
    EXPECT_EQ(batches_for(pilot, 0.099, 100), 11);
    EXPECT_EQ(batches_for(pilot, 0.001, 100), 100);
    EXPECT_EQ(batches_for(pilot, 0.0, 100), 100);
    EXPECT_EQ(batches_for(pilot, -1.0, 100), 100);
    EXPECT_EQ(batches_for(pilot, 50.0, 100), 2);
}

TEST(Reference, AsksForBatchesOnceAndTakesNoneOfThePilot) {
    Reference pilot(6), reference(6);
    std::vector<int> numbers;
    int asked = 0, added_to_pilot = 0;
    const ReferenceSource source = {[&](int number) {
                                        numbers.push_back(number);
                                        return batch(number);
                                    },
                                    [&](const Reference& complete) {
                                        ++asked;
                                        EXPECT_EQ(complete.batches(), pilot_batches);
                                        return 5;
                                    },
                                    [&](bool is_pilot) { added_to_pilot += is_pilot ? 1 : 0; }};
    complete_reference(pilot, reference, source);
    EXPECT_EQ(asked, 1);
    EXPECT_EQ(added_to_pilot, pilot_batches);
    const Reference same = reference_of(0, 5);
    ASSERT_EQ(reference.batches(), 5);
    for (std::size_t i = 0; i < 6; ++i)
        EXPECT_EQ(reference.mean(i), same.mean(i));
    for (int i = 0; i < pilot_batches; ++i)
        EXPECT_EQ(numbers[static_cast<std::size_t>(i)], first_pilot_number + i);
    // Again, from what there is: nothing is rendered.
    numbers.clear();
    complete_reference(pilot, reference, source);
    EXPECT_TRUE(numbers.empty());
}

TEST(Reference, IsNotDarkerBecauseItStopsWhenItLooksGood) {
    // One batch in ten has light that makes a third of the mean. Its variance looks small until one
    // comes, so a reference that stopped by its own batches would have too few of them.
    std::mt19937 random(3);
    constexpr double truth = 1.5;
    const auto light = [&] { return random() % 10 == 0 ? 6.0f : 1.0f; };
    const auto source_of = [&](std::function<int(const Reference&)> wanted) {
        return ReferenceSource{[&](int) {
                                   return std::vector<float>{
                                       light() + 0.01f * static_cast<float>(random() % 5)};
                               },
                               std::move(wanted), [](bool) {}};
    };
    constexpr double noise = 0.02; // mean of what is added above
    constexpr int experiments = 4000;
    double sum = 0.0, squares = 0.0, variances = 0.0, early = 0.0;
    for (int i = 0; i < experiments; ++i) {
        Reference pilot(1), reference(1);
        complete_reference(pilot, reference, source_of([](const Reference& complete) {
                               return std::max(pilot_batches, batches_for(complete, 0.02, 200));
                           }));
        sum += reference.mean(0);
        squares += reference.mean(0) * reference.mean(0);
        variances += reference.mean_variance() - std::pow(reference.mean(0) - truth - noise, 2.0);
        // The same, stopping by what is kept.
        Reference own(1);
        while (own.batches() < pilot_batches || (own.mean_variance() > 0.02 && own.batches() < 200))
            own.add(std::vector<float>{light()});
        early += own.mean(0) / experiments;
    }
    const double mean = sum / experiments;
    const double error = std::sqrt((squares / experiments - mean * mean) / experiments);
    EXPECT_NEAR(mean, truth + noise, 4.0 * error);
    EXPECT_LT(error, 0.01 * truth); // or the line above would say nothing
    // Its variance is what it says, too: that is taken off every error.
    EXPECT_NEAR(variances / experiments, 0.0, 0.02);
    EXPECT_LT(early, 0.9 * truth); // the simulation has the bias that this is about
}

TEST(Reference, RefusesFilesOfSomethingElse) {
    const test::ScratchFolder folder;
    const std::filesystem::path path = folder.path() / "reference.bin";
    Reference reference(6);
    EXPECT_FALSE(reference.load(path, "key")); // no file
    reference_of(0, 3).save(path, "key");
    EXPECT_FALSE(reference.load(path, "yek"));
    EXPECT_FALSE(reference.load(path, "longer key"));
    Reference larger(7);
    EXPECT_FALSE(larger.load(path, "key"));
    std::filesystem::resize_file(path, std::filesystem::file_size(path) - 1);
    EXPECT_FALSE(reference.load(path, "key"));
    std::filesystem::resize_file(path, 20);
    EXPECT_FALSE(reference.load(path, "key"));
    EXPECT_EQ(reference.batches(), 0);

    // A wrong number would be measured against as if it were right.
    reference_of(0, 3).save(path, "key");
    std::fstream file(path, std::ios::binary | std::ios::in | std::ios::out);
    file.seekp(-20, std::ios::end).put('x');
    file.close();
    EXPECT_FALSE(reference.load(path, "key"));
    EXPECT_EQ(reference.batches(), 0);
}

} // namespace vigil::bench
