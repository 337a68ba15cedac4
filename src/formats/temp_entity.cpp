// SPDX-License-Identifier: GPL-2.0-or-later
#include "formats/temp_entity.h"

namespace vigil::dm2 {

namespace {

struct Kind {
    std::string_view fields;
    std::initializer_list<uint8_t> types;
};

/// Fields of the types, one letter each, in their order: n count, p place, e end, o offset, d
/// direction, c colour, s entity, t other entity, m magnitude, l a long duration unless the entity
/// is -1. TE_BLUEHYPERBLASTER sends its direction as a place.
const Kind kinds[] = {
    {"p",
     {TE_EXPLOSION1, TE_EXPLOSION2, TE_ROCKET_EXPLOSION, TE_GRENADE_EXPLOSION,
      TE_ROCKET_EXPLOSION_WATER, TE_GRENADE_EXPLOSION_WATER, TE_BFG_EXPLOSION, TE_BFG_BIGEXPLOSION,
      TE_BOSSTPORT, TE_PLASMA_EXPLOSION, TE_PLAIN_EXPLOSION, TE_CHAINFIST_SMOKE,
      TE_TRACKER_EXPLOSION, TE_TELEPORT_EFFECT, TE_DBALL_GOAL, TE_NUKEBLAST, TE_WIDOWSPLASH,
      TE_EXPLOSION1_BIG, TE_EXPLOSION1_NP}},
    {"pd",
     {TE_GUNSHOT, TE_BLOOD, TE_BLASTER, TE_SHOTGUN, TE_SPARKS, TE_SCREEN_SPARKS, TE_SHIELD_SPARKS,
      TE_BULLET_SPARKS, TE_GREENBLOOD, TE_BLASTER2, TE_MOREBLOOD, TE_HEATBEAM_SPARKS,
      TE_HEATBEAM_STEAM, TE_ELECTRIC_SPARKS, TE_FLECHETTE}},
    {"npdc", {TE_SPLASH, TE_LASER_SPARKS, TE_WELDING_SPARKS, TE_TUNNEL_SPARKS}},
    {"pe",
     {TE_RAILTRAIL, TE_RAILTRAIL2, TE_BUBBLETRAIL, TE_BUBBLETRAIL2, TE_DEBUGTRAIL, TE_BFG_LASER,
      TE_BLUEHYPERBLASTER}},
    {"spe", {TE_PARASITE_ATTACK, TE_MEDIC_CABLE_ATTACK, TE_HEATBEAM, TE_MONSTER_HEATBEAM}},
    {"speo", {TE_GRAPPLE_CABLE}},
    {"stpe", {TE_LIGHTNING}},
    {"ps", {TE_FLASHLIGHT}},
    {"pec", {TE_FORCEWALL}},
    {"snpdcml", {TE_STEAM}},
    {"sp", {TE_WIDOWBEAMOUT}},
};

/// Empty where the type is not known.
std::string_view fields_of(uint8_t type) {
    for (const Kind& kind : kinds)
        if (std::ranges::find(kind.types, type) != kind.types.end()) return kind.fields;
    return {};
}

void fields(auto& wire, Is<TempEntity> auto& effect) {
    wire.u8(effect.type);
    const std::string_view letters = fields_of(effect.type);
    wire.expect(!letters.empty(), "the effect {} is not known", effect.type);
    for (const char letter : letters) {
        switch (letter) {
        case 'n':
            wire.u8(effect.count);
            break;
        case 'p':
            wire.position(effect.place);
            break;
        case 'e':
            wire.position(effect.end);
            break;
        case 'o':
            wire.position(effect.offset);
            break;
        case 'd': // one of the 162 directions that the game knows
            wire.u8(effect.direction);
            wire.expect(effect.direction < 162, "there is no direction {}, only 0 to 161",
                        effect.direction);
            break;
        case 'c':
            wire.u8(effect.color);
            break;
        case 's':
            wire.i16(effect.entity);
            break;
        case 't':
            wire.i16(effect.other_entity);
            break;
        case 'm':
            wire.i16(effect.magnitude);
            break;
        default:
            if (effect.entity != -1) wire.i32(effect.duration_ms);
        }
    }
}

} // namespace

TempEntity read_temp_entity(MessageReader& reader) {
    TempEntity effect;
    fields(reader, effect);
    return effect;
}

void write_temp_entity(MessageWriter& writer, const TempEntity& effect) {
    fields(writer, effect);
}

} // namespace vigil::dm2
