// SPDX-License-Identifier: GPL-2.0-or-later
// Turns the scene of a frame into what scene_export.h writes.
#pragma once

#include "refresh/settings.h"
#include "refresh/vkpt/export/scene_export.h"
#include "shared/frame_params.h"

namespace vigil::vkpt {

class Scene;

/// The scene as it was prepared last, seen through the camera, sky and sun of `params`. Emission is
/// uniform over each triangle, as light sampling has it; animated textures show their first frame.
ExportScene export_scene_of(const Scene& scene, const shader::FrameParams& params,
                            const refresh::Settings& settings);

} // namespace vigil::vkpt
