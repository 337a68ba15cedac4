// SPDX-License-Identifier: GPL-2.0-or-later
// What a level and its frames say of sky and sun.
#pragma once

#include "refresh/refresh.h"
#include "refresh/vkpt/scene/sun.h"

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>

namespace vigil::vkpt {

/// Sky and sun as worldspawn describes them, or the front end (the sky alone).
struct SkyDescription {
    std::string name;
    float degrees_per_second = 0.0f; // about the axis, counter-clockwise
    glm::vec3 axis{0.0f, 0.0f, 1.0f};
    std::optional<uint32_t> texture; // first of six headers
    glm::vec3 radiance{0.0f};        // factor on texels, or the radiance itself without a texture
    glm::vec3 sun_direction{0.0f, 0.0f, 1.0f};
    glm::vec3 sun_irradiance{0.0f}; // on a surface that faces the sun; 0 without a sun
    float sun_degrees = 1.0f;       // angular diameter

    /// The sun with pt_sun_scale and pt_sun_size.
    Sun sun(const refresh::Settings& settings) const;
};

} // namespace vigil::vkpt
