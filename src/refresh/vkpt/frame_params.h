// SPDX-License-Identifier: GPL-2.0-or-later
// Fills a FrameDescription from a frame, the scene and the variables.
#pragma once

#include "refresh/refresh.h"
#include "refresh/vkpt/pathtrace/frame_description.h"

namespace vigil::vkpt {

class Scene;

/// The camera's part: origin, axes, size, pixel angle. `view.fov` is horizontal at 4:3, unless it
/// says `fov_y` (see refresh.h).
void set_camera(FrameDescription& params, const refresh::View& view, glm::uvec2 size);

/// Time, sky, sun and light count.
void set_scene(FrameDescription& params, const Scene& scene, const refresh::Settings& settings,
               double time_s);

} // namespace vigil::vkpt
