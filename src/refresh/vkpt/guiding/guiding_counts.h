// SPDX-License-Identifier: GPL-2.0-or-later
// What a frame's guiding passes counted, as named numbers for tables and reports. One list gives
// the names, and how a number follows from the counters (shaders/shared/guiding_types.h).
#pragma once

#include "refresh/refresh.h"
#include "shared/guiding_types.h"

#include <vector>

namespace vigil::vkpt {

/// Leaves of a tree of so many inner nodes.
inline uint32_t octree_leaf_count(uint32_t nodes) {
    return 7 * nodes + 1;
}

/// In the order of the passes. Samples are those of the frame before the one whose passes counted.
std::vector<refresh::FrameCount> guiding_counts(const shader::GuidingWork& work);

} // namespace vigil::vkpt
