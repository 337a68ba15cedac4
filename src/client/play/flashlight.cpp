// SPDX-License-Identifier: GPL-2.0-or-later
#include "client/play/flashlight.h"

#include "game/view_axes.h"

namespace vigil::client {

namespace {

/// From the eye to the mouth: near enough that a player's box, which walls keep out, holds all of
/// it, and beside the picture.
constexpr glm::vec3 hand(3.0f, 9.0f, -6.0f); // forward, right, up
constexpr float radius = 1.5f;
/// As bright on the axis as a surface light of value 40 and 37 x 37 units at the same distance.
constexpr float radiance = 5000.0f;

} // namespace

refresh::Spot flashlight(const glm::vec3& eye, const glm::vec3& angles) {
    const ViewAxes axes = view_axes(angles);
    const glm::vec3 mouth = eye + hand.x * axes.forward + hand.y * axes.right + hand.z * axes.up;
    return {flashlight_id, mouth, angles, radius, radiance * glm::vec3(1.0f, 0.95f, 0.85f)};
}

} // namespace vigil::client
