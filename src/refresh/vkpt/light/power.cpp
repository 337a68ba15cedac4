// SPDX-License-Identifier: GPL-2.0-or-later
// Technique `power`: lights in proportion to what they emit, area times luminance
// (shaders/light/power.glsl).
#include "refresh/vkpt/light/alias_technique.h"
#include "refresh/vkpt/light/light_power.h"

#include <algorithm>

namespace vigil::vkpt {

std::unique_ptr<LightTechnique> make_power(const TechniqueContext& context) {
    return std::make_unique<AliasTechnique>(context, [](const shader::Light& light) {
        return std::max(light_power(light), 1e-30f); // tiny ones keep a chance
    });
}

} // namespace vigil::vkpt
