// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/light/exploration.h"

#include "refresh/vkpt/light/light_changes.h"
#include "refresh/vkpt/light/light_power.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace vigil {

namespace {

/// Part of a change that is left a frame later, and the part of the power below which it is
/// forgotten.
constexpr float change_fade = 0.5f, change_least = 0.01f;
/// Share of all draws that is spread evenly, so that no light is out of reach.
constexpr double even_share = 1e-4;

/// Power over squared distance: what the light does to a wall beside the camera. Its own size
/// bounds it.
float nearness(const shader::Light& light, const glm::vec3& eye) {
    const glm::vec3 offset = shader::light_from(light, eye).v0 + (light.e1 + light.e2) / 3.0f - eye;
    return light_power(light) /
           std::max(glm::dot(offset, offset) + shader::light_area(light), 1e-20f);
}

/// Adds `density`, scaled to a sum of `part`. Returns false if there is none.
bool add(std::vector<double>& sum, const std::vector<float>& density, double part) {
    const double total = std::accumulate(density.begin(), density.end(), 0.0);
    if (!(total > 0.0) || !(part > 0.0)) return false;
    for (size_t i = 0; i < density.size(); ++i)
        sum[i] += part * static_cast<double>(density[i]) / total;
    return true;
}

} // namespace

std::vector<float> Exploration::weights(std::span<const shader::Light> lights, const glm::vec3& eye,
                                        const ExplorationMix& mix) {
    const size_t count = lights.size();
    std::vector<float> energy(count), near(count);
    change_.resize(count);
    fading_ = false;
    for (size_t i = 0; i < count; ++i) {
        energy[i] = light_power(lights[i]);
        near[i] = nearness(lights[i], eye);
        // A light that appeared or moved counts with all its power, one that brightens with the
        // difference.
        float changed = 0.0f;
        if (i >= before_.size())
            changed = first_ ? 0.0f : energy[i];
        else if (!same_place(before_[i], lights[i]))
            changed = energy[i];
        else
            changed = std::min(std::abs(energy[i] - light_power(before_[i])), energy[i]);
        change_[i] = std::max(changed, change_fade * change_[i]);
        if (change_[i] <= change_least * energy[i]) change_[i] = 0.0f;
        fading_ |= change_[i] > 0.0f;
    }
    before_.assign(lights.begin(), lights.end());
    first_ = false;

    std::vector<double> sum(count, 0.0);
    add(sum, energy, static_cast<double>(mix.energy));
    add(sum, change_, static_cast<double>(mix.change));
    add(sum, near, static_cast<double>(mix.distance));
    const double blended = std::accumulate(sum.begin(), sum.end(), 0.0);
    const auto shining = static_cast<double>(
        std::count_if(lights.begin(), lights.end(), [](const shader::Light& light) {
            return light.radiance != glm::vec3(0.0f);
        }));
    const double even = blended > 0.0 ? even_share : 1.0;
    std::vector<float> weights(count, 0.0f);
    for (size_t i = 0; i < count; ++i) {
        if (lights[i].radiance == glm::vec3(0.0f)) continue;
        const double drawn = blended > 0.0 ? (1.0 - even) * sum[i] / blended : 0.0;
        weights[i] = static_cast<float>(drawn + even / shining);
    }
    return weights;
}

} // namespace vigil
