// SPDX-License-Identifier: GPL-2.0-or-later
#include "bench/change_response.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vigil::bench {

namespace {

constexpr int tile = 8;
constexpr double least_change = 0.1; // of the brighter of the two
constexpr double sure_change = 5.0;  // standard errors
constexpr double least_tiles = 0.01; // of all

/// Of the tiles that become brighter, or of the others.
struct Sums {
    double shown = 0.0, whole = 0.0;
    int tiles = 0;

    double share(int all) const {
        return tiles > 0 && tiles >= least_tiles * all ? shown / whole
                                                       : std::numeric_limits<double>::quiet_NaN();
    }
};

/// Sums over the pixels and channels of a tile.
struct Tile {
    double was = 0.0, is = 0.0, seen = 0.0, variance = 0.0, values = 0.0;

    void add(std::span<const float> picture, const Reference& before, const Reference& after,
             std::size_t pixel) {
        double error = 0.0;
        for (std::size_t i = 3 * pixel; i < 3 * pixel + 3; ++i) {
            was += before.mean(i);
            is += after.mean(i);
            seen += static_cast<double>(picture[i]);
            error += std::sqrt(before.variance(i) + after.variance(i)); // channels share paths
            values += 1.0;
        }
        variance += error * error;
    }
};

} // namespace

ChangeShown change_shown(std::span<const float> picture, const Reference& before,
                         const Reference& after, glm::ivec2 size) {
    Sums brighter, darker;
    int tiles = 0;
    const double floor = 0.01 * std::max(before.picture_mean(), after.picture_mean());
    for (int top = 0; top < size.y; top += tile)
        for (int left = 0; left < size.x; left += tile) {
            Tile sums;
            for (int y = top; y < std::min(top + tile, size.y); ++y)
                for (int x = left; x < std::min(left + tile, size.x); ++x)
                    sums.add(picture, before, after, static_cast<std::size_t>(y) * size.x + x);
            ++tiles;
            const double brightness = std::max(sums.was, sums.is) + sums.values * floor;
            const double change = sums.is - sums.was;
            if (std::abs(change) < least_change * brightness ||
                std::abs(change) < sure_change * std::sqrt(sums.variance))
                continue;
            Sums& to = change > 0.0 ? brighter : darker;
            to.shown += (sums.seen - sums.was) / brightness;
            to.whole += change / brightness;
            ++to.tiles;
        }
    return {brighter.share(tiles), darker.share(tiles)};
}

double lag_of(std::span<const double> shown) {
    if (std::ranges::any_of(shown, [](double share) { return std::isnan(share); }))
        return std::numeric_limits<double>::quiet_NaN();
    const auto first =
        std::ranges::find_if(shown, [](double share) { return share >= shown_share; });
    return static_cast<double>(first - shown.begin() + 1);
}

} // namespace vigil::bench
