// SPDX-License-Identifier: GPL-2.0-or-later
// Do two renderers of the same picture have the same mean? Pictures come in independent batches
// (one seed each); blocks of pixels are compared by Welch's t, which becomes a standard normal
// score by Wallace's (1959) approximation (error below 0.02 at the degrees of freedom that 16
// batches give). Nothing here knows a GPU.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace vigil::test {

/// Batches of one renderer: blocks of a picture, per colour channel.
class PictureBatches {
public:
    /// Pictures of width x height pixels are averaged over blocks of block x block pixels; what
    /// does not fill a block at the right and the bottom is left out.
    PictureBatches(int width, int height, int block);

    /// Adds one batch: RGB floats, rows from the top.
    void add(std::span<const float> rgb);

    std::size_t batches() const { return values_.size(); }
    std::size_t blocks() const { return blocks_x_ * blocks_y_; }
    std::size_t blocks_x() const { return blocks_x_; }
    std::size_t blocks_y() const { return blocks_y_; }
    /// A block's value in a batch; `channel` 0..2.
    double value(std::size_t batch, std::size_t channel, std::size_t block) const {
        return values_[batch][3 * block + channel];
    }
    double mean(std::size_t channel, std::size_t block) const;
    /// Means of all channels and blocks, in the order 3 * block + channel.
    std::vector<double> means() const;

    // To plant a bias into a copy.
    /// Shifts the batches so that these are the means.
    void set_means(std::span<const double> means);
    /// Multiplies some blocks, or everything, by a factor.
    void scale(double factor, std::span<const std::size_t> blocks);
    void scale(double factor);

private:
    std::size_t width_, block_, blocks_x_, blocks_y_;
    std::vector<std::vector<double>> values_; // by batch; 3 * block + channel
};

/// Groups of neighbouring blocks, so that a bias of a part of the picture adds up: the four
/// quadrants, and windows of a quarter of the picture's width and height that overlap by half.
std::vector<std::vector<std::size_t>> quadrants(const PictureBatches& picture);
std::vector<std::vector<std::size_t>> windows(const PictureBatches& picture);

/// What the scores of all blocks of one channel say. Blocks much darker than the others count as
/// one together: brute force finds too few lights from them to tell its noise. Under "same mean"
/// each score is standard normal and independent of the others, so four numbers are standard
/// normal too (all but the first one-sided; the last one at most, as its groups overlap).
struct Comparison {
    std::size_t blocks = 0;  // with any noise; blocks without noise must agree and are left out
    double bias_z = 0.0;     // sum of scores / sqrt(blocks): sensitive to a common bias
    double spread_z = 0.0;   // chi-square of the scores (Wilson-Hilferty): to differences anywhere
    double outlier_z = 0.0;  // number of |score| > 3, binomial: to a few wrong blocks
    double region_z = 0.0;   // largest |sum of scores| of quadrants and windows: to a wrong region
    double bias = 0.0;       // estimate of a common relative bias
    double bias_error = 0.0; // its standard error
    std::size_t unequal = 0; // blocks without noise that differ
    std::vector<double> scores; // by block; NaN: it is not judged alone
    /// The largest of the four, |bias_z| among them; infinite if any are unequal.
    double worst() const;
    bool agrees(double limit) const { return worst() < limit; }
    /// The common relative bias that has a score of score_limit: half of such are found.
    double found_from() const;
    std::string text() const;
};

/// What a score may reach. Beyond 5 lies 2.9e-7 of the normal distribution on each side. The GPU
/// tests make about 4,100 scores (340 comparisons, three channels, four scores), a quarter of them
/// two-sided. A sound renderer fails one with a probability of 1.5e-3 at most per choice of seeds.
/// Seeds are fixed, so that a failure stays. But techniques that learn see what threads store
/// first, which differs from run to run.
inline constexpr double score_limit = 5.0;

Comparison compare(const PictureBatches& a, const PictureBatches& b, std::size_t channel);

/// Scores of known values per channel and block (order 3 * block + channel) against batches.
Comparison compare(const PictureBatches& a, std::span<const double> expected, std::size_t channel);

/// Standard normal score of Student's t.
double score_of_t(double t, double freedom);

} // namespace vigil::test
