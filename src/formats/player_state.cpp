// SPDX-License-Identifier: GPL-2.0-or-later
#include "formats/player_state.h"

namespace vigil::dm2 {

namespace {

enum PlayerBit : uint32_t {
    PS_M_TYPE = 1u << 0,
    PS_M_ORIGIN = 1u << 1,
    PS_M_VELOCITY = 1u << 2,
    PS_M_TIME = 1u << 3,
    PS_M_FLAGS = 1u << 4,
    PS_M_GRAVITY = 1u << 5,
    PS_M_DELTA_ANGLES = 1u << 6,
    PS_VIEWOFFSET = 1u << 7,
    PS_VIEWANGLES = 1u << 8,
    PS_KICKANGLES = 1u << 9,
    PS_BLEND = 1u << 10,
    PS_FOV = 1u << 11,
    PS_WEAPONINDEX = 1u << 12,
    PS_WEAPONFRAME = 1u << 13,
    PS_RDFLAGS = 1u << 14,
};

/// The parts of a player that `bits` names.
void parts(auto& wire, uint32_t bits, Is<PlayerState> auto& player) {
    const auto has = [bits](uint32_t bit) { return (bits & bit) != 0; };
    if (has(PS_M_TYPE)) wire.u8(player.movement_type);
    if (has(PS_M_ORIGIN)) wire.position(player.origin);
    if (has(PS_M_VELOCITY)) wire.position(player.velocity);
    if (has(PS_M_TIME)) wire.u8(player.movement_time);
    if (has(PS_M_FLAGS)) wire.u8(player.movement_flags);
    if (has(PS_M_GRAVITY)) wire.i16(player.gravity);
    if (has(PS_M_DELTA_ANGLES)) {
        for (auto& angle : player.delta_angles)
            wire.i16(angle);
    }
    if (has(PS_VIEWOFFSET)) wire.quarters(player.view_offset);
    if (has(PS_VIEWANGLES)) wire.angles16(player.view_angles);
    if (has(PS_KICKANGLES)) wire.quarters(player.kick_angles);
    if (has(PS_WEAPONINDEX)) wire.u8(player.weapon_model);
    if (has(PS_WEAPONFRAME)) {
        wire.u8(player.weapon_frame);
        wire.quarters(player.weapon_offset);
        wire.quarters(player.weapon_angles);
    }
    if (has(PS_BLEND)) {
        for (auto& channel : player.blend)
            wire.u8(channel);
    }
    if (has(PS_FOV)) wire.u8(player.fov);
    if (has(PS_RDFLAGS)) wire.u8(player.render_flags);
}

void stats(auto& wire, uint32_t changed, Is<PlayerState> auto& player) {
    for (size_t i = 0; i < player.stats.size(); ++i) {
        if ((changed >> i & 1) != 0) wire.i16(player.stats[i]);
    }
}

} // namespace

PlayerState read_player(MessageReader& reader, const PlayerState& from) {
    PlayerState to = from;
    uint32_t bits = 0, changed = 0;
    reader.u16(bits);
    parts(reader, bits, to);
    reader.u32(changed);
    stats(reader, changed, to);
    return to;
}

void write_player(MessageWriter& writer, const PlayerState& from, const PlayerState& to) {
    uint32_t bits = 0, changed = 0;
    for (uint32_t bit = PS_M_TYPE; bit <= PS_RDFLAGS; bit <<= 1) {
        if (!sent_equal(from, to, [bit](auto& wire, auto& state) { parts(wire, bit, state); }))
            bits |= bit;
    }
    writer.u16(bits);
    parts(writer, bits, to);
    for (size_t i = 0; i < to.stats.size(); ++i) {
        if (to.stats[i] != from.stats[i]) changed |= 1u << i;
    }
    writer.u32(changed);
    stats(writer, changed, to);
}

PlayerState player_as_sent(const PlayerState& state) {
    return as_sent(state, [](auto& wire, auto& player) { parts(wire, ~0u, player); });
}

} // namespace vigil::dm2
