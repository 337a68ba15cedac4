// SPDX-License-Identifier: GPL-2.0-or-later
#include "picture_comparison.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <limits>

namespace vigil::test {

namespace {

// Sums of many floats differ in their last digits without any noise.
constexpr double rounding = 2e-6;

/// The score beyond which lies this share of the standard normal distribution.
double score_of_tail(double tail) {
    double low = -9.0, high = 30.0;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (0.5 * std::erfc(middle / std::sqrt(2.0)) > tail ? low : high) = middle;
    }
    return low;
}

/// Standard normal score of the upper tail P(X >= count), X ~ Binomial(n, p).
double binomial_score(std::size_t count, std::size_t n, double p) {
    double below = 0.0; // P(X < count)
    for (std::size_t k = 0; k < count; ++k) {
        const double x = static_cast<double>(k), m = static_cast<double>(n);
        below += std::exp(std::lgamma(m + 1) - std::lgamma(x + 1) - std::lgamma(m - x + 1) +
                          x * std::log(p) + (m - x) * std::log1p(-p));
    }
    return score_of_tail(std::max(1.0 - below, 1e-15));
}

/// Standard normal score of the largest |score| among `count`, if each were independent of the
/// others: where they are not, it is on the safe side.
double score_of_largest(double largest, std::size_t count) {
    const double each = std::erfc(largest / std::sqrt(2.0));
    return score_of_tail(-std::expm1(static_cast<double>(count) * std::log1p(-each)));
}

/// Blocks below this share of the median of those that are not black are judged together.
constexpr double dark = 0.2;

struct Estimate {
    double mean, variance, freedom; // variance of the mean
};

Estimate estimate(const PictureBatches& batches, std::size_t channel,
                  std::span<const std::size_t> blocks) {
    const auto n = static_cast<double>(batches.batches()),
               size = static_cast<double>(blocks.size());
    std::vector<double> values(batches.batches());
    double mean = 0.0, squares = 0.0;
    for (std::size_t batch = 0; batch < values.size(); ++batch) {
        for (const std::size_t block : blocks)
            values[batch] += batches.value(batch, channel, block) / size;
        mean += values[batch] / n;
    }
    for (const double value : values)
        squares += (value - mean) * (value - mean);
    return {mean, squares / (n * (n - 1.0)), n - 1.0};
}

/// The groups of blocks that are judged: bright ones alone, dark ones together, black ones alone.
std::vector<std::vector<std::size_t>> group_blocks(std::span<const double> brightness) {
    std::vector<double> lit;
    for (const double value : brightness)
        if (value > 0.0) lit.push_back(value);
    if (lit.empty()) lit.push_back(0.0);
    std::nth_element(lit.begin(), lit.begin() + static_cast<std::ptrdiff_t>(lit.size() / 2),
                     lit.end());
    const double limit = dark * lit[lit.size() / 2];
    std::vector<std::vector<std::size_t>> groups(1);
    for (std::size_t block = 0; block < brightness.size(); ++block) {
        if (brightness[block] > 0.0 && brightness[block] < limit)
            groups.front().push_back(block);
        else
            groups.push_back({block});
    }
    if (groups.front().empty()) groups.erase(groups.begin());
    return groups;
}

using GroupEstimate = std::function<Estimate(std::span<const std::size_t>)>;

/// The largest |sum of scores| of a region of `picture`, as a score.
double region_score(const PictureBatches& picture, std::span<const double> scores) {
    double largest = 0.0;
    std::size_t count = 0;
    for (const auto& regions : {quadrants(picture), windows(picture)})
        for (const std::vector<std::size_t>& region : regions) {
            double sum = 0.0, n = 0.0;
            for (const std::size_t block : region) {
                if (std::isnan(scores[block])) continue;
                sum += scores[block];
                n += 1.0;
            }
            if (n == 0.0) continue;
            ++count;
            largest = std::max(largest, std::abs(sum) / std::sqrt(n));
        }
    return count > 0 ? score_of_largest(largest, count) : 0.0;
}

Comparison compare_groups(const PictureBatches& picture,
                          const std::vector<std::vector<std::size_t>>& groups,
                          const GroupEstimate& a, const GroupEstimate& b) {
    Comparison result;
    result.scores.resize(picture.blocks(), std::numeric_limits<double>::quiet_NaN());
    double sum = 0.0, squares = 0.0, signal = 0.0;
    std::size_t outliers = 0;
    for (const std::vector<std::size_t>& group : groups) {
        const Estimate x = a(group), y = b(group);
        const double size = 0.5 * (std::abs(x.mean) + std::abs(y.mean)), floor = rounding * size;
        const double difference = x.mean - y.mean;
        const double noise = x.variance + y.variance;
        if (noise <= floor * floor) {
            if (std::abs(difference) > 10.0 * floor) ++result.unequal;
            continue;
        }
        // Welch and Satterthwaite's degrees of freedom.
        const double freedom =
            noise * noise /
            (x.variance * x.variance / x.freedom + y.variance * y.variance / y.freedom);
        const double score = score_of_t(difference / std::sqrt(noise), freedom);
        if (group.size() == 1) result.scores[group.front()] = score;
        ++result.blocks;
        sum += score;
        squares += score * score;
        signal += size / std::sqrt(noise);
        outliers += std::abs(score) > 3.0 ? 1 : 0;
    }
    if (result.blocks == 0) return result;
    const double n = static_cast<double>(result.blocks), width = 2.0 / (9.0 * n);
    result.bias_z = sum / std::sqrt(n);
    result.spread_z = (std::cbrt(squares / n) - (1.0 - width)) / std::sqrt(width);
    result.outlier_z = binomial_score(outliers, result.blocks, std::erfc(3.0 / std::sqrt(2.0)));
    result.region_z = region_score(picture, result.scores);
    result.bias = sum / signal;
    result.bias_error = std::sqrt(n) / signal;
    return result;
}

} // namespace

