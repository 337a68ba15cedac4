// SPDX-License-Identifier: GPL-2.0-or-later
// Reads the values of protocol 34 from one block of an untrusted demo. Everything that is wrong
// throws Error with the demo's name and the byte of the file where it is.
#pragma once

#include "formats/byte_reader.h"

#include <cmath>
#include <string>

namespace vigil::dm2 {

class MessageReader {
public:
    /// `offset` is where `bytes` begin in the file. `name` must outlive the reader.
    MessageReader(std::string_view name, uint64_t offset, std::span<const uint8_t> bytes)
        : name_(name), offset_(offset), what_(fmt::format("{}: block at byte {}", name, offset)),
          bytes_(bytes), reader_(what_, bytes) {}
    MessageReader(const MessageReader&) = delete;
    MessageReader& operator=(const MessageReader&) = delete;

    uint8_t u8() { return reader_.u8(); }
    int8_t i8() { return reader_.read<int8_t>(); }
    uint16_t u16() { return reader_.u16(); }
    int16_t i16() { return reader_.i16(); }
    uint32_t u32() { return reader_.u32(); }
    int32_t i32() { return reader_.i32(); }
    std::span<const uint8_t> take(size_t size) { return reader_.take(size); }

    /// Map units, in eighths.
    float coordinate() { return static_cast<float>(i16()) * 0.125f; }
    glm::vec3 position() {
        const float x = coordinate(), y = coordinate(), z = coordinate();
        return {x, y, z};
    }
    /// Degrees: [0, 360) in 256 steps, and [-180, 180) in 65,536.
    float angle8() { return static_cast<float>(u8()) * (360.0f / 256.0f); }
    float angle16() { return static_cast<float>(i16()) * (360.0f / 65536.0f); }
    /// Three offsets of a quarter unit or degree each, within -32 .. 31.75.
    glm::vec3 quarters() {
        const float x = i8(), y = i8(), z = i8();
        return 0.25f * glm::vec3(x, y, z);
    }
    /// Number of one of the 162 directions that the game knows.
    uint8_t direction() {
        const uint8_t number = u8();
        if (number >= 162) bad("there is no direction {}, only 0 to 161", number);
        return number;
    }
    /// Text up to a NUL, which is read too.
    std::string text() {
        const auto rest = bytes_.subspan(reader_.position());
        const std::string_view chars(reinterpret_cast<const char*>(rest.data()), rest.size());
        const size_t length = chars.find('\0');
        if (length == std::string_view::npos) bad("a text has no end");
        reader_.skip(length + 1);
        return std::string(chars.substr(0, length));
    }

    bool at_end() const { return reader_.remaining() == 0; }

    template <typename... Args>
    [[noreturn]] void bad(fmt::format_string<Args...> text, Args&&... args) const {
        fail("{}: byte {}: {}", name_, offset_ + reader_.position(),
             fmt::format(text, std::forward<Args>(args)...));
    }

private:
    std::string_view name_;
    uint64_t offset_;
    std::string what_;
    std::span<const uint8_t> bytes_;
    ByteReader reader_;
};

} // namespace vigil::dm2
