// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/scene/sun.h"

#include "shared/ltc.h"

#include <algorithm>
#include <cmath>

namespace vigil::vkpt {

namespace {

/// The triangle reaches a little beyond the cone: whatever sees a part of the sun sees a part of
/// it.
constexpr float beyond = 1e-3f;
/// Of a wider sun only so much has a place in the triangle's plane.
constexpr float widest = 1.5690f; // 89.9 degrees

} // namespace

glm::vec3 Sun::radiance() const {
    // A disc of radiance L and half angle a lights a surface that faces it with L * pi * sin(a)^2.
    const float sine = std::sin(half_angle);
    return sine > 0.0f ? irradiance / (shader::PI * sine * sine) : glm::vec3(0.0f);
}

glm::vec3 Sun::flux() const {
    return irradiance * (2.0f / (1.0f + std::cos(half_angle)));
}

shader::Light sun_light(const Sun& sun, float area) {
    const float radius = (1.0f + beyond) * std::tan(std::min(sun.half_angle, widest)) + beyond;
    const shader::Basis basis = shader::make_basis(sun.direction);
    const auto corner = [&](float x, float y) {
        return sun.direction + 2.0f * radius * (x * basis.tangent + y * basis.bitangent);
    };
    const float y = std::sqrt(0.75f);
    shader::Light light;
    light.v0 = corner(1.0f, 0.0f);
    light.e1 = corner(-0.5f, -y) - light.v0;
    light.e2 = corner(-0.5f, y) - light.v0;
    light.flags = shader::LIGHT_SUN;
    // What it does to a surface that faces it is right.
    const float form = shader::form_factor(sun.direction, light.v0, light.e1, light.e2,
                                           shader::light_facing(light, glm::vec3(0.0f)));
    light.radiance =
        area > 0.0f && form > 0.0f ? sun.irradiance / (shader::PI * form) : glm::vec3(0.0f);
    // Its power, and so its weight beside lamps, is irradiance times area: the distance says so.
    const float distance = std::sqrt(std::max(area, 1.0f) * form / shader::light_area(light));
    light.v0 *= distance;
    light.e1 *= distance;
    light.e2 *= distance;
    return light;
}

} // namespace vigil::vkpt
