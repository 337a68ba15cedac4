// SPDX-License-Identifier: GPL-2.0-or-later
#include "bench/quality_estimate.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace vigil::bench {

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr double upper = 0.975; // of a two-sided interval of 95%

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

double mean_of_means(const Strata& values) {
    double sum = 0.0;
    for (const std::vector<double>& view : values)
        sum += mean(view);
    return sum / static_cast<double>(values.size());
}

/// Half the width of the interval of the mean of the views' means.
double half_width(const Strata& values) {
    const auto views = static_cast<double>(values.size());
    double total = 0.0, weighted = 0.0;
    for (const std::vector<double>& view : values) {
        const auto count = static_cast<double>(view.size());
        const double part = variance(view) / (count * views * views);
        total += part;
        weighted += part * part / (count - 1.0);
    }
    if (total == 0.0) return 0.0;
    const double degrees = total * total / weighted;
    if (!std::isfinite(degrees)) return unknown;
    return student_t_quantile(upper, degrees) * std::sqrt(total);
}

/// Probability that of `count` values more than `rank` lie below the median: the binomial tail.
double tail_above(int count, int rank) {
    double sum = 0.0;
    for (int i = rank + 1; i <= count; ++i)
        sum += std::exp(std::lgamma(count + 1.0) - std::lgamma(i + 1.0) -
                        std::lgamma(count - i + 1.0) - count * std::numbers::ln2);
    return sum;
}

} // namespace

double student_t_quantile(double probability, double degrees) {
    // With t = sqrt(degrees) tan(angle) the density becomes cos(angle)^(degrees - 1), up to its
    // integral over (-pi/2, pi/2). Simpson's rule and bisection on the angle.
    const double constant =
        std::exp(std::lgamma(0.5 * (degrees + 1.0)) - std::lgamma(0.5 * degrees)) /
        std::sqrt(std::numbers::pi);
    const auto below = [&](double angle) {
        constexpr int steps = 256;
        const double step = angle / steps;
        double sum = 0.0;
        for (int i = 0; i <= steps; ++i) {
            const double weight = i == 0 || i == steps ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
            sum += weight * std::pow(std::cos(i * step), degrees - 1.0);
        }
        return 0.5 + constant * sum * step / 3.0;
    };
    const double wanted = std::max(probability, 1.0 - probability);
    // With many degrees the density is a narrow peak, which the steps must not miss: up to t = 40.
    double low = 0.0;
    double high = std::min(0.5 * std::numbers::pi * (1.0 - 1e-12), 40.0 / std::sqrt(degrees));
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (below(middle) < wanted ? low : high) = middle;
    }
    const double t = std::sqrt(degrees) * std::tan(low);
    return probability < 0.5 ? -t : t;
}

Interval mean_interval(const Strata& values) {
    const double center = mean_of_means(values);
    const double half = half_width(values);
    return {center, center - half, center + half};
}

Interval ratio_interval(const Strata& numerators, const Strata& denominators) {
    const double above = mean_of_means(numerators);
    const double below = mean_of_means(denominators);
    const double ratio = above / below;
    if (!(above > 0.0 && below > 0.0)) return {ratio, unknown, unknown};
    // d log(a / b) = da / a - db / b; the same seed of both keeps what they have in common out.
    Strata changes = numerators;
    for (std::size_t view = 0; view < changes.size(); ++view)
        for (std::size_t seed = 0; seed < changes[view].size(); ++seed)
            changes[view][seed] = numerators[view][seed] / above - denominators[view][seed] / below;
    const double factor = std::exp(half_width(changes));
    return {ratio, ratio / factor, ratio * factor};
}

Interval ratio_over_views(const Strata& numerators, const Strata& denominators) {
    std::vector<double> logarithms;
    for (std::size_t view = 0; view < numerators.size(); ++view)
        logarithms.push_back(std::log(mean(numerators[view]) / mean(denominators[view])));
    const double center = mean(logarithms);
    const double half = half_width({logarithms});
    return {std::exp(center), std::exp(center - half), std::exp(center + half)};
}

Interval median_ratio(const Strata& numerators, const Strata& denominators) {
    std::vector<double> ratios;
    for (std::size_t view = 0; view < numerators.size(); ++view)
        for (std::size_t seed = 0; seed < numerators[view].size(); ++seed)
            ratios.push_back(numerators[view][seed] / denominators[view][seed]);
    std::sort(ratios.begin(), ratios.end());
    const auto count = static_cast<int>(ratios.size());
    // The narrowest symmetric pair of order statistics with at least 95%.
    int rank = -1;
    while (rank + 1 < count / 2 && tail_above(count, count - 2 - rank) <= 1.0 - upper)
        ++rank;
    const double center = median(ratios);
    if (rank < 0) return {center, unknown, unknown};
    return {center, ratios[rank], ratios[count - 1 - rank]};
}

Interval product(const Interval& a, const Interval& b) {
    const double value = a.value * b.value;
    const double down = std::hypot(std::log(a.low / a.value), std::log(b.low / b.value));
    const double up = std::hypot(std::log(a.high / a.value), std::log(b.high / b.value));
    return {value, value * std::exp(-down), value * std::exp(up)};
}

Interval widened(const Interval& interval, double standard_error) {
    constexpr double normal_quantile = 1.959964; // the reference has tens of batches
    const double other = normal_quantile * standard_error;
    return {interval.value, interval.value - std::hypot(interval.value - interval.low, other),
            interval.value + std::hypot(interval.high - interval.value, other)};
}

double median(std::vector<double> values) {
    if (values.empty()) return unknown;
    std::sort(values.begin(), values.end());
    return 0.5 * (values[(values.size() - 1) / 2] + values[values.size() / 2]);
}

bool misses_light(const Strata& mean_ratio) {
    return std::ranges::any_of(mean_ratio, [](const std::vector<double>& view) {
        return mean_interval({view}).high < 1.0 - missing_share;
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
    constexpr double PictureError::*members[] = {
        &PictureError::mse,        &PictureError::trimmed_mse,     &PictureError::trimmed_variance,
        &PictureError::bright_mse, &PictureError::bright_variance, &PictureError::relative_mse,
        &PictureError::mean_ratio};
    PictureError sum;
    const auto count = static_cast<double>(pictures.size());
    for (const std::vector<float>& picture : pictures) {
        const PictureError error = picture_error(picture, reference);
        for (double PictureError::*member : members)
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
