// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/light/local_exploration.h"

#include "refresh/vkpt/light/alias_table.h"
#include "shared/brdf.h"
#include "shared/triangle_light.h"

#include <algorithm>

namespace vigil {

namespace {

/// Lights of a cluster are told apart by their distances from its box; inside it and close by they
/// count as this far away.
constexpr float least_distance = 32.0f; // map units
/// Half of a table is spread evenly over its lights: a small lamp lights what is beside it as much
/// as a large one does.
constexpr float even_share = 1.0f; // of the sum of the other weights

float weight(const shader::Light& light, const LightLister& lister, size_t cluster) {
    const glm::vec3 center = light.v0 + (light.e1 + light.e2) / 3.0f;
    const float distance = lister.distance_to_cluster(cluster, center);
    const float power = shader::light_area(light) * shader::luminance(light.radiance);
    const float seen =
        power / (distance * distance + shader::light_area(light) + least_distance * least_distance);
    return seen > 0.0f ? std::min(seen, 1e30f) : 0.0f; // also for NaN
}

} // namespace

LocalExploration explore_clusters(const LightLister& lister, std::span<const shader::Light> lights,
                                  uint32_t static_count, size_t most_entries) {
    std::vector<LightTriangle> triangles;
    for (uint32_t id = 0; id < static_count; ++id) {
        const shader::Light& light = lights[id];
        triangles.push_back({light.v0, light.v0 + light.e1, light.v0 + light.e2, id});
    }
    const LightLists lists = lister.build(triangles);
    LocalExploration exploration;
    exploration.ranges.resize(lists.ranges.size());
    for (size_t cluster = 0; cluster + 1 < lists.ranges.size(); ++cluster) {
        const std::span<const uint32_t> list = lists.list(cluster);
        if (list.empty() || exploration.ids.size() + list.size() > most_entries) continue;
        std::vector<float> weights;
        for (const uint32_t id : list)
            weights.push_back(weight(lights[id], lister, cluster));
        double sum = 0.0;
        for (const float value : weights)
            sum += static_cast<double>(value);
        const auto even = static_cast<float>(sum > 0.0 ? static_cast<double>(even_share) * sum /
                                                             static_cast<double>(list.size())
                                                       : 1.0);
        for (float& value : weights)
            value += std::max(even, 1e-30f);
        const std::vector<shader::AliasEntry> entries = build_alias_table(weights);
        exploration.ranges[cluster] = {static_cast<uint32_t>(exploration.ids.size()),
                                       static_cast<uint32_t>(list.size())};
        exploration.ids.insert(exploration.ids.end(), list.begin(), list.end());
        exploration.entries.insert(exploration.entries.end(), entries.begin(), entries.end());
    }
    return exploration;
}

} // namespace vigil
