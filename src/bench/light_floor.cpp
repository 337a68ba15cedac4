// SPDX-License-Identifier: GPL-2.0-or-later
#include "bench/light_floor.h"

#include "refresh/vkpt/gpu/shader_library.h"
#include "refresh/vkpt/side_pass.h"
#include "shared/light_floor.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace vigil::bench {

namespace {

using shader::LightFloorValue;

/// Answers in memory at once.
constexpr std::uint64_t most_values = 1u << 20;

/// At most `wanted` pixels on a regular grid, in the middle of its cells.
std::vector<std::uint32_t> grid(glm::uvec2 size, int wanted) {
    const double pixels = static_cast<double>(size.x) * size.y;
    const auto step =
        static_cast<std::uint32_t>(std::ceil(std::sqrt(std::max(1.0, pixels / wanted))));
    std::vector<std::uint32_t> chosen;
    for (std::uint32_t y = step / 2; y < size.y; y += step)
        for (std::uint32_t x = step / 2; x < size.x; x += step)
            chosen.push_back(y * size.x + x);
    return chosen;
}

/// Least variance at one pixel from what its lights answered.
double least_variance(std::span<const LightFloorValue> lights) {
    double root = 0.0, half_root = 0.0;
    glm::dvec3 even(0.0), odd(0.0);
    for (const LightFloorValue& light : lights) {
        root += static_cast<double>(light.root);
        half_root +=
            0.5 * (static_cast<double>(light.even_root) + static_cast<double>(light.odd_root));
        even += glm::dvec3(light.even_mean);
        odd += glm::dvec3(light.odd_mean);
    }
    const double extrapolated = 2.0 * root - half_root;
    // The product of independent means is unbiased for the square of the mean.
    return extrapolated * extrapolated - glm::dot(even, odd) / 3.0;
}

} // namespace

LightFloor measure_light_floor(vkpt::VkptRenderer& renderer, const LightFloorPlan& plan) {
    const std::vector<std::uint32_t> pixels = grid(renderer.buffers().size(), plan.pixels);
    const auto lights = static_cast<std::uint32_t>(renderer.scene()->lights().lights().size());
    LightFloor floor;
    floor.pixels = static_cast<int>(pixels.size());
    if (lights == 0) return floor;

    constexpr std::uint32_t edge = 8; // of a work group
    const std::uint32_t groups = (lights + edge - 1) / edge;
    const std::uint64_t row = std::uint64_t{groups} * edge;
    const auto rows =
        static_cast<std::uint32_t>(std::max<std::uint64_t>(edge, most_values / row)) / edge * edge;
    vkpt::SidePass pass(renderer, vkpt::shader_code("light_floor"), "light_floor",
                        renderer.scene()->features());
    pass.add_buffer(std::as_bytes(std::span(pixels)));
    pass.add_buffer(row * rows * sizeof(LightFloorValue));
    double sums[2] = {};
    for (std::uint32_t first = 0; first < pixels.size(); first += rows) {
        pass.run({groups, rows / edge, 1}, {first, static_cast<std::uint32_t>(plan.samples)});
        const std::size_t here = std::min<std::size_t>(rows, pixels.size() - first);
        const std::vector<LightFloorValue> values = pass.read<LightFloorValue>(1, row * here);
        for (std::size_t pixel = 0; pixel < here; ++pixel) {
            sums[(first + pixel) % 2] +=
                least_variance(std::span(values).subspan(pixel * row, row));
        }
    }
    const auto count = static_cast<double>(pixels.size());
    floor.variance = (sums[0] + sums[1]) / count;
    floor.halves[0] = sums[0] / std::ceil(0.5 * count);
    floor.halves[1] = sums[1] / std::max(1.0, std::floor(0.5 * count));
    return floor;
}

} // namespace vigil::bench
