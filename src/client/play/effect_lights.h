// SPDX-License-Identifier: GPL-2.0-or-later
// The lights of Quake II's effects: colours and radii as in the game, and what they become here.
//
// The game adds (radius - distance) to the brightness of surfaces, on a scale where a surface light
// of VALUE v and area A adds 0.4 v A / distance^2. Here such a light has radiance 0.1 v. The
// glowing ball that stands for an effect lights a surface as much as the game does at half the
// radius:
//
//     size of the ball   radius / 25
//     radiance           11.4 radius * colour
//
// so that both shrink when an effect fades. Nearer it is brighter than in the game and farther it
// does not end, as light does.
#pragma once

#include "formats/dm2_message.h"
#include "formats/game_palette.h"
#include "refresh/refresh.h"

namespace vigil::client {

struct EffectLight {
    float radius = 0.0f; ///< of the game, in map units; 0: none
    glm::vec3 color{0.0f};
};

/// The lights that an entity's effects and render flags give it. Those that darken in the game
/// (trackers) give none. Shells (quad damage, ...) glow faintly, which the game's do not.
std::vector<EffectLight> entity_lights(const dm2::EntityState& entity);

/// The flash of a weapon, and for how many seconds it stays.
struct Flash {
    EffectLight light;
    float seconds = 0.1f;
};
Flash muzzle_flash(const dm2::MuzzleFlash& flash);

/// What an announced effect looks like: a light that fades over its time, a number of particles.
struct Burst {
    EffectLight light;
    float seconds = 0.0f; ///< that the light takes to fade
    int particles = 0;
    glm::vec3 particle_color{1.0f};
    float particle_speed = 0.0f; ///< map units per second, in all directions
};
Burst burst_of(const dm2::TempEntity& effect);

/// The glowing ball of an effect.
refresh::DynamicLight dynamic_light(uint32_t id, const glm::vec3& origin, const EffectLight& light);

/// The colour of a laser: the mean of four of the game's palette (formats/game_palette.h).
glm::vec3 laser_color(uint32_t skin);

} // namespace vigil::client
