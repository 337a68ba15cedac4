// SPDX-License-Identifier: GPL-2.0-or-later
// From where a controller's stick stands to what it asks for.
#pragma once

#include <glm/glm.hpp>

namespace vigil::client {

/// The answer to a stick at `place` (as platform::StickEvent has it): the same direction, of a
/// length in [0, 1]. Within `dead_zone` (0 to 0.9, part of the way) of the middle it is 0, all the
/// way it is 1, and between them the power `curve` (above 0) of the part of the way beyond the dead
/// zone, so that it grows from 0 without a step. Round, not per axis: a stick that goes straight
/// ahead is not pulled to an axis, and diagonals are no faster.
glm::vec2 stick_response(glm::vec2 place, float dead_zone, float curve);

} // namespace vigil::client
