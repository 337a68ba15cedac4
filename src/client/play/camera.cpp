// SPDX-License-Identifier: GPL-2.0-or-later
// Flight of the camera. Angles follow Quake's conventions.
#include "client/play/camera.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace vigil::client {

namespace {

constexpr float turn_speed = 140.0f; // degrees per second by keys, as in Quake
constexpr float fast_factor = 3.0f;

/// Into [-180, 180).
float wrap_degrees(float degrees) {
    return degrees - 360.0f * std::floor((degrees + 180.0f) / 360.0f);
}

} // namespace

void Camera::set(const glm::vec3& origin, const glm::vec3& angles) {
    origin_ = origin;
    angles_ = {std::clamp(wrap_degrees(angles.x), -90.0f, 90.0f), wrap_degrees(angles.y),
               wrap_degrees(angles.z)};
}

void Camera::set_speed(float units_per_second) {
    speed_ = std::clamp(units_per_second, slowest, fastest);
}

void Camera::look(const FlightInput& input, float seconds) {
    const glm::vec3 turned(-input.look_up, input.turn_left, 0.0f);
    if (turned != glm::vec3(0.0f)) set(origin_, angles_ + turned * (turn_speed * seconds));
}

void Camera::fly(const FlightInput& input, float seconds) {
    look(input, seconds);
    const ViewAxes axes = view_axes(angles_);
    glm::vec3 direction = axes.forward * input.forward + axes.right * input.right +
                          glm::vec3(0.0f, 0.0f, 1.0f) * input.up;
    // Two keys at once are not faster than one; half a key press stays half.
    const float length = glm::length(direction);
    if (length > 1.0f) direction /= length;
    origin_ += direction * (speed_ * (input.fast ? fast_factor : 1.0f) * seconds);
}

void Camera::turn(const glm::vec2& delta, float degrees_per_count, bool invert) {
    const float pitch = delta.y * degrees_per_count * (invert ? -1.0f : 1.0f);
    const float yaw = -delta.x * degrees_per_count;
    // The mouse must not carry the head over backwards, so pitch stops at the poles before
    // wrapping.
    const float new_pitch = std::clamp(angles_.x + pitch, -90.0f, 90.0f);
    set(origin_, {new_pitch, angles_.y + yaw, angles_.z});
}

std::string Camera::setviewpos_text() const {
    return fmt::format("setviewpos {:.2f} {:.2f} {:.2f} {:.2f} {:.2f} {:.2f}", origin_.x, origin_.y,
                       origin_.z, angles_.x, angles_.y, angles_.z);
}

} // namespace vigil::client
