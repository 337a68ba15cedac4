// SPDX-License-Identifier: GPL-2.0-or-later
// What a frame says about the player who sees it: place, view, weapon, and what the screen shows;
// with its delta compression.
#pragma once

#include "formats/dm2_wire.h"

#include <glm/vec4.hpp>

#include <array>

namespace vigil::dm2 {

struct PlayerState {
    uint8_t movement_type = 0;
    glm::vec3 origin{0.0f};   ///< of the feet and a bit; the eye is at origin + view_offset
    glm::vec3 velocity{0.0f}; ///< map units per second
    uint8_t movement_time = 0;
    uint8_t movement_flags = 0;
    int16_t gravity = 0;
    std::array<int16_t, 3> delta_angles{}; ///< as sent: 360/65536 degrees
    glm::vec3 view_offset{0.0f};           ///< quarters
    glm::vec3 view_angles{0.0f};           ///< degrees, steps of 360/65536
    glm::vec3 kick_angles{0.0f};           ///< degrees added to the view, quarters
    uint8_t weapon_model = 0;              ///< as EntityState::models
    uint8_t weapon_frame = 0;
    glm::vec3 weapon_offset{0.0f};  ///< quarters
    glm::vec3 weapon_angles{0.0f};  ///< degrees, quarters
    std::array<uint8_t, 4> blend{}; ///< colour over the picture, RGBA
    uint8_t fov = 0;                ///< degrees
    uint8_t render_flags = 0;
    std::array<int16_t, 32> stats{};
    bool operator==(const PlayerState&) const = default;
};

/// The state that follows makes of `from`.
PlayerState read_player(MessageReader& reader, const PlayerState& from);
/// Writes what turns `from` into `to`.
void write_player(MessageWriter& writer, const PlayerState& from, const PlayerState& to);
/// The state as it arrives: places and angles rounded.
PlayerState player_as_sent(const PlayerState& state);

} // namespace vigil::dm2
