// SPDX-License-Identifier: GPL-2.0-or-later
#include "bench/change_response.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace vigil::bench {

namespace {

constexpr double least_change = 0.1; // of the brighter of the two
constexpr double sure_change = 5.0;  // standard errors
constexpr double least_pixels = 0.001;

struct Sums {
    double shown = 0.0, whole = 0.0;
    std::size_t pixels = 0;

    double share(std::size_t all) const {
        return static_cast<double>(pixels) >= least_pixels * static_cast<double>(all) &&
                       whole != 0.0
                   ? shown / whole
                   : std::numeric_limits<double>::quiet_NaN();
    }
};

} // namespace

ChangeShown change_shown(std::span<const float> picture, const Reference& before,
                         const Reference& after) {
    Sums brighter, darker;
    const std::size_t pixels = picture.size() / 3;
    const double floor = 0.01 * std::max(before.picture_mean(), after.picture_mean());
    for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
        double was = 0.0, is = 0.0, error = 0.0; // sums over the channels
        for (std::size_t i = 3 * pixel; i < 3 * pixel + 3; ++i) {
            was += before.mean(i);
            is += after.mean(i);
            error += std::sqrt(before.variance(i) + after.variance(i)); // they share paths
        }
        const double brightness = std::max(was, is) + 3.0 * floor;
        const double change = is - was;
        if (std::abs(change) < least_change * brightness || std::abs(change) < sure_change * error)
            continue;
        Sums& sums = change > 0.0 ? brighter : darker;
        const double seen =
            std::accumulate(picture.begin() + 3 * pixel, picture.begin() + 3 * pixel + 3, 0.0);
        sums.shown += (seen - was) / brightness;
        sums.whole += change / brightness;
        ++sums.pixels;
    }
    return {brighter.share(pixels), darker.share(pixels)};
}

double lag_of(std::span<const double> shown) {
    if (std::ranges::any_of(shown, [](double share) { return std::isnan(share); }))
        return std::numeric_limits<double>::quiet_NaN();
    const auto first =
        std::ranges::find_if(shown, [](double share) { return share >= shown_share; });
    return static_cast<double>(first - shown.begin() + 1);
}

} // namespace vigil::bench
