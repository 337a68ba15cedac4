// SPDX-License-Identifier: GPL-2.0-or-later
// All filters of the paper are separable, or sums of separable ones: a Gaussian, its derivatives,
// and for yellow and blue the sum of two Gaussians. Beyond the picture's edge its last pixel is
// repeated.
#include "bench/flip.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>

namespace vigil::bench {

namespace {

using Plane = std::vector<double>; // one number per pixel
using Taps = std::vector<double>;  // weights of a row of pixels around the middle one

constexpr double pi = std::numbers::pi;

// Of the colour pipeline.
constexpr double color_exponent = 0.7;   // q_c
constexpr double knee_at = 0.4;          // p_c: share of the largest difference
constexpr double knee_value = 0.95;      // p_t: what comes of it
constexpr double feature_width = 0.082;  // w, degrees: of edges and points that the eye sees best
constexpr double feature_exponent = 0.5; // q_f

/// Contrast sensitivity of a channel: the sum of a_i sqrt(pi / b_i) exp(-pi^2 d^2 / b_i), d in
/// degrees.
struct Sensitivity {
    double a1, b1, a2, b2;
};
constexpr Sensitivity achromatic{1.0, 0.0047, 0.0, 1e-5};
constexpr Sensitivity red_green{1.0, 0.0053, 0.0, 1e-5};
constexpr Sensitivity blue_yellow{34.1, 0.04, 13.5, 0.025};
constexpr double widest = 0.04; // the largest b: all channels have its radius

// Columns are those of the sRGB primaries in CIE XYZ under D65.
const glm::dmat3 xyz_from_rgb(10135552.0 / 24577794.0, 2613072.0 / 12288897.0,
                              1425312.0 / 73733382.0, 8788810.0 / 24577794.0,
                              8788810.0 / 12288897.0, 8788810.0 / 73733382.0,
                              4435075.0 / 24577794.0, 887015.0 / 12288897.0,
                              70074185.0 / 73733382.0);

glm::dvec3 white() {
    return xyz_from_rgb * glm::dvec3(1.0);
}

/// YCxCz: linear, in the units of CIELAB.
glm::dvec3 opponent_from_rgb(const glm::dvec3& rgb) {
    const glm::dvec3 t = xyz_from_rgb * rgb / white();
    return {116.0 * t.y - 16.0, 500.0 * (t.x - t.y), 200.0 * (t.y - t.z)};
}

glm::dvec3 rgb_from_opponent(const glm::dvec3& opponent) {
    const double y = (opponent.x + 16.0) / 116.0;
    const glm::dvec3 t(y + opponent.y / 500.0, y, y - opponent.z / 200.0);
    return glm::inverse(xyz_from_rgb) * (t * white());
}

/// CIELAB, with the Hunt effect: colours of dark pixels count less.
glm::dvec3 hunt_lab_from_rgb(const glm::dvec3& rgb) {
    const glm::dvec3 t = xyz_from_rgb * rgb / white();
    const auto f = [](double value) {
        constexpr double delta = 6.0 / 29.0;
        return value > delta * delta * delta ? std::cbrt(value)
                                             : value / (3.0 * delta * delta) + 4.0 / 29.0;
    };
    const glm::dvec3 bent(f(t.x), f(t.y), f(t.z));
    const double lightness = 116.0 * bent.y - 16.0;
    const double hunt = 0.01 * lightness;
    return {lightness, hunt * 500.0 * (bent.x - bent.y), hunt * 200.0 * (bent.y - bent.z)};
}

/// Distance for large differences: city block between lightness and colour, Euclidean in colour.
double hyab(const glm::dvec3& a, const glm::dvec3& b) {
    const glm::dvec3 d = a - b;
    return std::abs(d.x) + std::hypot(d.y, d.z);
}

/// Largest difference that a screen can show, raised to q_c: green against blue.
double largest_difference() {
    return std::pow(hyab(hunt_lab_from_rgb({0.0, 1.0, 0.0}), hunt_lab_from_rgb({0.0, 0.0, 1.0})),
                    color_exponent);
}

/// The plane under rows x columns, beyond the edge as at it.
Plane filtered(const Plane& plane, glm::ivec2 size, const Taps& across, const Taps& down) {
    const auto pass = [size](const Plane& from, const Taps& taps, bool vertical) {
        const int radius = static_cast<int>(taps.size()) / 2;
        Plane to(from.size());
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
                double sum = 0.0;
                for (int i = -radius; i <= radius; ++i) {
                    const int column = vertical ? x : std::clamp(x + i, 0, size.x - 1);
                    const int row = vertical ? std::clamp(y + i, 0, size.y - 1) : y;
                    sum += taps[i + radius] * from[static_cast<std::size_t>(row) * size.x + column];
                }
                to[static_cast<std::size_t>(y) * size.x + x] = sum;
            }
        return to;
    };
    return pass(pass(plane, across, false), down, true);
}

template <typename Weight> Taps taps_of(int radius, const Weight& weight) {
    Taps taps;
    for (int i = -radius; i <= radius; ++i)
        taps.push_back(weight(static_cast<double>(i)));
    return taps;
}

double sum_of(const Taps& taps) {
    return std::accumulate(taps.begin(), taps.end(), 0.0);
}

/// A channel as the eye sees it from afar.
Plane seen(const Plane& plane, glm::ivec2 size, const Sensitivity& channel,
           double pixels_per_degree) {
    const int radius =
        static_cast<int>(std::ceil(3.0 * std::sqrt(widest / (2.0 * pi * pi)) * pixels_per_degree));
    const auto gaussian = [&](double b) {
        return taps_of(radius, [&](double pixels) {
            const double degrees = pixels / pixels_per_degree;
            return std::exp(-pi * pi * degrees * degrees / b);
        });
    };
    const Taps first = gaussian(channel.b1), second = gaussian(channel.b2);
    // Weights of the two Gaussians over the plane, each of which sums to the square of its row.
    const double heavy = channel.a1 * std::sqrt(pi / channel.b1);
    const double light = channel.a2 * std::sqrt(pi / channel.b2);
    const double total =
        heavy * sum_of(first) * sum_of(first) + light * sum_of(second) * sum_of(second);
    Plane result = filtered(plane, size, first, first);
    for (double& value : result)
        value *= heavy / total;
    if (light == 0.0) return result;
    const Plane other = filtered(plane, size, second, second);
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] += light / total * other[i];
    return result;
}

