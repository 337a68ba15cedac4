// SPDX-License-Identifier: GPL-2.0-or-later
// A .dm2 file as a sequence of blocks: each is its length (32 bits) and so many bytes of messages;
// the length -1 ends the file. What the messages say is dm2_parser.h's business.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace vigil::dm2 {

class File {
public:
    struct Block {
        uint64_t offset = 0; ///< of its messages, in the file
        std::span<const uint8_t> bytes;
    };

    /// `name` is for messages.
    File(std::string name, std::vector<uint8_t> bytes);

    /// The next block, or nothing at the file's end. Throws Error, naming the byte, where the file
    /// is cut off or a length cannot be one.
    std::optional<Block> next();
    const std::string& name() const { return name_; }

private:
    std::string name_;
    std::vector<uint8_t> bytes_;
    size_t position_ = 0;
};

} // namespace vigil::dm2
