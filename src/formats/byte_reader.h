// SPDX-License-Identifier: GPL-2.0-or-later
// Reads little-endian numbers one after another from untrusted bytes; reading past the end throws
// Error. All of Quake II's binary files are little-endian, and so is every platform Vulkan runs on.
#pragma once

#include "common/error.h"

#include <glm/vec3.hpp>

#include <bit>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>

namespace vigil {

static_assert(std::endian::native == std::endian::little);

class ByteReader {
public:
    /// `what` names the bytes in messages ("maps/x.bsp: header"). It must outlive the reader.
    ByteReader(std::string_view what, std::span<const uint8_t> bytes)
        : what_(what), bytes_(bytes) {}

    template <typename T> T read() {
        T value;
        std::memcpy(&value, take(sizeof(T)).data(), sizeof(T));
        return value;
    }
    /// Values one after another, as they are, or stored as T.
    template <typename... Values> void get(Values&... values) { ((values = read<Values>()), ...); }
    template <typename T, typename... Values> void get_as(Values&... values) {
        ((values = read<T>()), ...);
    }
    uint8_t u8() { return read<uint8_t>(); }
    uint16_t u16() { return read<uint16_t>(); }
    int16_t i16() { return read<int16_t>(); }
    uint32_t u32() { return read<uint32_t>(); }
    int32_t i32() { return read<int32_t>(); }
    float f32() { return read<float>(); }
    glm::vec3 vec3() {
        const float x = f32(), y = f32(), z = f32();
        return {x, y, z};
    }
    glm::vec3 short_vec3() {
        const float x = i16(), y = i16(), z = i16();
        return {x, y, z};
    }

    /// A field of `size` bytes that holds text up to its first NUL.
    std::string text(size_t size) {
        const auto field = take(size);
        const std::string_view chars(reinterpret_cast<const char*>(field.data()), field.size());
        return std::string(chars.substr(0, chars.find('\0')));
    }

    std::span<const uint8_t> take(size_t size) {
        if (size > bytes_.size() - position_)
            fail("{}: ends after {} bytes, {} more are needed", what_, bytes_.size(),
                 size - (bytes_.size() - position_));
        position_ += size;
        return bytes_.subspan(position_ - size, size);
    }
    void skip(size_t size) { take(size); }
    size_t position() const { return position_; }
    size_t remaining() const { return bytes_.size() - position_; }

private:
    std::string_view what_;
    std::span<const uint8_t> bytes_;
    size_t position_ = 0;
};

} // namespace vigil
