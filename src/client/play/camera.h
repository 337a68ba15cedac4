// SPDX-License-Identifier: GPL-2.0-or-later
// The camera: where the eye is, where it looks, and how held keys and the mouse move it when it
// flies freely, through walls. Where a player walks, client/play/play.h places it.
#pragma once

#include "game/view_axes.h"
#include "refresh/refresh.h"

#include <glm/glm.hpp>
#include <string>

namespace vigil::client {

/// What the held keys ask for, each in [-1, 1].
struct FlightInput {
    float forward = 0.0f;
    float right = 0.0f;
    float up = 0.0f;
    float turn_left = 0.0f;
    float look_up = 0.0f;
    bool fast = false;
    bool attack = false; // of a player
};

class Camera {
public:
    /// Flying speed in map units per second, and its range.
    static constexpr float default_speed = 320.0f;
    static constexpr float slowest = 10.0f;
    static constexpr float fastest = 10000.0f;

    const glm::vec3& origin() const { return origin_; }
    const glm::vec3& angles() const { return angles_; }
    float speed() const { return speed_; }

    /// Places the eye. Yaw and roll are brought into [-180, 180), pitch into [-90, 90].
    void set(const glm::vec3& origin, const glm::vec3& angles);
    /// Clamped to [slowest, fastest].
    void set_speed(float units_per_second);

    /// Turns by the held keys for `seconds`.
    void look(const FlightInput& input, float seconds);
    /// Turns and moves by the held keys for `seconds`. Flight follows the view; up and down are
    /// world axes.
    void fly(const FlightInput& input, float seconds);
    /// Turns by mouse motion: `delta` in counts (right and down positive), `degrees_per_count`.
    void turn(const glm::vec2& delta, float degrees_per_count, bool invert);

    /// The console line that brings the camera back here.
    std::string setviewpos_text() const;

private:
    glm::vec3 origin_{0.0f};
    glm::vec3 angles_{0.0f};
    float speed_ = default_speed;
};

} // namespace vigil::client
