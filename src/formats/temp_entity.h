// SPDX-License-Identifier: GPL-2.0-or-later
// Effects that the server only announces (explosions, sparks, trails, beams): one table says by
// type what a message carries.
#pragma once

#include "formats/dm2_wire.h"

#include <string_view>

namespace vigil::dm2 {

enum TempEntityType : uint8_t {
    TE_GUNSHOT = 0,
    TE_BLOOD = 1,
    TE_BLASTER = 2,
    TE_RAILTRAIL = 3,
    TE_SHOTGUN = 4,
    TE_EXPLOSION1 = 5,
    TE_EXPLOSION2 = 6,
    TE_ROCKET_EXPLOSION = 7,
    TE_GRENADE_EXPLOSION = 8,
    TE_SPARKS = 9,
    TE_SPLASH = 10,
    TE_BUBBLETRAIL = 11,
    TE_SCREEN_SPARKS = 12,
    TE_SHIELD_SPARKS = 13,
    TE_BULLET_SPARKS = 14,
    TE_LASER_SPARKS = 15,
    TE_PARASITE_ATTACK = 16,
    TE_ROCKET_EXPLOSION_WATER = 17,
    TE_GRENADE_EXPLOSION_WATER = 18,
    TE_MEDIC_CABLE_ATTACK = 19,
    TE_BFG_EXPLOSION = 20,
    TE_BFG_BIGEXPLOSION = 21,
    TE_BOSSTPORT = 22,
    TE_BFG_LASER = 23,
    TE_GRAPPLE_CABLE = 24,
    TE_WELDING_SPARKS = 25,
    TE_GREENBLOOD = 26,
    TE_BLUEHYPERBLASTER = 27,
    TE_PLASMA_EXPLOSION = 28,
    TE_TUNNEL_SPARKS = 29,
    TE_BLASTER2 = 30,
    TE_RAILTRAIL2 = 31,
    TE_FLAME = 32,
    TE_LIGHTNING = 33,
    TE_DEBUGTRAIL = 34,
    TE_PLAIN_EXPLOSION = 35,
    TE_FLASHLIGHT = 36,
    TE_FORCEWALL = 37,
    TE_HEATBEAM = 38,
    TE_MONSTER_HEATBEAM = 39,
    TE_STEAM = 40,
    TE_BUBBLETRAIL2 = 41,
    TE_MOREBLOOD = 42,
    TE_HEATBEAM_SPARKS = 43,
    TE_HEATBEAM_STEAM = 44,
    TE_CHAINFIST_SMOKE = 45,
    TE_ELECTRIC_SPARKS = 46,
    TE_TRACKER_EXPLOSION = 47,
    TE_TELEPORT_EFFECT = 48,
    TE_DBALL_GOAL = 49,
    TE_WIDOWBEAMOUT = 50,
    TE_NUKEBLAST = 51,
    TE_WIDOWSPLASH = 52,
    TE_EXPLOSION1_BIG = 53,
    TE_EXPLOSION1_NP = 54,
    TE_FLECHETTE = 55,
    temp_entity_count = 56,
};

/// Which fields mean something follows from the type; the others are 0.
struct TempEntity {
    uint8_t type = 0;
    uint8_t count = 0;        ///< particles
    glm::vec3 place{0.0f};    ///< where it is, or begins
    glm::vec3 end{0.0f};      ///< where a trail or beam ends
    glm::vec3 offset{0.0f};   ///< of a cable from its entity
    uint8_t direction = 0;    ///< number of the surface's normal, 0..161
    uint8_t color = 0;        ///< palette index
    int16_t entity = 0;       ///< that a beam starts at; number of a lasting effect
    int16_t other_entity = 0; ///< that a beam ends at
    int16_t magnitude = 0;    ///< speed of steam
    int32_t duration_ms = 0;  ///< of lasting steam
    bool operator==(const TempEntity&) const = default;
};

/// Reads type and fields; an unknown type is a fault: nobody knows how long its fields are.
TempEntity read_temp_entity(MessageReader& reader);
void write_temp_entity(MessageWriter& writer, const TempEntity& effect);

} // namespace vigil::dm2
