// SPDX-License-Identifier: GPL-2.0-or-later
#include "bench/display.h"

#include "shared/brdf.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace vigil::bench {

namespace {

/// The curve of pt_tonemap filmic: Narkowicz's fit of 2015.
double filmic(double exposed) {
    const double x = 0.8 * std::min(exposed, 1e4);
    return std::clamp(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14), 0.0, 1.0);
}

} // namespace

double exposure_of(std::span<const float> rgb, glm::ivec2 size) {
    constexpr int tile = 8;
    double logarithms = 0.0, tiles = 0.0;
    for (int top = 0; top < size.y; top += tile)
        for (int left = 0; left < size.x; left += tile) {
            double sum = 0.0, pixels = 0.0;
            for (int y = top; y < std::min(top + tile, size.y); ++y)
                for (int x = left; x < std::min(left + tile, size.x); ++x) {
                    const std::size_t at = 3 * (static_cast<std::size_t>(y) * size.x + x);
                    sum +=
                        static_cast<double>(shader::luminance({rgb[at], rgb[at + 1], rgb[at + 2]}));
                    pixels += 1.0;
                }
            if (sum / pixels <= 1e-6) continue;
            logarithms += std::log2(sum / pixels);
            tiles += 1.0;
        }
    return std::clamp(0.18 / std::exp2(logarithms / std::max(tiles, 1.0)), 1e-6, 1e6);
}

std::vector<float> displayed(std::span<const float> rgb, double exposure) {
    std::vector<float> values;
    values.reserve(rgb.size());
    for (const float value : rgb)
        values.push_back(static_cast<float>(filmic(static_cast<double>(value) * exposure)));
    return values;
}

} // namespace vigil::bench
