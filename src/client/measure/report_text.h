// SPDX-License-Identifier: GPL-2.0-or-later
// What the console says of a renderer's reports (refresh/reports.h): lines of text, without a line
// break at the end.
#pragma once

#include "refresh/refresh.h"

#include <string>

namespace vigil::client {

/// `scene`.
std::string scene_text(const refresh::SceneReport& scene, const refresh::GuidingReport& guiding,
                       const refresh::Health& health, const refresh::Settings& settings);

/// `guiding`: its memory.
std::string guiding_text(const refresh::GuidingReport& guiding);

/// `vlcinfo`: the leaf under the crosshair and its light cache.
std::string light_cache_text(const refresh::GuidingReport& guiding);

/// `cdqinfo`: that leaf and its quadtree of directions.
std::string quadtree_text(const refresh::GuidingReport& guiding);

} // namespace vigil::client
