// SPDX-License-Identifier: GPL-2.0-or-later
// The sun: a cone of directions, evenly bright. As a light it is a triangle around that cone, as
// the choice of lights asks for one (shader::LIGHT_SUN); directions are drawn in the cone itself.
#pragma once

#include "shared/scene_types.h"

#include <glm/glm.hpp>

namespace vigil::vkpt {

struct Sun {
    glm::vec3 direction{0.0f, 0.0f, 1.0f}; // unit, towards it
    glm::vec3 irradiance{0.0f};            // on a surface that faces it; 0: there is no sun
    float half_angle = 0.0f;               // radians, 0 to pi / 2; 0: a point
    bool operator==(const Sun&) const = default;

    /// Radiance of the disc; 0 for a point, which no ray meets.
    glm::vec3 radiance() const;
    /// Radiance times solid angle: finite for a point, too.
    glm::vec3 flux() const;
};

/// The sun as a light. `area` is that of all sky faces across its rays (map units^2): its power is
/// what they let in. Without any, its radiance is 0.
shader::Light sun_light(const Sun& sun, float area);

} // namespace vigil::vkpt
