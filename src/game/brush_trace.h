// SPDX-License-Identifier: GPL-2.0-or-later
// Moves a box through one tree of a level against the brushes in its leafs. The tree may be placed
// and turned; CollisionWorld puts several together.
#pragma once

#include "game/trace.h"

#include <glm/mat3x3.hpp>

namespace vigil {

/// Where a model of the level stands: its points p are at rotation * p + origin.
struct Placement {
    glm::vec3 origin{0.0f};
    glm::vec3 angles{0.0f}; ///< pitch, yaw, roll in degrees
};

/// Moves `box` from `start` to `end` against the brushes below `headnode` whose contents have a bit
/// of `mask`, and keeps in `trace` whichever hit comes first: that of before or this one's, which
/// then belongs to `owner`. The box keeps its axes; turned brushes count with their own planes only
/// (compilers' bevels lie along the model's axes), so near sharp edges of a turned brush the box
/// stops a little early, never late. `trace.end` is not touched.
void trace_tree(const Bsp& bsp, int32_t headnode, const Placement& placement,
                const glm::vec3& start, const glm::vec3& end, const Box& box, uint32_t mask,
                int owner, Trace& trace);

} // namespace vigil
