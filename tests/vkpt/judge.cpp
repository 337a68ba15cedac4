// SPDX-License-Identifier: GPL-2.0-or-later
#include "judge.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <gtest/gtest.h>
#include <iostream>
#include <iterator>
#include <limits>
#include <numeric>

namespace vigil::test {

namespace {

/// A planted bias is laid over equal means, so that chance neither hides nor finds it. Two more
/// than the limit: over means that differ by chance, 98 of 100 such biases are found.
constexpr double planted_score = score_limit + 2.0;

using Blocks = std::vector<std::size_t>;

class Judge {
public:
    using Compare = std::function<Comparison(const PictureBatches& seen, std::size_t channel)>;

    Judge(std::string_view label, const PictureBatches& seen, std::span<const double> expected,
          Compare compare)
        : label_(label), seen_(seen), aligned_(seen), compare_(std::move(compare)) {
        aligned_.set_means(expected);
        std::vector<Comparison> all;
        for (std::size_t channel = 0; channel < 3; ++channel)
            all.push_back(compare_(seen_, channel));
        for (std::size_t block = 0; block < seen_.blocks(); ++block)
            bright_.push_back(std::ranges::any_of(all, [&](const Comparison& comparison) {
                return !std::isnan(comparison.scores[block]);
            }));
    }

    void expect_agreement(const Bounds& bounds) const {
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const Comparison result = compare_(seen_, channel);
            const std::string line =
                fmt::format("{} {}: {}", label_, "RGB"[channel], result.text());
            std::cout << line << '\n';
            const auto record = [&](std::string_view name, double value) {
                testing::Test::RecordProperty(
                    fmt::format("measured/{} {}/{}", label_, "RGB"[channel], name),
                    fmt::format("{:.6g}", value));
            };
            record("bias", result.bias);
            record("standard_error", result.bias_error);
            EXPECT_GE(result.blocks, bounds.blocks) << line;
            EXPECT_TRUE(result.agrees(score_limit)) << line;
            EXPECT_LT(result.found_from(), bounds.everywhere) << line << ": a bias could hide";
        }
    }

    /// The planted biases that are hardest to find must be found.
    void expect_found(const Bounds& bounds) const {
        Blocks all(seen_.blocks());
        std::iota(all.begin(), all.end(), std::size_t{0});
        const double everywhere = least_score(1.5 * bounds.everywhere, bright_parts({all}, 1));
        const double quadrant =
            least_score(bounds.quadrant, bright_parts(quadrants(seen_), seen_.blocks() / 8));
        const double five = least_score(bounds.five_blocks, places_of_five());
        std::cout << fmt::format(
            "{} planted {:.2f}% everywhere: {:.1f}, {:.1f}% in a quadrant: {:.1f}, {:.1f}% in "
            "five blocks: {:.1f}\n",
            label_, 150.0 * bounds.everywhere, everywhere, 100.0 * bounds.quadrant, quadrant,
            100.0 * bounds.five_blocks, five);
        EXPECT_GT(everywhere, planted_score) << label_;
        EXPECT_GT(quadrant, planted_score) << label_;
        EXPECT_GT(five, planted_score) << label_;
    }

private:
    /// What is judged alone of each of these regions, if that is so many blocks.
    std::vector<Blocks> bright_parts(const std::vector<Blocks>& regions, std::size_t least) const {
        std::vector<Blocks> parts;
        for (const Blocks& region : regions) {
            Blocks part;
            std::ranges::copy_if(region, std::back_inserter(part),
                                 [&](std::size_t block) { return bright_[block]; });
            if (part.size() >= least) parts.push_back(part);
        }
        return parts;
    }

    /// Three blocks and two below them, where each of the windows begins.
    std::vector<Blocks> places_of_five() const {
        const std::size_t across = seen_.blocks_x(), down = seen_.blocks_y();
        std::vector<Blocks> places;
        for (const Blocks& window : windows(seen_)) {
            const std::size_t first = window.front();
            if (first % across + 3 > across || first / across + 2 > down) continue;
            places.push_back({first, first + 1, first + 2, first + across, first + across + 1});
        }
        return bright_parts(places, 5);
    }

    /// The least score, of the channel that shows it best, of a bias in one of these regions.
    double least_score(double bias, std::span<const Blocks> regions) const {
        double least = std::numeric_limits<double>::infinity();
        for (const Blocks& region : regions) {
            PictureBatches planted = aligned_;
            planted.scale(1.0 + bias, region);
            double score = 0.0;
            for (std::size_t channel = 0; channel < 3; ++channel)
                score = std::max(score, compare_(planted, channel).worst());
            least = std::min(least, score);
        }
        return least;
    }

    std::string_view label_;
    const PictureBatches& seen_;
    PictureBatches aligned_; // the same noise, and the expected means
    Compare compare_;
    std::vector<bool> bright_; // blocks that are judged alone in some channel
};

} // namespace

void judge(std::string_view label, const PictureBatches& seen, const PictureBatches& reference,
           const Bounds& bounds) {
    const Judge judge(label, seen, reference.means(),
                      [&](const PictureBatches& picture, std::size_t channel) {
                          return compare(picture, reference, channel);
                      });
    judge.expect_agreement(bounds);
    judge.expect_found(bounds);
}

void judge(std::string_view label, const PictureBatches& seen, std::span<const double> expected,
           const Bounds& bounds) {
    const Judge judge(label, seen, expected,
                      [&](const PictureBatches& picture, std::size_t channel) {
                          return compare(picture, expected, channel);
                      });
    judge.expect_agreement(bounds);
    judge.expect_found(bounds);
}

void judge_differences(std::string_view label, std::span<const double> differences, double level,
                       double bound) {
    const auto n = static_cast<double>(differences.size());
    double mean = 0.0, squares = 0.0;
    for (const double difference : differences)
        mean += difference / n;
    for (const double difference : differences)
        squares += (difference - mean) * (difference - mean);
    const double error = std::sqrt(squares / (n * (n - 1.0)));
    const auto score = [&](double of) { return score_of_t(of / error, n - 1.0); };
    const std::string line =
        fmt::format("{}: {:+.2f}% +- {:.2f}% (score {:+.2f}; from {:.2f}% it is found)", label,
                    100.0 * mean / level, 100.0 * error / level, score(mean),
                    100.0 * score_limit * error / level);
    std::cout << line << '\n';
    EXPECT_GT(level, 0.0) << line;
    EXPECT_LT(std::abs(score(mean)), score_limit) << line;
    EXPECT_LT(score_limit * error, bound * level) << line << ": a bias could hide";
    EXPECT_GT(score(1.5 * bound * level), score_limit) << line << ": a planted bias is not found";
}

} // namespace vigil::test
