// SPDX-License-Identifier: GPL-2.0-or-later
// References: mean and variance from batches, and files from which an interrupted run goes on.
#include "bench/reference.h"

#include "common/scratch_folder.h"

#include <cmath>
#include <fstream>
#include <gtest/gtest.h>
#include <random>

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
