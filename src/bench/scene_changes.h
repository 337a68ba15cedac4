// SPDX-License-Identifier: GPL-2.0-or-later
// Light that changes at once while the camera stands still: a lamp, a door, or all lights.
#pragma once

#include "bench/options.h"
#include "bench/quality_renderer.h"

#include <string>
#include <vector>

namespace vigil::bench {

/// A scene, what becomes of it, and where that is seen.
struct ChangingScene {
    const char* what; // changes
    std::string view;
    Pose pose;
    SceneChange before, after;
};

/// One for each place of the renderer; of doors the one, and the view of it, that hides most.
/// Leaves the renderer in any of the scenes. Throws Error where no door is seen.
std::vector<ChangingScene> changing_scenes(const QualityOptions& options,
                                           QualityRenderer& renderer);

} // namespace vigil::bench
