// SPDX-License-Identifier: GPL-2.0-or-later
#include "formats/temp_entity.h"

namespace vigil::dm2 {

namespace {

/// Fields of a type, one letter each, in their order: n count, p place, e end, o offset, d
/// direction, c colour, s entity, t other entity, m magnitude, l a long duration unless the entity
/// is -1.
std::string_view fields_of(uint8_t type) {
    switch (type) {
    case TE_GUNSHOT:
    case TE_BLOOD:
    case TE_BLASTER:
    case TE_SHOTGUN:
    case TE_SPARKS:
    case TE_SCREEN_SPARKS:
    case TE_SHIELD_SPARKS:
    case TE_BULLET_SPARKS:
    case TE_GREENBLOOD:
    case TE_BLASTER2:
    case TE_MOREBLOOD:
    case TE_HEATBEAM_SPARKS:
    case TE_HEATBEAM_STEAM:
    case TE_ELECTRIC_SPARKS:
    case TE_FLECHETTE:
        return "pd";
    case TE_SPLASH:
    case TE_LASER_SPARKS:
    case TE_WELDING_SPARKS:
    case TE_TUNNEL_SPARKS:
        return "npdc";
    case TE_RAILTRAIL:
    case TE_RAILTRAIL2:
    case TE_BUBBLETRAIL:
    case TE_BUBBLETRAIL2:
    case TE_DEBUGTRAIL:
    case TE_BFG_LASER:
    case TE_BLUEHYPERBLASTER: // its direction is sent as a place
        return "pe";
    case TE_EXPLOSION1:
    case TE_EXPLOSION2:
    case TE_ROCKET_EXPLOSION:
    case TE_GRENADE_EXPLOSION:
    case TE_ROCKET_EXPLOSION_WATER:
    case TE_GRENADE_EXPLOSION_WATER:
    case TE_BFG_EXPLOSION:
    case TE_BFG_BIGEXPLOSION:
    case TE_BOSSTPORT:
    case TE_PLASMA_EXPLOSION:
    case TE_PLAIN_EXPLOSION:
    case TE_CHAINFIST_SMOKE:
    case TE_TRACKER_EXPLOSION:
    case TE_TELEPORT_EFFECT:
    case TE_DBALL_GOAL:
    case TE_NUKEBLAST:
    case TE_WIDOWSPLASH:
    case TE_EXPLOSION1_BIG:
    case TE_EXPLOSION1_NP:
        return "p";
    case TE_PARASITE_ATTACK:
    case TE_MEDIC_CABLE_ATTACK:
    case TE_HEATBEAM:
    case TE_MONSTER_HEATBEAM:
        return "spe";
    case TE_GRAPPLE_CABLE:
        return "speo";
    case TE_LIGHTNING:
        return "stpe";
    case TE_FLASHLIGHT:
        return "ps";
    case TE_FORCEWALL:
        return "pec";
    case TE_STEAM:
        return "snpdcml";
    case TE_WIDOWBEAMOUT:
        return "sp";
    default:
        return "";
    }
}

} // namespace

TempEntity read_temp_entity(MessageReader& reader) {
    TempEntity effect;
    effect.type = reader.u8();
    const std::string_view fields = fields_of(effect.type);
    if (fields.empty()) reader.bad("the effect {} is not known", effect.type);
    for (const char field : fields) {
        switch (field) {
        case 'n':
            effect.count = reader.u8();
            break;
        case 'p':
            effect.place = reader.position();
            break;
        case 'e':
            effect.end = reader.position();
            break;
        case 'o':
            effect.offset = reader.position();
            break;
        case 'd':
            effect.direction = reader.direction();
            break;
        case 'c':
            effect.color = reader.u8();
            break;
        case 's':
            effect.entity = reader.i16();
            break;
        case 't':
            effect.other_entity = reader.i16();
            break;
        case 'm':
            effect.magnitude = reader.i16();
            break;
        default:
            if (effect.entity != -1) effect.duration_ms = reader.i32();
        }
    }
    return effect;
}

void write_temp_entity(MessageWriter& writer, const TempEntity& effect) {
    writer.u8(effect.type);
    for (const char field : fields_of(effect.type)) {
        switch (field) {
        case 'n':
            writer.u8(effect.count);
            break;
        case 'p':
            writer.position(effect.place);
            break;
        case 'e':
            writer.position(effect.end);
            break;
        case 'o':
            writer.position(effect.offset);
            break;
        case 'd':
            writer.u8(effect.direction);
            break;
        case 'c':
            writer.u8(effect.color);
            break;
        case 's':
            writer.i16(effect.entity);
            break;
        case 't':
            writer.i16(effect.other_entity);
            break;
        case 'm':
            writer.i16(effect.magnitude);
            break;
        default:
            if (effect.entity != -1) writer.i32(effect.duration_ms);
        }
    }
}

} // namespace vigil::dm2
