// SPDX-License-Identifier: GPL-2.0-or-later
#include "bench/detail.h"

#include "shared/brdf.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace vigil::bench {

namespace {

constexpr double least_step = 0.1; // of the pair's mean
constexpr double same_color = 0.02;
constexpr double sure = 5.0; // standard errors
constexpr std::size_t least_pairs = 30;
constexpr std::array<double, 3> weights{0.2126, 0.7152, 0.0722}; // of luminance

/// Of what value(index) is for each channel of a pixel.
template <typename Value> double luminance_at(std::size_t pixel, const Value& value) {
    double sum = 0.0;
    for (std::size_t c = 0; c < 3; ++c)
        sum += weights.at(c) * value(3 * pixel + c);
    return sum;
}

/// Steps as the picture has them, against those of the reference.
struct Steps {
    double shared = 0.0, own = 0.0;
    std::size_t pairs = 0;

    void add(double picture, double reference, double variance) {
        shared += picture * reference;
        own += reference * reference - variance;
        ++pairs;
    }
    double kept() const {
        return pairs >= least_pairs && own > 0.0 ? shared / own
                                                 : std::numeric_limits<double>::quiet_NaN();
    }
};

/// Two hits on one smooth surface.
bool is_one_surface(const shader::PrimaryHit& a, const shader::PrimaryHit& b) {
    if (a.primitive == shader::NONE || b.primitive == shader::NONE || a.instance != b.instance)
        return false;
    const glm::vec3 apart = b.position - a.position;
    return glm::dot(a.normal, b.normal) > 0.99f &&
           std::abs(glm::dot(apart, a.normal)) <= 0.05f * glm::length(apart) + 1e-3f;
}

} // namespace

Detail detail_kept(std::span<const float> picture, const Reference& reference,
                   std::span<const shader::PrimaryHit> hits, glm::ivec2 size) {
    std::vector<double> seen, expected, variance;
    double mean = 0.0;
    for (std::size_t pixel = 0; pixel < hits.size(); ++pixel) {
        seen.push_back(
            luminance_at(pixel, [&](std::size_t i) { return static_cast<double>(picture[i]); }));
        expected.push_back(luminance_at(pixel, [&](std::size_t i) { return reference.mean(i); }));
        // Channels share paths: their errors go together at most.
        variance.push_back(std::pow(
            luminance_at(pixel, [&](std::size_t i) { return std::sqrt(reference.variance(i)); }),
            2.0));
        mean += expected.back() / static_cast<double>(hits.size());
    }
    Steps texture, shadow;
    const auto look_at = [&](std::size_t a, std::size_t b) {
        if (!is_one_surface(hits[a], hits[b])) return;
        const auto albedo = [&](std::size_t i) {
            return static_cast<double>(shader::luminance(hits[i].albedo));
        };
        const double colors = albedo(a) + albedo(b);
        if (colors <= 0.0) return;
        const double color_step = 2.0 * std::abs(albedo(b) - albedo(a)) / colors;
        // Dark places do not decide.
        const double scale = 0.5 * (expected[a] + expected[b]) + 0.01 * mean;
        if (scale <= 0.0) return;
        const double step = (expected[b] - expected[a]) / scale;
        const double own = (seen[b] - seen[a]) / scale;
        const double noise = (variance[a] + variance[b]) / (scale * scale);
        if (color_step >= least_step)
            texture.add(own, step, noise);
        else if (color_step <= same_color && std::abs(step) >= least_step &&
                 step * step >= sure * sure * noise)
            shadow.add(own, step, noise);
    };
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            const std::size_t at = static_cast<std::size_t>(y) * size.x + x;
            if (x + 1 < size.x) look_at(at, at + 1);
            if (y + 1 < size.y) look_at(at, at + size.x);
        }
    return {texture.kept(), shadow.kept(), texture.pairs, shadow.pairs};
}

} // namespace vigil::bench
