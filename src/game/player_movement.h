// SPDX-License-Identifier: GPL-2.0-or-later
// How a player moves: walking, jumping, crouching, stepping up, swimming, climbing. The figures are
// those of Quake II's game; the code is our own. It advances in ticks of one fixed length, whatever
// the frame rate, so that the same commands always lead to the same place; pictures between two
// ticks are interpolated by whoever shows them. Where the original's result depends on the length
// of a frame (gravity within a step), this integrates exactly.
#pragma once

#include "game/collision_world.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace vigil {

/// Units are map units, seconds and degrees.
namespace player {

inline constexpr int ticks_per_second = 100;
inline constexpr float tick_s = 1.0f / ticks_per_second;

inline constexpr float gravity = 800.0f;
inline constexpr float max_speed = 300.0f;
inline constexpr float ducked_speed = 100.0f;
inline constexpr float stop_speed = 100.0f; ///< friction below this is that of this speed
inline constexpr float acceleration = 10.0f;
inline constexpr float air_acceleration = 1.0f;
inline constexpr float water_acceleration = 10.0f;
inline constexpr float friction = 6.0f;
inline constexpr float water_friction = 1.0f;
inline constexpr float water_current_speed = 400.0f;
inline constexpr float conveyor_speed = 100.0f;
inline constexpr float jump_speed = 270.0f;
inline constexpr float step_height = 18.0f;
inline constexpr float ladder_speed = 200.0f;
inline constexpr float steepest_floor = 0.7f; ///< z of the normal of what can be stood on
inline constexpr float fastest = 4095.0f;     ///< along one axis (what the original's numbers hold)

inline constexpr Box standing_box{{-16.0f, -16.0f, -24.0f}, {16.0f, 16.0f, 32.0f}};
inline constexpr Box ducked_box{{-16.0f, -16.0f, -24.0f}, {16.0f, 16.0f, 4.0f}};
inline constexpr float standing_eye = 22.0f; ///< over the origin
inline constexpr float ducked_eye = -2.0f;

} // namespace player

/// What keys and mouse ask for in a tick.
struct PlayerCommand {
    glm::vec3 angles{0.0f}; ///< of the view
    float forward = 0.0f;   ///< wished speeds along the view, units per second
    float side = 0.0f;      ///< to the right
    float up = 0.0f;        ///< 10 and more jumps, below 0 ducks; swims and climbs
    bool attack = false;
    bool operator==(const PlayerCommand&) const = default;
};

struct PlayerState {
    /// What the player's time-out is: each holds something back until `hold_ticks` have passed.
    enum class Hold { None, Landed, WaterJump, Teleported };

    glm::vec3 origin{0.0f};
    glm::vec3 velocity{0.0f};
    int ground = owner_none; ///< owner of what is stood on
    bool ducked = false;
    bool jump_held = false; ///< a jump needs the key to come up first
    bool on_ladder = false;
    /// Held up by surfaces that are each too steep to stand on. The original leaves one stuck
    /// there, unable to jump; here it counts as ground.
    bool wedged = false;
    int still_ticks = 0;     ///< in the air without getting anywhere
    int water_level = 0;     ///< 0 dry, 1 feet, 2 waist, 3 eyes
    uint32_t water_type = 0; ///< ContentsFlag bits of what the feet are in
    Hold hold = Hold::None;
    int hold_ticks = 0;
    float step_left = 0.0f; ///< the eye is this much below (a step went up): smooths stairs

    const Box& box() const { return ducked ? player::ducked_box : player::standing_box; }
    float eye_height() const { return ducked ? player::ducked_eye : player::standing_eye; }
    bool operator==(const PlayerState&) const = default;
};

/// The state one tick later: a function of its arguments alone. `touched`, if given, receives the
/// owners of what was run into, each once.
PlayerState move_player(const PlayerState& state, const PlayerCommand& command,
                        const CollisionWorld& world, std::vector<int>* touched = nullptr);

/// `ticks` of them with the same command.
PlayerState move_player_for(PlayerState state, const PlayerCommand& command,
                            const CollisionWorld& world, int ticks);

/// A player who stands at `origin`, or as near to it as there is room (up to 9 units away, upwards
/// first). Where there is none, at `origin`.
PlayerState place_player(const glm::vec3& origin, const CollisionWorld& world);

} // namespace vigil
