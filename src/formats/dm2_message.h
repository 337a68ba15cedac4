// SPDX-License-Identifier: GPL-2.0-or-later
// The messages of protocol 34 as values, whole: a frame's compression is undone. dm2_parser.h reads
// them, dm2_writer.h writes them.
#pragma once

#include "formats/entity_state.h"
#include "formats/player_state.h"
#include "formats/temp_entity.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace vigil::dm2 {

/// Begins a demo, and a level in it: everything said before is void.
struct ServerData {
    int32_t protocol = 34;
    int32_t server_count = 0; ///< of the levels that the server has loaded
    bool attract_loop = true; ///< as demos are
    std::string game_folder;  ///< empty: baseq2
    int16_t player_number = 0;
    std::string level_title;
    bool operator==(const ServerData&) const = default;
};
struct ConfigString {
    uint32_t index = 0; ///< below config_string_count
    std::string text;
    bool operator==(const ConfigString&) const = default;
};
/// What an entity's first appearance in a frame is compressed against.
struct Baseline {
    EntityState state;
    bool operator==(const Baseline&) const = default;
};
struct Print {
    uint8_t level = 0; ///< 0 items .. 3 chat
    std::string text;
    bool operator==(const Print&) const = default;
};
struct CenterPrint {
    std::string text;
    bool operator==(const CenterPrint&) const = default;
};
/// Console commands for the client.
struct StuffText {
    std::string text;
    bool operator==(const StuffText&) const = default;
};
struct Layout {
    std::string text;
    bool operator==(const Layout&) const = default;
};
struct Inventory {
    std::array<int16_t, 256> counts{};
    bool operator==(const Inventory&) const = default;
};
struct Sound {
    uint8_t sound = 0;                          ///< into the strings from CS_SOUNDS on
    std::optional<uint8_t> volume, attenuation; ///< 255 and 64 are 1
    std::optional<uint8_t> delay_ms;
    std::optional<uint16_t> entity_channel; ///< entity * 8 + channel
    std::optional<glm::vec3> place;
    bool operator==(const Sound&) const = default;
};
struct MuzzleFlash {
    uint16_t entity = 0;
    uint8_t weapon = 0; ///< of a player; place and kind of flash of a monster
    bool monster = false;
    bool silenced = false;
    bool operator==(const MuzzleFlash&) const = default;
};
struct Download {
    int16_t bytes = 0; ///< -1: the file does not exist
    uint8_t percent = 0;
    std::vector<uint8_t> data;
    bool operator==(const Download&) const = default;
};
enum class Signal : uint8_t { Nothing, Disconnect, Reconnect };

/// A tenth of a second.
struct Frame {
    int32_t number = 0;
    int32_t delta_from = -1; ///< number of the frame it was compressed against, or -1
    uint8_t suppressed = 0;  ///< frames that were not sent for want of bandwidth
    std::vector<uint8_t> area_bits;
    PlayerState player;
    std::vector<EntityState> entities; ///< by number, ascending
    bool operator==(const Frame&) const = default;
};

using Message =
    std::variant<ServerData, ConfigString, Baseline, Print, CenterPrint, StuffText, Layout,
                 Inventory, Sound, MuzzleFlash, TempEntity, Download, Signal, Frame>;

/// In a frame, or null. `entities` ascend by number.
inline const EntityState* find_entity(const std::vector<EntityState>& entities, uint32_t number) {
    const auto found = std::ranges::lower_bound(entities, number, {}, &EntityState::number);
    return found != entities.end() && found->number == number ? &*found : nullptr;
}

} // namespace vigil::dm2
