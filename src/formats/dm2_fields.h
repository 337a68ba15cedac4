// SPDX-License-Identifier: GPL-2.0-or-later
// The fields of protocol 34's plain messages, in their order, behind the byte that names the type.
// `wire` is a MessageReader or a MessageWriter. Not for use outside src/formats (see dm2_parser.h
// and dm2_writer.h).
#pragma once

#include "formats/dm2_message.h"
#include "formats/dm2_protocol.h"

namespace vigil::dm2 {

inline void fields(auto& wire, Is<ServerData> auto& data) {
    wire.i32(data.protocol);
    wire.expect(data.protocol == protocol_version,
                "the demo has protocol {}; only {} (Quake II 3.15 to 3.24) is understood",
                data.protocol, protocol_version);
    wire.i32(data.server_count);
    wire.u8(data.attract_loop);
    wire.text(data.game_folder);
    wire.i16(data.player_number);
    wire.text(data.level_title);
}

inline void fields(auto& wire, Is<ConfigString> auto& string) {
    wire.u16(string.index);
    wire.expect(string.index < config_string_count,
                "there is no configuration string {}, only 0 to {}", string.index,
                config_string_count - 1);
    wire.text(string.text);
}

inline void fields(auto& wire, Is<Print> auto& print) {
    wire.u8(print.level);
    wire.text(print.text);
}

inline void fields(auto& wire, Is<CenterPrint, StuffText, Layout> auto& message) {
    wire.text(message.text);
}

inline void fields(auto& wire, Is<Inventory> auto& inventory) {
    for (auto& count : inventory.counts)
        wire.i16(count);
}

inline void fields(auto& wire, Is<Sound> auto& sound) {
    enum Part : uint32_t { volume = 1, attenuation = 2, place = 4, entity = 8, delay = 16 };
    uint32_t parts = (sound.volume ? volume : 0u) | (sound.attenuation ? attenuation : 0u) |
                     (sound.place ? place : 0u) | (sound.entity_channel ? entity : 0u) |
                     (sound.delay_ms ? delay : 0u);
    wire.u8(parts);
    wire.u8(sound.sound);
    // Those that are there are read into a new value.
    const auto part = [&](Part bit, auto& value, auto send) {
        if ((parts & bit) == 0) return;
        if constexpr (std::remove_reference_t<decltype(wire)>::reads) value.emplace();
        send(*value);
    };
    const auto byte = [&](auto& value) { wire.u8(value); };
    part(volume, sound.volume, byte);
    part(attenuation, sound.attenuation, byte);
    part(delay, sound.delay_ms, byte);
    part(entity, sound.entity_channel, [&](auto& value) {
        wire.u16(value);
        wire.expect(value / 8u < most_entities, "a sound comes from entity {}", value / 8u);
    });
    part(place, sound.place, [&](auto& value) { wire.position(value); });
}

/// The message's type says whether it is a monster's.
inline void fields(auto& wire, Is<MuzzleFlash> auto& flash) {
    constexpr uint32_t silenced = 0x80;
    wire.u16(flash.entity);
    wire.expect(flash.entity != 0 && flash.entity < most_entities, "a weapon of entity {} flashes",
                flash.entity);
    uint32_t kind = flash.weapon | (flash.silenced ? silenced : 0u);
    wire.u8(kind);
    if constexpr (std::remove_reference_t<decltype(wire)>::reads) {
        flash.silenced = !flash.monster && (kind & silenced) != 0;
        flash.weapon = static_cast<uint8_t>(flash.monster ? kind : kind & ~silenced);
    }
}

inline void fields(auto& wire, Is<Download> auto& download) {
    wire.i16(download.bytes);
    wire.u8(download.percent);
    wire.raw(download.data, static_cast<size_t>(std::max<int16_t>(download.bytes, 0)));
}

} // namespace vigil::dm2
