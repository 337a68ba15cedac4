// SPDX-License-Identifier: GPL-2.0-or-later
#include "bench/quality_estimate.h"

#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/students_t.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace vigil::bench {

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr double false_share =
    0.05; // of intervals that miss, and of tables with a false comparison
constexpr double upper = 1.0 - 0.5 * false_share;

double mean(std::span<const double> values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double variance(std::span<const double> values) {
    const double center = mean(values);
    double sum = 0.0;
    for (const double value : values)
        sum += (value - center) * (value - center);
    return sum / static_cast<double>(values.size() - 1); // NaN for a single value
}

/// Upper end of the interval of a mean by Student's t; NaN for a single value. With heavy tails it
/// is too low, so nothing prints it.
double upper_end(std::span<const double> values) {
    const auto count = static_cast<double>(values.size());
    const double error = std::sqrt(variance(values) / count);
    if (!std::isfinite(error)) return unknown;
    return mean(values) + student_t_quantile(upper, count - 1.0) * error;
}

/// Probability that at most `most` of `count` values lie below their median.
double tail_below(int count, int most) {
    return cdf(boost::math::binomial(count, 0.5), most);
}

/// Two-sided probability that, of the ratios, as many or more lie on one side of 1. One that is
/// exactly 1 counts for the smaller side.
double sign_test(std::span<const double> ratios) {
    const auto count = static_cast<int>(ratios.size());
    const auto below =
        static_cast<int>(std::ranges::count_if(ratios, [](double ratio) { return ratio < 1.0; }));
    const auto above =
        static_cast<int>(std::ranges::count_if(ratios, [](double ratio) { return ratio > 1.0; }));
    return std::min(1.0, 2.0 * tail_below(count, count - std::max(below, above)));
}

std::vector<double> pooled(const Strata& values) {
    std::vector<double> all;
    for (const std::vector<double>& view : values)
        all.insert(all.end(), view.begin(), view.end());
    return all;
}

/// Ratios of pairs, by view.
Strata ratios_of(const Strata& numerators, const Strata& denominators) {
    Strata ratios = numerators;
    for (std::size_t view = 0; view < ratios.size(); ++view)
        for (std::size_t seed = 0; seed < ratios[view].size(); ++seed)
            ratios[view][seed] /= denominators[view][seed];
    return ratios;
}

} // namespace

double student_t_quantile(double probability, double degrees) {
    return quantile(boost::math::students_t(degrees), probability);
}

double mean_over_views(const Strata& values) {
    double sum = 0.0;
    for (const std::vector<double>& view : values)
        sum += mean(view);
    return sum / static_cast<double>(values.size());
}

double ratio_of_means(const Strata& numerators, const Strata& denominators) {
    const double above = mean_over_views(numerators);
    const double below = mean_over_views(denominators);
    return above > 0.0 && below > 0.0 ? above / below : unknown;
}

Interval median_interval(std::vector<double> values) {
    const double center = median(values);
    if (std::isnan(center)) return {unknown, unknown, unknown};
    std::ranges::sort(values);
    const auto count = static_cast<int>(values.size());
    // The narrowest symmetric pair of order statistics with at least 95%.
    int rank = -1;
    while (rank + 1 < count / 2 && tail_below(count, rank + 1) <= 0.5 * false_share)
        ++rank;
    if (rank < 0) return {center, unknown, unknown};
    return {center, values[rank], values[count - 1 - rank]};
}

Interval typical_run(const Strata& values) {
    Interval interval = median_interval(pooled(values));
    if (values.size() < least_views) interval.low = interval.high = unknown;
    return interval;
}

Comparison typical_ratio(const Strata& numerators, const Strata& denominators) {
    const auto is_positive = [](double value) { return value > 0.0; };
    if (!std::ranges::all_of(pooled(denominators), is_positive))
        return {{unknown, unknown, unknown}, unknown};
    const Strata ratios = ratios_of(numerators, denominators);
    return {typical_run(ratios), sign_test(pooled(ratios))};
}

Interval ratio_over_views(const Strata& numerators, const Strata& denominators) {
    Strata ratios = ratios_of(numerators, denominators);
    std::vector<double> logarithms; // the median of each view's: of two ratios the mean is too high
    for (std::vector<double>& view : ratios) {
        std::ranges::transform(view, view.begin(), [](double ratio) { return std::log(ratio); });
        logarithms.push_back(median(std::move(view)));
    }
    const auto views = static_cast<double>(logarithms.size());
    const double center = mean(logarithms);
    if (logarithms.size() < least_views) return {std::exp(center), unknown, unknown};
    const double half =
        student_t_quantile(upper, views - 1.0) * std::sqrt(variance(logarithms) / views);
    return {std::exp(center), std::exp(center - half), std::exp(center + half)};
}

Interval ratio_over_flights(const Strata& numerators, const Strata& denominators) {
    const Strata ratios = ratios_of(numerators, denominators);
    std::vector<double> flights;
    for (std::size_t flight = 0; flight < ratios.front().size(); ++flight) {
        std::vector<double> frames;
        for (const std::vector<double>& frame : ratios)
            frames.push_back(frame[flight]);
        flights.push_back(median(std::move(frames)));
    }
    return median_interval(std::move(flights));
}

