// SPDX-License-Identifier: GPL-2.0-or-later
#include "formats/dm2_file.h"

#include "common/error.h"
#include "formats/byte_reader.h"
#include "formats/dm2_protocol.h"

namespace vigil::dm2 {

File::File(std::string name, std::vector<uint8_t> bytes)
    : name_(std::move(name)), bytes_(std::move(bytes)) {}

std::optional<File::Block> File::next() {
    const size_t left = bytes_.size() - position_;
    if (left < sizeof(int32_t))
        fail("{}: byte {}: the file is cut off here: a demo ends with the length -1", name_,
             position_);
    int32_t length = 0;
    std::memcpy(&length, bytes_.data() + position_, sizeof(length));
    if (length == -1) return std::nullopt;
    if (length < 0 || static_cast<uint32_t>(length) > most_block_bytes)
        fail("{}: byte {}: a block cannot be {} bytes long, only 0 to {}", name_, position_, length,
             most_block_bytes);
    const size_t begin = position_ + sizeof(length);
    if (static_cast<size_t>(length) > bytes_.size() - begin)
        fail("{}: byte {}: the file is cut off {} bytes into a block of {}", name_, position_,
             bytes_.size() - begin, length);
    position_ = begin + static_cast<size_t>(length);
    return Block{begin, std::span(bytes_).subspan(begin, static_cast<size_t>(length))};
}

} // namespace vigil::dm2
