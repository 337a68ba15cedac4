// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/light/alias_technique.h"

#include "refresh/vkpt/light/alias_table.h"
#include "refresh/vkpt/scene/light_set.h"

namespace vigil::vkpt {

AliasTechnique::AliasTechnique(const TechniqueContext& context, Weight weight)
    : weight_(weight), table_(context.device, "alias table") {}

bool AliasTechnique::prepare(const LightFrame& frame) {
    if (revision_ == frame.lights.revision()) return false;
    revision_ = frame.lights.revision();
    std::vector<float> weights;
    for (const shader::Light& light : frame.lights.lights())
        weights.push_back(light.radiance == glm::vec3(0.0f) ? 0.0f : weight_(light));
    return table_.set(alias_table_bytes(weights));
}

} // namespace vigil::vkpt
