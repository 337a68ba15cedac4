// SPDX-License-Identifier: GPL-2.0-or-later
// Makes the bytes of a .dm2 file from messages. Frames are compressed against the one before, so
// other engines play what comes out as they play their own.
#pragma once

#include "formats/dm2_message.h"

#include <map>

namespace vigil::dm2 {

class Writer {
public:
    /// Appends a message to the block. A frame's delta_from is the frame written before, whatever
    /// it says; states are as they arrive, rounded (entity_as_sent, player_as_sent).
    void add(const Message& message);
    /// Ends the block; nothing when it is empty.
    void end_block();
    /// Bytes in the present block.
    size_t block_bytes() const { return block_.bytes().size(); }
    /// The largest block so far.
    size_t largest_block() const { return largest_block_; }

    /// The file so far with its end mark.
    std::vector<uint8_t> finish();

private:
    void add_frame(const Frame& frame);

    MessageWriter file_;
    MessageWriter block_;
    size_t largest_block_ = 0;
    std::map<uint32_t, EntityState> baselines_;
    std::optional<Frame> last_;
};

} // namespace vigil::dm2
