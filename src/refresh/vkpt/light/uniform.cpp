// SPDX-License-Identifier: GPL-2.0-or-later
// Technique `uniform`: every light that shines has the same probability
// (shaders/light/uniform.glsl).
#include "refresh/vkpt/light/alias_technique.h"

namespace vigil::vkpt {

std::unique_ptr<LightTechnique> make_uniform(const TechniqueContext& context) {
    return std::make_unique<AliasTechnique>(context, [](const shader::Light&) { return 1.0f; });
}

} // namespace vigil::vkpt
