// SPDX-License-Identifier: GPL-2.0-or-later
// Through which parts of a model the sky shines in, as few lights: coplanar sky faces that lie
// together share a rectangle, a window, cut into cells of two triangles each (portals: Bitterli,
// Novak, Jarosz, "Portal-Masked Environment Map Sampling", 2015, give the idea of sampling the sky
// by where it is let in). A window may reach beyond its faces, over walls: who samples it looks
// whether the ray meets the sky there.
#pragma once

#include "refresh/vkpt/scene/model_geometry.h"

#include <optional>
#include <span>
#include <vector>

namespace vigil::vkpt {

struct SkyWindows {
    /// Window after window, cell after cell (columns first), two halves each. The first light of a
    /// window says in its flags how many cells there are; its e1 and e2 are the edges of one.
    /// `coverage` is the share of a half that sky faces cover; one that they cover all of says so
    /// in its flags.
    std::vector<LightSource> lights;
    /// Per triangle: the first light of its window; shader::NONE if it has no area.
    std::vector<uint32_t> first_lights;
};

/// Windows for sky faces in object space, wound so that the lit side is inside the level. There are
/// at most `most_lights` lights (at least 2), unless there are more windows than that.
SkyWindows make_sky_windows(std::span<const shader::BvhTriangle> triangles, uint32_t most_lights);

} // namespace vigil::vkpt
