// SPDX-License-Identifier: GPL-2.0-or-later
// Directions of Quake's angles: pitch (down positive), yaw (counter-clockwise from +x), roll
// (clockwise), in degrees.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace vigil {

/// Unit vectors.
struct ViewAxes {
    glm::vec3 forward{1.0f, 0.0f, 0.0f};
    glm::vec3 right{0.0f, -1.0f, 0.0f};
    glm::vec3 up{0.0f, 0.0f, 1.0f};
};
ViewAxes view_axes(const glm::vec3& angles);

/// Turns vectors of a model with these angles into the world: its columns are where the model's
/// +x, +y and +z point.
glm::mat3 model_rotation(const glm::vec3& angles);

} // namespace vigil