PictureBatches::PictureBatches(int width, int height, int block)
    : width_(static_cast<std::size_t>(width)), block_(static_cast<std::size_t>(block)),
      blocks_x_(static_cast<std::size_t>(width / block)),
      blocks_y_(static_cast<std::size_t>(height / block)) {}

void PictureBatches::add(std::span<const float> rgb) {
    std::vector<double> values(3 * blocks());
    for (std::size_t y = 0; y < blocks_y_ * block_; ++y)
        for (std::size_t x = 0; x < blocks_x_ * block_; ++x)
            for (std::size_t c = 0; c < 3; ++c)
                values[3 * (y / block_ * blocks_x_ + x / block_) + c] +=
                    static_cast<double>(rgb[3 * (y * width_ + x) + c]);
    for (double& value : values)
        value /= static_cast<double>(block_ * block_);
    values_.push_back(std::move(values));
}

double PictureBatches::mean(std::size_t channel, std::size_t block) const {
    return estimate(*this, channel, std::span(&block, 1)).mean;
}

std::vector<double> PictureBatches::means() const {
    std::vector<double> means;
    for (std::size_t i = 0; i < 3 * blocks(); ++i)
        means.push_back(mean(i % 3, i / 3));
    return means;
}

void PictureBatches::set_means(std::span<const double> means) {
    const std::vector<double> before = this->means();
    for (std::vector<double>& batch : values_)
        for (std::size_t i = 0; i < batch.size(); ++i)
            batch[i] += means[i] - before[i];
}

void PictureBatches::scale(double factor, std::span<const std::size_t> blocks) {
    for (std::vector<double>& batch : values_)
        for (const std::size_t block : blocks)
            for (std::size_t c = 0; c < 3; ++c)
                batch[3 * block + c] *= factor;
}

void PictureBatches::scale(double factor) {
    for (std::vector<double>& batch : values_)
        for (double& value : batch)
            value *= factor;
}

std::vector<std::vector<std::size_t>> quadrants(const PictureBatches& picture) {
    std::vector<std::vector<std::size_t>> parts(4);
    for (std::size_t block = 0; block < picture.blocks(); ++block) {
        const std::size_t x = block % picture.blocks_x(), y = block / picture.blocks_x();
        parts[(2 * x >= picture.blocks_x() ? 1u : 0u) + (2 * y >= picture.blocks_y() ? 2u : 0u)]
            .push_back(block);
    }
    return parts;
}

std::vector<std::vector<std::size_t>> windows(const PictureBatches& picture) {
    const std::size_t width = (picture.blocks_x() + 3) / 4, height = (picture.blocks_y() + 3) / 4;
    const std::size_t step_x = std::max<std::size_t>(width / 2, 1),
                      step_y = std::max<std::size_t>(height / 2, 1);
    std::vector<std::vector<std::size_t>> found;
    for (std::size_t y = 0; y + height <= picture.blocks_y(); y += step_y)
        for (std::size_t x = 0; x + width <= picture.blocks_x(); x += step_x) {
            std::vector<std::size_t>& window = found.emplace_back();
            for (std::size_t i = 0; i < width * height; ++i)
                window.push_back((y + i / width) * picture.blocks_x() + x + i % width);
        }
    return found;
}

double Comparison::worst() const {
    if (unequal > 0) return std::numeric_limits<double>::infinity();
    return std::max({std::abs(bias_z), spread_z, outlier_z, region_z});
}

double Comparison::found_from() const {
    return score_limit * bias_error;
}

std::string Comparison::text() const {
    return fmt::format("{} blocks: bias {:+.2f}% +- {:.2f}% (score {:+.2f}; from {:.2f}% it is "
                       "found), spread {:+.2f}, outliers {:+.2f}, regions {:+.2f}, {} unequal",
                       blocks, 100.0 * bias, 100.0 * bias_error, bias_z, 100.0 * found_from(),
                       spread_z, outlier_z, region_z, unequal);
}

Comparison compare(const PictureBatches& a, const PictureBatches& b, std::size_t channel) {
    std::vector<double> brightness;
    for (std::size_t block = 0; block < a.blocks(); ++block)
        brightness.push_back(0.5 * (a.mean(channel, block) + b.mean(channel, block)));
    return compare_groups(
        a, group_blocks(brightness),
        [&](std::span<const std::size_t> group) { return estimate(a, channel, group); },
        [&](std::span<const std::size_t> group) { return estimate(b, channel, group); });
}

Comparison compare(const PictureBatches& a, std::span<const double> expected, std::size_t channel) {
    std::vector<std::vector<std::size_t>> groups;
    for (std::size_t block = 0; block < a.blocks(); ++block)
        groups.push_back({block});
    return compare_groups(
        a, groups, [&](std::span<const std::size_t> group) { return estimate(a, channel, group); },
        [&](std::span<const std::size_t> group) {
            return Estimate{expected[3 * group.front() + channel], 0.0, 1.0};
        });
}

double score_of_t(double t, double freedom) {
    const double score = (8.0 * freedom + 1.0) / (8.0 * freedom + 3.0) *
                         std::sqrt(freedom * std::log1p(t * t / freedom));
    return t < 0.0 ? -score : score;
}

} // namespace vigil::test
