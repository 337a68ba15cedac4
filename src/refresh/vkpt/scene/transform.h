// SPDX-License-Identifier: GPL-2.0-or-later
// Where instances are: their places as matrices.
#pragma once

#include "common/rotation.h"

#include <glm/ext/matrix_transform.hpp>
#include <glm/glm.hpp>

#include <cmath>

namespace vigil::vkpt {

/// Turns counter-clockwise about a unit axis that looks at the viewer.
inline glm::mat3 rotation_about(const glm::vec3& axis, float degrees) {
    const glm::mat4 turn = glm::rotate(glm::mat4(1.0f), glm::radians(degrees), axis);
    return degrees == 0.0f ? glm::mat3(1.0f) : glm::mat3(turn);
}

inline glm::mat4x3 rigid_transform(const glm::vec3& origin, const glm::vec3& angles) {
    if (angles == glm::vec3(0.0f))
        return {glm::vec3(1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(0, 0, 1), origin};
    const glm::mat3 r = rotation_from_angles(angles);
    return {r[0], r[1], r[2], origin};
}

inline glm::mat4x3 scale_transform(const glm::vec3& origin, float scale) {
    return {glm::vec3(scale, 0, 0), glm::vec3(0, scale, 0), glm::vec3(0, 0, scale), origin};
}

/// What `m` places, drawn together across the line of sight from `eye` along `angles`: by `scale`
/// to the right and upwards.
inline glm::mat4x3 scaled_across_view(const glm::mat4x3& m, const glm::vec3& eye,
                                      const glm::vec3& angles, const glm::vec2& scale) {
    if (scale == glm::vec2(1.0f)) return m;
    const glm::mat3 axes = rotation_from_angles(angles); // forward, left, up
    const glm::mat3 linear =
        glm::mat3(axes[0], scale.x * axes[1], scale.y * axes[2]) * glm::transpose(axes);
    return {linear * m[0], linear * m[1], linear * m[2], eye + linear * (m[3] - eye)};
}

/// Brings the unit octahedron between two different points, `radius` units wide in the middle.
inline glm::mat4x3 spindle_transform(const glm::vec3& from, const glm::vec3& to, float radius) {
    const glm::vec3 half = 0.5f * (to - from);
    const glm::vec3 along = glm::normalize(half);
    const glm::vec3 other = std::abs(along.z) < 0.9f ? glm::vec3(0, 0, 1) : glm::vec3(1, 0, 0);
    const glm::vec3 side = glm::normalize(glm::cross(other, along));
    return {half, radius * side, radius * glm::cross(along, side), from + half};
}

/// Inverse of an affine transform with an invertible linear part.
inline glm::mat4x3 inverse_transform(const glm::mat4x3& m) {
    const glm::mat3 linear = glm::inverse(glm::mat3(m));
    return {linear[0], linear[1], linear[2], -(linear * m[3])};
}

} // namespace vigil::vkpt
