// SPDX-License-Identifier: GPL-2.0-or-later
#include "bench/flicker.h"

#include "shared/brdf.h"

#include <glm/glm.hpp>

#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace vigil::bench {

std::vector<double> luminances(std::span<const float> rgb) {
    std::vector<double> values;
    values.reserve(rgb.size() / 3);
    for (std::size_t i = 0; i + 2 < rgb.size(); i += 3)
        values.push_back(static_cast<double>(shader::luminance({rgb[i], rgb[i + 1], rgb[i + 2]})));
    return values;
}

void Flicker::add(std::span<const float> rgb) {
    const std::vector<double> values = luminances(rgb);
    means_.resize(values.size());
    squares_.resize(values.size());
    ++frames_;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double difference = values[i] - means_[i];
        means_[i] += difference / frames_;
        squares_[i] += difference * (values[i] - means_[i]);
    }
}

double Flicker::variance() const {
    return std::accumulate(squares_.begin(), squares_.end(), 0.0) /
           (static_cast<double>(squares_.size()) * (frames_ - 1.0));
}

SeenFrame seen_frame(std::span<const float> rgb, std::vector<shader::PrimaryHit> hits,
                     const shader::FrameParams& camera) {
    SeenFrame frame{luminances(rgb), std::move(hits), camera};
    constexpr double darkest = 0.01; // as shared/filter_types.h: what reflects less tells nothing
    for (std::size_t i = 0; i < frame.light.size(); ++i) {
        const shader::PrimaryHit& hit = frame.hits[i];
        if (hit.primitive == shader::NONE)
            frame.light[i] = std::numeric_limits<double>::quiet_NaN();
        else
            frame.light[i] /= std::max(darkest, static_cast<double>(shader::luminance(hit.albedo)));
    }
    return frame;
}

double moving_flicker(const SeenFrame& before, const SeenFrame& now) {
    const shader::FrameParams& camera = before.camera;
    const glm::vec2 size(camera.size);
    double sum = 0.0, count = 0.0;
    for (std::size_t i = 0; i < now.hits.size(); ++i) {
        const shader::PrimaryHit& hit = now.hits[i];
        if (std::isnan(now.light[i])) continue;
        const glm::vec3 to = hit.position - camera.camera_origin;
        const float depth = glm::dot(to, camera.camera_forward);
        if (depth <= 0.0f) continue;
        // -1..1 across the picture; the axes are as long as the tangents of half its angles.
        const glm::vec2 place(glm::dot(to, camera.camera_right) /
                                  (depth * glm::dot(camera.camera_right, camera.camera_right)),
                              -glm::dot(to, camera.camera_up) /
                                  (depth * glm::dot(camera.camera_up, camera.camera_up)));
        const glm::vec2 pixel = glm::floor((0.5f * place + 0.5f) * size);
        if (glm::any(glm::lessThan(pixel, glm::vec2(0.0f))) ||
            glm::any(glm::greaterThanEqual(pixel, size)))
            continue;
        const std::size_t at =
            static_cast<std::size_t>(pixel.y) * camera.size.x + static_cast<std::size_t>(pixel.x);
        const shader::PrimaryHit& was = before.hits[at];
        // The same surface, not farther away than a pixel covers of it.
        const glm::vec3 apart = was.position - hit.position;
        const float reach = 2.0f * camera.pixel_angle * depth;
        if (std::isnan(before.light[at]) || was.instance != hit.instance ||
            glm::dot(was.normal, hit.normal) < 0.99f ||
            std::abs(glm::dot(apart, hit.normal)) > reach)
            continue;
        const double difference = now.light[i] - before.light[at];
        sum += 0.5 * difference * difference;
        count += 1.0;
    }
    return count > 0.0 ? sum / count : std::numeric_limits<double>::quiet_NaN();
}

} // namespace vigil::bench
