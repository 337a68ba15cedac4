// SPDX-License-Identifier: GPL-2.0-or-later
// A box that moves along a line, and what it hits first. Map units throughout.
#pragma once

#include "formats/bsp.h"

#include <glm/vec3.hpp>

#include <cstdint>

namespace vigil {

/// An axis-aligned box around a place; the default is a point.
struct Box {
    glm::vec3 mins{0.0f}, maxs{0.0f};
};

/// Traces stop this far before what they hit, so that the next one starts outside of it.
inline constexpr float trace_gap = 1.0f / 32.0f;

/// Owner numbers of a Trace. Others are numbers of entities.
inline constexpr int owner_none = -1;
inline constexpr int owner_world = 0;

struct Trace {
    float fraction = 1.0f; ///< of the way that is free, 0..1
    glm::vec3 end{0.0f};   ///< where the box comes to rest
    /// Of the plane that was hit, looking out of the solid. Zero where nothing was hit, and where
    /// the box was inside a solid all the way.
    glm::vec3 normal{0.0f};
    uint32_t contents = 0;      ///< ContentsFlag bits of the brush that was hit
    uint32_t surface_flags = 0; ///< SurfaceFlag bits of the side that was hit
    int owner = owner_none;     ///< whose brush it was
    bool start_solid = false;   ///< the box begins inside a solid
    bool all_solid = false;     ///< and stays in one solid all the way; fraction is 0

    bool hit() const { return owner != owner_none; }
};

/// What stops a player, and what it swims in.
inline constexpr uint32_t mask_player_solid =
    CONTENTS_SOLID | CONTENTS_WINDOW | CONTENTS_PLAYERCLIP | CONTENTS_MONSTER;
inline constexpr uint32_t mask_shot =
    CONTENTS_SOLID | CONTENTS_WINDOW | CONTENTS_MONSTER | CONTENTS_DEADMONSTER;
inline constexpr uint32_t mask_water = CONTENTS_WATER | CONTENTS_LAVA | CONTENTS_SLIME;
inline constexpr uint32_t mask_current = CONTENTS_CURRENT_0 | CONTENTS_CURRENT_90 |
                                         CONTENTS_CURRENT_180 | CONTENTS_CURRENT_270 |
                                         CONTENTS_CURRENT_UP | CONTENTS_CURRENT_DOWN;

} // namespace vigil
