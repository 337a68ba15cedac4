// SPDX-License-Identifier: GPL-2.0-or-later
#include "game/view_axes.h"

#include <glm/glm.hpp>

namespace vigil {

ViewAxes view_axes(const glm::vec3& angles) {
    const glm::vec3 s = glm::sin(glm::radians(angles)); // pitch, yaw, roll
    const glm::vec3 c = glm::cos(glm::radians(angles));
    ViewAxes axes;
    axes.forward = {c.x * c.y, c.x * s.y, -s.x};
    axes.right = {-s.z * s.x * c.y + c.z * s.y, -s.z * s.x * s.y - c.z * c.y, -s.z * c.x};
    axes.up = {c.z * s.x * c.y + s.z * s.y, c.z * s.x * s.y - s.z * c.y, c.z * c.x};
    return axes;
}

glm::mat3 model_rotation(const glm::vec3& angles) {
    const ViewAxes axes = view_axes(angles);
    return {axes.forward, -axes.right, axes.up};
}

} // namespace vigil
