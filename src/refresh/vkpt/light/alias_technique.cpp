// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/light/alias_technique.h"

#include "refresh/vkpt/light/alias_table.h"
#include "refresh/vkpt/scene/light_set.h"

#include <cstring>

namespace vigil::vkpt {

AliasTechnique::AliasTechnique(const TechniqueContext& context, Weight weight)
    : weight_(weight), table_(context.device, "alias table") {}

bool AliasTechnique::prepare(const LightSet& lights) {
    if (revision_ == lights.revision()) return false;
    revision_ = lights.revision();
    std::vector<float> weights;
    for (const shader::Light& light : lights.lights())
        weights.push_back(light.radiance == glm::vec3(0.0f) ? 0.0f : weight_(light));
    const std::vector<shader::AliasEntry> entries = build_alias_table(weights);
    // The count stands in front of the entries.
    const auto count = static_cast<uint32_t>(entries.size());
    std::vector<std::byte> bytes(sizeof(count) + entries.size() * sizeof(shader::AliasEntry));
    std::memcpy(bytes.data(), &count, sizeof(count));
    if (count > 0)
        std::memcpy(bytes.data() + sizeof(count), entries.data(), bytes.size() - sizeof(count));
    return table_.set(bytes);
}

} // namespace vigil::vkpt
