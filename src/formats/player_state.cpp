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

glm::vec3 rounded_coordinates(glm::vec3 place) {
    for (int i = 0; i < 3; ++i)
        place[i] = static_cast<float>(packed_coordinate(place[i])) * 0.125f;
    return place;
}

glm::vec3 rounded_quarters(glm::vec3 offset) {
    for (int i = 0; i < 3; ++i)
        offset[i] = static_cast<float>(packed_quarter(offset[i])) * 0.25f;
    return offset;
}

} // namespace

PlayerState read_player(MessageReader& reader, const PlayerState& from) {
    PlayerState to = from;
    const uint32_t bits = reader.u16();
    const auto has = [bits](uint32_t bit) { return (bits & bit) != 0; };
    if (has(PS_M_TYPE)) to.movement_type = reader.u8();
    if (has(PS_M_ORIGIN)) to.origin = reader.position();
    if (has(PS_M_VELOCITY)) to.velocity = reader.position();
    if (has(PS_M_TIME)) to.movement_time = reader.u8();
    if (has(PS_M_FLAGS)) to.movement_flags = reader.u8();
    if (has(PS_M_GRAVITY)) to.gravity = reader.i16();
    if (has(PS_M_DELTA_ANGLES)) {
        for (int16_t& angle : to.delta_angles)
            angle = reader.i16();
    }
    if (has(PS_VIEWOFFSET)) to.view_offset = reader.quarters();
    if (has(PS_VIEWANGLES)) {
        for (int i = 0; i < 3; ++i)
            to.view_angles[i] = reader.angle16();
    }
    if (has(PS_KICKANGLES)) to.kick_angles = reader.quarters();
    if (has(PS_WEAPONINDEX)) to.weapon_model = reader.u8();
    if (has(PS_WEAPONFRAME)) {
        to.weapon_frame = reader.u8();
        to.weapon_offset = reader.quarters();
        to.weapon_angles = reader.quarters();
    }
    if (has(PS_BLEND)) {
        for (uint8_t& channel : to.blend)
            channel = reader.u8();
    }
    if (has(PS_FOV)) to.fov = reader.u8();
    if (has(PS_RDFLAGS)) to.render_flags = reader.u8();
    const uint32_t changed = reader.u32();
    for (size_t i = 0; i < to.stats.size(); ++i) {
        if ((changed >> i & 1) != 0) to.stats[i] = reader.i16();
    }
    return to;
}

void write_player(MessageWriter& writer, const PlayerState& before, const PlayerState& now) {
    const PlayerState from = player_as_sent(before), to = player_as_sent(now);
    uint32_t bits = 0;
    const auto compare = [&bits](bool differs, uint32_t bit) { bits |= differs ? bit : 0; };
    compare(to.movement_type != from.movement_type, PS_M_TYPE);
    compare(to.origin != from.origin, PS_M_ORIGIN);
    compare(to.velocity != from.velocity, PS_M_VELOCITY);
    compare(to.movement_time != from.movement_time, PS_M_TIME);
    compare(to.movement_flags != from.movement_flags, PS_M_FLAGS);
    compare(to.gravity != from.gravity, PS_M_GRAVITY);
    compare(to.delta_angles != from.delta_angles, PS_M_DELTA_ANGLES);
    compare(to.view_offset != from.view_offset, PS_VIEWOFFSET);
    compare(to.view_angles != from.view_angles, PS_VIEWANGLES);
    compare(to.kick_angles != from.kick_angles, PS_KICKANGLES);
    compare(to.weapon_model != from.weapon_model, PS_WEAPONINDEX);
    compare(to.weapon_frame != from.weapon_frame || to.weapon_offset != from.weapon_offset ||
                to.weapon_angles != from.weapon_angles,
            PS_WEAPONFRAME);
    compare(to.blend != from.blend, PS_BLEND);
    compare(to.fov != from.fov, PS_FOV);
    compare(to.render_flags != from.render_flags, PS_RDFLAGS);
    const auto has = [bits](uint32_t bit) { return (bits & bit) != 0; };

    writer.i16(static_cast<int32_t>(bits));
    if (has(PS_M_TYPE)) writer.u8(to.movement_type);
    if (has(PS_M_ORIGIN)) writer.position(to.origin);
    if (has(PS_M_VELOCITY)) writer.position(to.velocity);
    if (has(PS_M_TIME)) writer.u8(to.movement_time);
    if (has(PS_M_FLAGS)) writer.u8(to.movement_flags);
    if (has(PS_M_GRAVITY)) writer.i16(to.gravity);
    if (has(PS_M_DELTA_ANGLES)) {
        for (const int16_t angle : to.delta_angles)
            writer.i16(angle);
    }
    if (has(PS_VIEWOFFSET)) writer.quarters(to.view_offset);
    if (has(PS_VIEWANGLES)) {
        for (int i = 0; i < 3; ++i)
            writer.angle16(to.view_angles[i]);
    }
    if (has(PS_KICKANGLES)) writer.quarters(to.kick_angles);
    if (has(PS_WEAPONINDEX)) writer.u8(to.weapon_model);
    if (has(PS_WEAPONFRAME)) {
        writer.u8(to.weapon_frame);
        writer.quarters(to.weapon_offset);
        writer.quarters(to.weapon_angles);
    }
    if (has(PS_BLEND)) writer.raw(to.blend);
    if (has(PS_FOV)) writer.u8(to.fov);
    if (has(PS_RDFLAGS)) writer.u8(to.render_flags);
    uint32_t changed = 0;
    for (size_t i = 0; i < to.stats.size(); ++i) {
        if (to.stats[i] != from.stats[i]) changed |= 1u << i;
    }
    writer.u32(changed);
    for (size_t i = 0; i < to.stats.size(); ++i) {
        if ((changed >> i & 1) != 0) writer.i16(to.stats[i]);
    }
}

PlayerState player_as_sent(PlayerState state) {
    state.origin = rounded_coordinates(state.origin);
    state.velocity = rounded_coordinates(state.velocity);
    state.view_offset = rounded_quarters(state.view_offset);
    state.kick_angles = rounded_quarters(state.kick_angles);
    state.weapon_offset = rounded_quarters(state.weapon_offset);
    state.weapon_angles = rounded_quarters(state.weapon_angles);
    for (int i = 0; i < 3; ++i)
        state.view_angles[i] =
            static_cast<float>(packed_angle16(state.view_angles[i])) * (360.0f / 65536.0f);
    return state;
}

} // namespace vigil::dm2
