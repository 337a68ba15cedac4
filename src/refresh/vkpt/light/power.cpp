// SPDX-License-Identifier: GPL-2.0-or-later
// Technique `power`: lights in proportion to what they emit, area times luminance
// (shaders/light/power.glsl).
#include "refresh/vkpt/light/alias_technique.h"
#include "shared/brdf.h"

#include <algorithm>

namespace vigil::vkpt {

std::unique_ptr<LightTechnique> make_power(const TechniqueContext& context) {
    return std::make_unique<AliasTechnique>(context, [](const shader::Light& light) {
        const float area = 0.5f * glm::length(glm::cross(light.e1, light.e2));
        // A light of one pure colour still shines; tiny ones keep a chance.
        return std::max(area * shader::luminance(light.radiance), 1e-30f);
    });
}

} // namespace vigil::vkpt
