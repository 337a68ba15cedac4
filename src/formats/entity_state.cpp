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
void sized(auto& wire, uint32_t bits, uint32_t bit8, uint32_t bit16, auto& value) {
    const bool small = (bits & bit8) != 0, large = (bits & bit16) != 0;
    if (small && large)
        wire.u32(value);
    else if (large)
        wire.u16(value);
    else if (small)
        wire.u8(value);
}

uint32_t size_bits(uint32_t from, uint32_t to, uint32_t bit8, uint32_t bit16) {
    if (from == to) return 0;
    if (to < 0x100) return bit8;
    // Engines read 16 bits as a signed number.
    return to < 0x8000 ? bit16 : bit8 | bit16;
}

/// The parts of an entity that `bits` names.
void parts(auto& wire, uint32_t bits, Is<EntityState> auto& entity) {
    const auto has = [bits](uint32_t bit) { return (bits & bit) != 0; };
    for (size_t i = 0; i < model_bits.size(); ++i) {
        if (has(model_bits[i])) wire.u8(entity.models[i]);
    }
    if (has(U_FRAME8)) wire.u8(entity.frame);
    if (has(U_FRAME16)) wire.u16(entity.frame);
    sized(wire, bits, U_SKIN8, U_SKIN16, entity.skin);
    sized(wire, bits, U_EFFECTS8, U_EFFECTS16, entity.effects);
    sized(wire, bits, U_RENDERFX8, U_RENDERFX16, entity.render_flags);
    for (size_t i = 0; i < 3; ++i) {
        if (has(origin_bits[i])) wire.coordinate(entity.origin[i]);
    }
    for (size_t i = 0; i < 3; ++i) {
        if (has(angle_bits[i])) wire.angle8(entity.angles[i]);
    }
    if (has(U_OLDORIGIN)) wire.position(entity.old_origin);
    if (has(U_SOUND)) wire.u8(entity.sound);
    if (has(U_EVENT)) wire.u8(entity.event);
    if (has(U_SOLID)) wire.u16(entity.solid);
}

/// What is rounded, and with it all that is sent in one size.
constexpr uint32_t place_bits =
    U_ORIGIN1 | U_ORIGIN2 | U_ORIGIN3 | U_ANGLE1 | U_ANGLE2 | U_ANGLE3 | U_OLDORIGIN;
constexpr uint32_t plain_bits =
    place_bits | U_MODEL | U_MODEL2 | U_MODEL3 | U_MODEL4 | U_SOUND | U_EVENT | U_SOLID;

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
        writer.u16(number);
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
    if ((header.bits & U_NUMBER16) != 0)
        reader.u16(header.number);
    else
        reader.u8(header.number);
    reader.expect(header.number < most_entities, "there is no entity {}, only 1 to {}",
                  header.number, most_entities - 1);
    return header;
}

EntityState read_entity(MessageReader& reader, const EntityHeader& header,
                        const EntityState& from) {
    EntityState to = unchanged_entity(from);
    to.number = header.number;
    parts(reader, header.bits, to);
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
    // Readers take the place before from the state before.
    const EntityState before = unchanged_entity(from);
    uint32_t bits = 0;
    for (uint32_t bit = 1; bit != 0; bit <<= 1) {
        if ((bit & plain_bits) != 0 &&
            !sent_equal(before, to, [bit](auto& wire, auto& state) { parts(wire, bit, state); }))
            bits |= bit;
    }
    if (to.frame != from.frame) bits |= to.frame < 0x100 ? U_FRAME8 : U_FRAME16;
    bits |= size_bits(from.skin, to.skin, U_SKIN8, U_SKIN16);
    bits |= size_bits(from.effects, to.effects, U_EFFECTS8, U_EFFECTS16);
    bits |= size_bits(from.render_flags, to.render_flags, U_RENDERFX8, U_RENDERFX16);
    if (bits == 0 && !always) return;
    write_header(writer, bits, to.number);
    parts(writer, bits, to);
}

void write_entity_removal(MessageWriter& writer, uint32_t number) {
    write_header(writer, U_REMOVE, number);
}

EntityState entity_as_sent(const EntityState& state) {
    return as_sent(state, [](auto& wire, auto& entity) { parts(wire, place_bits, entity); });
}

} // namespace vigil::dm2
