// SPDX-License-Identifier: GPL-2.0-or-later
// Light paths that the host traces before the first frame, to know where that will have samples.
#pragma once

#include "refresh/vkpt/pathtrace/frame_description.h"

#include <vector>

namespace vigil {
struct Bsp;
}

namespace vigil::vkpt {

/// Where `count` paths meet the static world, in map units. They go through points spread over the
/// camera's picture, and `bounces` times on, as from white diffuse surfaces. The sky is no surface.
/// Empty where the camera is in solid space, or nowhere.
std::vector<glm::vec3> first_paths(const Bsp& bsp, const FrameDescription& camera, uint32_t count,
                                   int bounces);

} // namespace vigil::vkpt
