// SPDX-License-Identifier: GPL-2.0-or-later
#include "formats/entity_state.h"

#include "formats/dm2_protocol.h"

namespace vigil::dm2 {

namespace {

enum EntityBit : uint32_t {
    U_ORIGIN1 = 1u << 0,
    U_ORIGIN2 = 1u << 1,
    U_ANGLE2 = 1u << 2,
    U_ANGLE3 = 1u << 3,
    U_FRAME8 = 1u << 4,
    U_EVENT = 1u << 5,
    U_REMOVE = 1u << 6,
    U_MOREBITS1 = 1u << 7,
    U_NUMBER16 = 1u << 8,
    U_ORIGIN3 = 1u << 9,
    U_ANGLE1 = 1u << 10,
    U_MODEL = 1u << 11,
    U_RENDERFX8 = 1u << 12,
    U_EFFECTS8 = 1u << 14,
    U_MOREBITS2 = 1u << 15,
    U_SKIN8 = 1u << 16,
    U_FRAME16 = 1u << 17,
    U_RENDERFX16 = 1u << 18,
    U_EFFECTS16 = 1u << 19,
    U_MODEL2 = 1u << 20,
    U_MODEL3 = 1u << 21,
    U_MODEL4 = 1u << 22,
    U_MOREBITS3 = 1u << 23,
    U_OLDORIGIN = 1u << 24,
    U_SKIN16 = 1u << 25,
    U_SOUND = 1u << 26,
    U_SOLID = 1u << 27,
};

constexpr std::array<uint32_t, 4> model_bits{U_MODEL, U_MODEL2, U_MODEL3, U_MODEL4};
constexpr std::array<uint32_t, 3> origin_bits{U_ORIGIN1, U_ORIGIN2, U_ORIGIN3};
constexpr std::array<uint32_t, 3> angle_bits{U_ANGLE1, U_ANGLE2, U_ANGLE3};

/// A number in 8, 16 or, with both bits, 32 bits.
uint32_t read_sized(MessageReader& reader, uint32_t bits, uint32_t bit8, uint32_t bit16,
                    uint32_t from) {
    const bool small = (bits & bit8) != 0, large = (bits & bit16) != 0;
    if (small && large) return reader.u32();
    if (large) return reader.u16();
    return small ? reader.u8() : from;
}

uint32_t size_bits(uint32_t from, uint32_t to, uint32_t bit8, uint32_t bit16) {
    if (from == to) return 0;
    if (to < 0x100) return bit8;
    // Engines read 16 bits as a signed number.
    return to < 0x8000 ? bit16 : bit8 | bit16;
}

void write_sized(MessageWriter& writer, uint32_t bits, uint32_t bit8, uint32_t bit16,
                 uint32_t value) {
    const bool small = (bits & bit8) != 0, large = (bits & bit16) != 0;
    if (small && large)
        writer.u32(value);
    else if (large)
        writer.i16(static_cast<int32_t>(value));
    else if (small)
        writer.u8(value);
}

void write_header(MessageWriter& writer, uint32_t bits, uint32_t number) {
    if (number > 0xff) bits |= U_NUMBER16;
    if ((bits & 0xff000000u) != 0)
        bits |= U_MOREBITS3 | U_MOREBITS2 | U_MOREBITS1;
    else if ((bits & 0x00ff0000u) != 0)
        bits |= U_MOREBITS2 | U_MOREBITS1;
    else if ((bits & 0x0000ff00u) != 0)
        bits |= U_MOREBITS1;
    writer.u8(bits);
    if ((bits & U_MOREBITS1) != 0) writer.u8(bits >> 8);
    if ((bits & U_MOREBITS2) != 0) writer.u8(bits >> 16);
    if ((bits & U_MOREBITS3) != 0) writer.u8(bits >> 24);
    if ((bits & U_NUMBER16) != 0)
        writer.i16(static_cast<int32_t>(number));
    else
        writer.u8(number);
}

} // namespace

bool EntityHeader::removed() const {
    return (bits & U_REMOVE) != 0;
}

EntityHeader read_entity_header(MessageReader& reader) {
    EntityHeader header;
    header.bits = reader.u8();
    if ((header.bits & U_MOREBITS1) != 0) header.bits |= uint32_t{reader.u8()} << 8;
    if ((header.bits & U_MOREBITS2) != 0) header.bits |= uint32_t{reader.u8()} << 16;
    if ((header.bits & U_MOREBITS3) != 0) header.bits |= uint32_t{reader.u8()} << 24;
    header.number = (header.bits & U_NUMBER16) != 0 ? reader.u16() : reader.u8();
    if (header.number >= most_entities)
        reader.bad("there is no entity {}, only 1 to {}", header.number, most_entities - 1);
    return header;
}

EntityState read_entity(MessageReader& reader, const EntityHeader& header,
                        const EntityState& from) {
    const uint32_t bits = header.bits;
    EntityState to = unchanged_entity(from);
    to.number = header.number;
    for (size_t i = 0; i < to.models.size(); ++i) {
        if ((bits & model_bits[i]) != 0) to.models[i] = reader.u8();
    }
    if ((bits & U_FRAME8) != 0) to.frame = reader.u8();
    if ((bits & U_FRAME16) != 0) to.frame = reader.u16();
    to.skin = read_sized(reader, bits, U_SKIN8, U_SKIN16, from.skin);
    to.effects = read_sized(reader, bits, U_EFFECTS8, U_EFFECTS16, from.effects);
    to.render_flags = read_sized(reader, bits, U_RENDERFX8, U_RENDERFX16, from.render_flags);
    for (size_t i = 0; i < 3; ++i) {
        if ((bits & origin_bits[i]) != 0) to.origin[i] = reader.coordinate();
    }
    for (size_t i = 0; i < 3; ++i) {
        if ((bits & angle_bits[i]) != 0) to.angles[i] = reader.angle8();
    }
    if ((bits & U_OLDORIGIN) != 0) to.old_origin = reader.position();
    if ((bits & U_SOUND) != 0) to.sound = reader.u8();
    if ((bits & U_EVENT) != 0) to.event = reader.u8();
    if ((bits & U_SOLID) != 0) to.solid = reader.u16();
    return to;
}

EntityState unchanged_entity(const EntityState& from) {
    EntityState to = from;
    to.old_origin = from.origin;
    to.event = 0;
    return to;
}

void write_entity(MessageWriter& writer, const EntityState& from, const EntityState& to,
                  bool always) {
    uint32_t bits = 0;
    for (size_t i = 0; i < to.models.size(); ++i) {
        if (to.models[i] != from.models[i]) bits |= model_bits[i];
    }
    if (to.frame != from.frame) bits |= to.frame < 0x100 ? U_FRAME8 : U_FRAME16;
    bits |= size_bits(from.skin, to.skin, U_SKIN8, U_SKIN16);
    bits |= size_bits(from.effects, to.effects, U_EFFECTS8, U_EFFECTS16);
    bits |= size_bits(from.render_flags, to.render_flags, U_RENDERFX8, U_RENDERFX16);
    for (size_t i = 0; i < 3; ++i) {
        if (packed_coordinate(to.origin[i]) != packed_coordinate(from.origin[i]))
            bits |= origin_bits[i];
        if (packed_angle8(to.angles[i]) != packed_angle8(from.angles[i])) bits |= angle_bits[i];
    }
    // Readers take the place before from the state before.
    if (entity_as_sent(to).old_origin != entity_as_sent(from).origin) bits |= U_OLDORIGIN;
    if (to.sound != from.sound) bits |= U_SOUND;
    if (to.event != 0) bits |= U_EVENT;
    if (to.solid != from.solid) bits |= U_SOLID;
    if (bits == 0 && !always) return;

    write_header(writer, bits, to.number);
    for (size_t i = 0; i < to.models.size(); ++i) {
        if ((bits & model_bits[i]) != 0) writer.u8(to.models[i]);
    }
    if ((bits & U_FRAME8) != 0) writer.u8(to.frame);
    if ((bits & U_FRAME16) != 0) writer.i16(to.frame);
    write_sized(writer, bits, U_SKIN8, U_SKIN16, to.skin);
    write_sized(writer, bits, U_EFFECTS8, U_EFFECTS16, to.effects);
    write_sized(writer, bits, U_RENDERFX8, U_RENDERFX16, to.render_flags);
    for (size_t i = 0; i < 3; ++i) {
        if ((bits & origin_bits[i]) != 0) writer.coordinate(to.origin[i]);
    }
    for (size_t i = 0; i < 3; ++i) {
        if ((bits & angle_bits[i]) != 0) writer.angle8(to.angles[i]);
    }
    if ((bits & U_OLDORIGIN) != 0) writer.position(to.old_origin);
    if ((bits & U_SOUND) != 0) writer.u8(to.sound);
    if ((bits & U_EVENT) != 0) writer.u8(to.event);
    if ((bits & U_SOLID) != 0) writer.i16(to.solid);
}

void write_entity_removal(MessageWriter& writer, uint32_t number) {
    write_header(writer, U_REMOVE, number);
}

EntityState entity_as_sent(EntityState state) {
    for (int i = 0; i < 3; ++i) {
        state.origin[i] = static_cast<float>(packed_coordinate(state.origin[i])) * 0.125f;
        state.old_origin[i] = static_cast<float>(packed_coordinate(state.old_origin[i])) * 0.125f;
        state.angles[i] = static_cast<float>(packed_angle8(state.angles[i])) * (360.0f / 256.0f);
    }
    return state;
}

} // namespace vigil::dm2
