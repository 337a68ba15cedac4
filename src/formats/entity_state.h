// SPDX-License-Identifier: GPL-2.0-or-later
// An entity as the server describes it in a frame, and its delta compression: only what differs
// from an earlier state is sent, with bits that say what.
#pragma once

#include "formats/dm2_wire.h"

#include <array>

namespace vigil::dm2 {

struct EntityState {
    uint32_t number = 0; ///< 1 .. most_entities - 1; players first
    glm::vec3 origin{0.0f};
    glm::vec3 angles{0.0f};     ///< degrees: pitch, yaw, roll in steps of 360/256
    glm::vec3 old_origin{0.0f}; ///< where it was a frame ago; the other end of a beam
    /// Into the configuration strings from CS_MODELS on; 0: none, 255: a player's model.
    std::array<uint8_t, 4> models{};
    uint16_t frame = 0;
    uint32_t skin = 0; ///< number; four palette indices of a beam
    uint32_t effects = 0;
    uint32_t render_flags = 0;
    uint16_t solid = 0;
    uint8_t sound = 0;
    uint8_t event = 0; ///< of this frame only
    bool operator==(const EntityState&) const = default;
};

/// What precedes an entity: which one, and what of it follows.
struct EntityHeader {
    uint32_t bits = 0;
    uint32_t number = 0; ///< 0: the list ends
    bool removed() const;
};
EntityHeader read_entity_header(MessageReader& reader);

/// The state that `header` and what follows it make of `from`. Its event and the place a frame ago
/// do not come from there.
EntityState read_entity(MessageReader& reader, const EntityHeader& header, const EntityState& from);

/// A state that nothing is said about in a frame: as before, but standing still without an event.
EntityState unchanged_entity(const EntityState& from);

/// Writes what turns `from` into `to`. Nothing at all where nothing differs as it arrives, unless
/// `always`. Numbers must be in range.
void write_entity(MessageWriter& writer, const EntityState& from, const EntityState& to,
                  bool always);
/// Writes that entity `number` is gone.
void write_entity_removal(MessageWriter& writer, uint32_t number);

/// The state as it arrives: places and angles rounded.
EntityState entity_as_sent(const EntityState& state);

} // namespace vigil::dm2
