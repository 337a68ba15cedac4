// SPDX-License-Identifier: GPL-2.0-or-later
// Quake's angles as a matrix: pitch (down positive), yaw (counter-clockwise from +x), roll, in
// degrees.
#pragma once

#include <glm/glm.hpp>

namespace vigil {

/// Columns: forward, left, up; the rotation Rz(yaw) Ry(pitch) Rx(roll).
inline glm::mat3 rotation_from_angles(const glm::vec3& angles) {
    const glm::vec3 radians = glm::radians(angles);
    const glm::vec3 c = glm::cos(radians), s = glm::sin(radians);
    const glm::vec3 forward(c.x * c.y, c.x * s.y, -s.x);
    const glm::vec3 left(s.z * s.x * c.y - c.z * s.y, s.z * s.x * s.y + c.z * c.y, s.z * c.x);
    return {forward, left, glm::cross(forward, left)};
}

} // namespace vigil
