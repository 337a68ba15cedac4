// SPDX-License-Identifier: GPL-2.0-or-later
// The flashlight in the hand of who looks: right of the eye and a little below, shining where it
// looks.
#pragma once

#include "refresh/refresh.h"

namespace vigil::client {

inline constexpr uint32_t flashlight_id = 0xb0000000;

/// For an eye at this place, looking along these angles.
refresh::Spot flashlight(const glm::vec3& eye, const glm::vec3& angles);

} // namespace vigil::client
