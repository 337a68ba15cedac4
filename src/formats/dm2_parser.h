// SPDX-License-Identifier: GPL-2.0-or-later
// Turns blocks of a demo into messages. It remembers what later messages refer to: baselines and
// the frames that others are compressed against. Every value is checked here: numbers of entities
// and strings are in range, lists are sorted, nothing of a block is left over.
#pragma once

#include "formats/dm2_file.h"
#include "formats/dm2_message.h"

#include <map>

namespace vigil::dm2 {

class Parser {
public:
    /// `name` is the demo's, for messages.
    explicit Parser(std::string name) : name_(std::move(name)) {}

    /// The messages of a block in their order. Throws Error naming demo, byte and fault; what was
    /// parsed before it in the block is in `messages` then, and the demo is at its end.
    void parse(const File::Block& block, std::vector<Message>& messages);

private:
    /// Frames that the protocol lets others refer to.
    static constexpr size_t kept_frames = 16;

    Message read_message(MessageReader& reader);
    Frame read_frame(MessageReader& reader);
    std::vector<EntityState> read_entities(MessageReader& reader,
                                           const std::vector<EntityState>& before);

    std::string name_;
    bool started_ = false; // server data was there
    std::map<uint32_t, EntityState> baselines_;
    std::array<std::optional<Frame>, kept_frames> frames_;
};

} // namespace vigil::dm2
