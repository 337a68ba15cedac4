// SPDX-License-Identifier: GPL-2.0-or-later
// Light for levels that were made for light maps alone: where no face shines and no sky is seen,
// the level's `light` entities become small balls. A level that has light of its own is as it is.
#pragma once

#include "formats/bsp.h"
#include "refresh/refresh.h"

#include <vector>

namespace vigil::yamagi {

/// A ball, at full brightness, and the style that flickers or switches it.
struct LevelLight {
    glm::vec3 origin{0.0f};
    glm::vec3 radiance{0.0f};
    int style = 0;
};

/// Radius of the balls, map units.
inline constexpr float level_light_radius = 2.0f;

/// Whether a face of the level shines, or shows the sky.
bool has_own_light(const Bsp& bsp);

/// What the level's entities ask for: `light`, with its keys light, _color and style. Without any,
/// one over each place where a player starts, so that no level is black.
std::vector<LevelLight> entity_lights(const Bsp& bsp);

} // namespace vigil::yamagi
