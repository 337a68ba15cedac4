// SPDX-License-Identifier: GPL-2.0-or-later
// Light for levels that were made for light maps: their `light` entities become small balls where
// nothing that shines stands for them. Compilers of light maps know such points; a path tracer sees
// faces and sky alone.
#pragma once

#include "formats/material_table.h"
#include "level/level.h"
#include "refresh/refresh.h"

#include <vector>

namespace vigil::yamagi {

/// A ball, at full brightness, and the style that flickers or switches it.
struct LevelLight {
    glm::vec3 origin{0.0f};
    glm::vec3 radiance{0.0f};
    int style = 0;
    float reach = 0.0f; // how far the game's light map has light of it, map units
};

/// Radius of the balls, map units.
inline constexpr float level_light_radius = 2.0f;

/// Which of the level's `light` entities shine: the variable vigil_entity_lights.
enum class EntityLights { None, All, WhereNothingShines };

/// What the level's entities ask for: `light` and other classes that begin so, with their keys
/// light, _color and style. WhereNothingShines leaves out those that may see a face that shines, or
/// the sky, within their reach: a level's author placed them for it. Without any light in the
/// level, one over each place where a player starts, so that no level is black. `materials` say
/// which textures shine beside those of the level.
std::vector<LevelLight> entity_lights(const Level& level, const MaterialTable& materials,
                                      EntityLights wanted);

} // namespace vigil::yamagi