std::vector<bool> stands_out(std::span<const double> p) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < p.size(); ++i)
        if (!std::isnan(p[i])) order.push_back(i);
    std::ranges::sort(order, {}, [&](std::size_t i) { return p[i]; });
    std::vector<bool> result(p.size());
    for (std::size_t done = 0; done < order.size(); ++done) {
        const auto left = static_cast<double>(order.size() - done);
        if (p[order[done]] * left > false_share) break;
        result[order[done]] = true;
    }
    return result;
}

Strata times(const Strata& a, const Strata& b) {
    Strata result = a;
    for (std::size_t view = 0; view < result.size(); ++view)
        for (std::size_t seed = 0; seed < result[view].size(); ++seed)
            result[view][seed] *= b[view][seed];
    return result;
}

double median(std::vector<double> values) {
    if (values.empty() ||
        std::ranges::any_of(values, [](double value) { return std::isnan(value); }))
        return unknown;
    std::ranges::sort(values);
    return 0.5 * (values[(values.size() - 1) / 2] + values[values.size() / 2]);
}

std::vector<double> running_means(std::span<const double> values, std::size_t width) {
    std::vector<double> means;
    for (std::size_t end = 1; end <= values.size(); ++end) {
        const auto last = values.first(end).last(std::min(end, width));
        means.push_back(std::accumulate(last.begin(), last.end(), 0.0) /
                        static_cast<double>(last.size()));
    }
    return means;
}

double median_of(const Strata& values) {
    return median(pooled(values));
}

bool misses_light(const Strata& mean_ratio) {
    return std::ranges::any_of(mean_ratio, [](const std::vector<double>& view) {
        return upper_end(view) < 1.0 - missing_share;
    });
}

double relative_floor(const Reference& reference) {
    const double tenth = 0.1 * reference.picture_mean();
    return tenth * tenth;
}

double relative_variance(const Reference& reference) {
    const double floor = relative_floor(reference);
    double sum = 0.0;
    for (std::size_t i = 0; i < reference.values(); ++i)
        sum += reference.variance(i) / (reference.mean(i) * reference.mean(i) + floor);
    return sum / static_cast<double>(reference.values());
}

PictureError picture_error(std::span<const float> picture, const Reference& reference) {
    const double floor = relative_floor(reference);
    const std::size_t pixels = picture.size() / 3;
    PictureError error;
    std::vector<double> distances(pixels), variances(pixels);
    for (std::size_t i = 0; i < picture.size(); ++i) {
        const double expected = reference.mean(i);
        const double difference = static_cast<double>(picture[i]) - expected;
        // E[(x - r)^2] = E[(x - truth)^2] + var(r): the reference's part is known, and taken off.
        const double variance = reference.variance(i);
        const double square = difference * difference - variance;
        distances[i / 3] += difference * difference;
        variances[i / 3] += variance;
        error.mse += square;
        error.relative_mse += square / (expected * expected + floor);
        error.mean_ratio += static_cast<double>(picture[i]);
    }
    const auto count = static_cast<double>(picture.size());
    error.mse /= count;
    error.relative_mse /= count;
    error.mean_ratio /= count * reference.picture_mean();

    // Pixels up to the largest distance that is kept.
    std::vector<double> sorted = distances;
    const auto dropped =
        static_cast<std::size_t>(std::ceil(trimmed_share * static_cast<double>(pixels)));
    const auto largest = sorted.begin() + (pixels - 1 - std::min(dropped, pixels - 1));
    std::nth_element(sorted.begin(), largest, sorted.end());
    std::size_t kept = 0;
    for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
        if (distances[pixel] > *largest) continue;
        error.trimmed_mse += distances[pixel] - variances[pixel];
        error.trimmed_variance += variances[pixel];
        ++kept;
    }
    error.trimmed_mse /= 3.0 * static_cast<double>(kept);
    error.trimmed_variance /= 3.0 * static_cast<double>(kept);

    double bright = 0.0;
    for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
        double sum = 0.0;
        for (std::size_t channel = 0; channel < 3; ++channel)
            sum += reference.mean(3 * pixel + channel);
        if (sum <= 3.0 * bright_factor * reference.picture_mean()) continue;
        error.bright_mse += distances[pixel] - variances[pixel];
        error.bright_variance += variances[pixel];
        bright += 3.0;
    }
    error.bright_mse /= bright; // NaN without such pixels
    error.bright_variance /= bright;
    return error;
}

PictureError mean_error(std::span<const std::vector<float>> pictures, const Reference& reference) {
    PictureError sum;
    const auto count = static_cast<double>(pictures.size());
    for (const std::vector<float>& picture : pictures) {
        const PictureError error = picture_error(picture, reference);
        for (const auto& [name, member] : picture_errors)
            sum.*member += error.*member / count;
    }
    return sum;
}

int stays_below(std::span<const double> curve, double limit) {
    auto frame = static_cast<int>(curve.size()) + 1;
    while (frame > 1 && curve[frame - 2] <= limit)
        --frame;
    return frame;
}

Settled settle(std::span<const double> curve, int tail, double factor) {
    const double level = mean(curve.last(std::min(curve.size(), static_cast<std::size_t>(tail))));
    return {level, stays_below(curve, factor * level)};
}

} // namespace vigil::bench
