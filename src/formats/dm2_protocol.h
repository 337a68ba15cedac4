// SPDX-License-Identifier: GPL-2.0-or-later
// Numbers of Quake II's network protocol 34, which is also what .dm2 demos hold: message types,
// the layout of the configuration strings, limits, and the names of effects. Facts of the game; the
// bits of delta compression are in entity_state.cpp and player_state.cpp.
#pragma once

#include <cstdint>

namespace vigil::dm2 {

inline constexpr int32_t protocol_version = 34;
/// Largest block that is accepted; engines write at most 1,400 bytes (some 32 KiB).
inline constexpr uint32_t most_block_bytes = 0x10000;
/// Blocks that the first Quake II plays are not larger.
inline constexpr size_t portable_block_bytes = 1390;
inline constexpr uint32_t most_entities = 1024; ///< entities are 1 .. most_entities - 1
/// Entities of a frame that the first Quake II has room for.
inline constexpr size_t portable_frame_entities = 128;
inline constexpr double frames_per_second = 10.0; ///< of the server

enum MessageType : uint8_t {
    svc_muzzleflash = 1,
    svc_muzzleflash2 = 2,
    svc_temp_entity = 3,
    svc_layout = 4,
    svc_inventory = 5,
    svc_nop = 6,
    svc_disconnect = 7,
    svc_reconnect = 8,
    svc_sound = 9,
    svc_print = 10,
    svc_stufftext = 11,
    svc_serverdata = 12,
    svc_configstring = 13,
    svc_spawnbaseline = 14,
    svc_centerprint = 15,
    svc_download = 16,
    svc_playerinfo = 17,     // inside svc_frame only
    svc_packetentities = 18, // inside svc_frame only
    svc_frame = 20,
};

/// Configuration strings: what the server tells every client, by number.
enum ConfigStringIndex : uint32_t {
    CS_NAME = 0,
    CS_SKY = 2,
    CS_SKYAXIS = 3,
    CS_SKYROTATE = 4,
    CS_AIRACCEL = 29,
    CS_MAXCLIENTS = 30,
    CS_MAPCHECKSUM = 31,
    CS_MODELS = 32, // + model index; 1 is the level's file
    CS_SOUNDS = 288,
    CS_LIGHTS = 800, // + light style
    CS_ITEMS = 1056,
    CS_PLAYERSKINS = 1312, // + player: "name\model/skin"
    config_string_count = 2080,
};
inline constexpr uint32_t model_count = 256;
inline constexpr uint32_t light_style_count = 256;

/// EntityState::effects.
enum Effect : uint32_t {
    EF_ROTATE = 0x1, // turns on the spot
    EF_GIB = 0x2,
    EF_BLASTER = 0x8,
    EF_ROCKET = 0x10,
    EF_GRENADE = 0x20,
    EF_HYPERBLASTER = 0x40,
    EF_BFG = 0x80,
    EF_COLOR_SHELL = 0x100,
    EF_POWERSCREEN = 0x200,
    EF_ANIM01 = 0x400,
    EF_ANIM23 = 0x800,
    EF_ANIM_ALL = 0x1000,
    EF_ANIM_ALLFAST = 0x2000,
    EF_QUAD = 0x8000,
    EF_PENT = 0x10000,
    EF_FLAG1 = 0x40000,
    EF_FLAG2 = 0x80000,
    EF_IONRIPPER = 0x100000,
    EF_GREENGIB = 0x200000,
    EF_BLUEHYPERBLASTER = 0x400000,
    EF_SPINNINGLIGHTS = 0x800000,
    EF_PLASMA = 0x1000000,
    EF_TRAP = 0x2000000,
    EF_TRACKER = 0x4000000,
    EF_DOUBLE = 0x8000000,
    EF_TAGTRAIL = 0x20000000,
    EF_HALF_DAMAGE = 0x40000000,
};

/// EntityState::render_flags.
enum RenderFlag : uint32_t {
    RF_MINLIGHT = 0x1, // is never quite dark
    RF_FULLBRIGHT = 0x8,
    RF_TRANSLUCENT = 0x20,
    RF_BEAM = 0x80, // a beam from origin to old_origin; `frame` is its diameter, `skin` its colours
    RF_GLOW = 0x200, // pulses: things to pick up
    RF_SHELL_RED = 0x400,
    RF_SHELL_GREEN = 0x800,
    RF_SHELL_BLUE = 0x1000,
};

/// EntityState::event: lasts one frame.
enum EntityEvent : uint8_t {
    EV_PLAYER_TELEPORT = 6,
    EV_OTHER_TELEPORT = 7,
};

/// PlayerState::movement_type and movement_flags.
inline constexpr uint8_t PM_FREEZE = 4;
inline constexpr uint8_t PMF_NO_PREDICTION = 64;

} // namespace vigil::dm2