struct Channels {
    Plane brightness, red_green, blue_yellow; // of YCxCz
};

Channels channels_of(std::span<const float> picture) {
    Channels channels;
    for (std::size_t i = 0; i + 2 < picture.size(); i += 3) {
        const auto value = [&](std::size_t c) {
            const auto v = static_cast<double>(picture[i + c]);
            return std::clamp(v, 0.0, 1.0);
        };
        const glm::dvec3 opponent = opponent_from_rgb({value(0), value(1), value(2)});
        channels.brightness.push_back(opponent.x);
        channels.red_green.push_back(opponent.y);
        channels.blue_yellow.push_back(opponent.z);
    }
    return channels;
}

/// Colours after the eye, in CIELAB with Hunt's effect.
std::vector<glm::dvec3> seen_colors(const Channels& channels, glm::ivec2 size,
                                    double pixels_per_degree) {
    const Plane y = seen(channels.brightness, size, achromatic, pixels_per_degree);
    const Plane x = seen(channels.red_green, size, red_green, pixels_per_degree);
    const Plane z = seen(channels.blue_yellow, size, blue_yellow, pixels_per_degree);
    std::vector<glm::dvec3> colors;
    for (std::size_t i = 0; i < y.size(); ++i)
        colors.push_back(hunt_lab_from_rgb(
            glm::clamp(rgb_from_opponent({y[i], x[i], z[i]}), glm::dvec3(0.0), glm::dvec3(1.0))));
    return colors;
}

/// Weights above 0 sum to 1, those below to -1.
void balance(Taps& taps) {
    double above = 0.0, below = 0.0;
    for (const double tap : taps)
        (tap > 0.0 ? above : below) += tap;
    for (double& tap : taps)
        tap /= tap > 0.0 ? above : -below;
}

struct Features {
    Plane edges, points; // how strong they are at each pixel
};

Features features_of(const Channels& channels, glm::ivec2 size, double pixels_per_degree) {
    const double sigma = 0.5 * feature_width * pixels_per_degree;
    const int radius = static_cast<int>(std::ceil(3.0 * sigma));
    Taps smooth =
        taps_of(radius, [&](double x) { return std::exp(-x * x / (2.0 * sigma * sigma)); });
    const double total = sum_of(smooth);
    // The first and the second derivative; the Gaussian across them sums to 1, so that balanced
    // rows are balanced planes.
    Taps edge = smooth, point = smooth;
    for (int i = -radius; i <= radius; ++i) {
        edge[i + radius] *= -i;
        point[i + radius] *= i * i / (sigma * sigma) - 1.0;
    }
    for (double& tap : smooth)
        tap /= total;
    balance(edge);
    balance(point);
    Plane gray;
    for (const double brightness : channels.brightness)
        gray.push_back((brightness + 16.0) / 116.0);
    const auto strength = [&](const Taps& taps) {
        Plane across = filtered(gray, size, taps, smooth);
        const Plane down = filtered(gray, size, smooth, taps);
        for (std::size_t i = 0; i < across.size(); ++i)
            across[i] = std::hypot(across[i], down[i]);
        return across;
    };
    return {strength(edge), strength(point)};
}

} // namespace

std::vector<float> flip_map(std::span<const float> reference, std::span<const float> test,
                            glm::ivec2 size, double pixels_per_degree) {
    const Channels channels = channels_of(reference), other = channels_of(test);
    const std::vector<glm::dvec3> colors = seen_colors(channels, size, pixels_per_degree);
    const std::vector<glm::dvec3> other_colors = seen_colors(other, size, pixels_per_degree);
    const Features features = features_of(channels, size, pixels_per_degree);
    const Features other_features = features_of(other, size, pixels_per_degree);

    const double largest = largest_difference();
    const double knee = knee_at * largest;
    std::vector<float> map;
    for (std::size_t i = 0; i < colors.size(); ++i) {
        // Large differences of colour are compressed: beyond the knee all is bad.
        const double difference = std::pow(hyab(colors[i], other_colors[i]), color_exponent);
        const double color =
            difference < knee
                ? knee_value / knee * difference
                : knee_value + (difference - knee) / (largest - knee) * (1.0 - knee_value);
        const double feature =
            std::pow(std::max(std::abs(features.edges[i] - other_features.edges[i]),
                              std::abs(features.points[i] - other_features.points[i])) /
                         std::numbers::sqrt2,
                     feature_exponent);
        map.push_back(
            static_cast<float>(std::pow(std::min(color, 1.0), 1.0 - std::min(feature, 1.0))));
    }
    return map;
}

double mean_flip(std::span<const float> reference, std::span<const float> test, glm::ivec2 size,
                 double pixels_per_degree) {
    const std::vector<float> map = flip_map(reference, test, size, pixels_per_degree);
    return std::accumulate(map.begin(), map.end(), 0.0) / static_cast<double>(map.size());
}

} // namespace vigil::bench
