// SPDX-License-Identifier: GPL-2.0-or-later
// Writes the values of protocol 34 into a block of a demo; the counterpart of MessageReader. Values
// beyond what a field can hold are clamped, angles wrap.
#pragma once

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

namespace vigil::dm2 {

/// What is written for a coordinate in map units, an angle in degrees, an offset in quarters.
inline int16_t packed_coordinate(float units) {
    return static_cast<int16_t>(std::clamp(std::round(units * 8.0f), -32768.0f, 32767.0f));
}
inline uint8_t packed_angle8(float degrees) {
    return static_cast<uint8_t>(static_cast<int64_t>(std::round(degrees * (256.0f / 360.0f))));
}
inline int16_t packed_angle16(float degrees) {
    return static_cast<int16_t>(static_cast<int64_t>(std::round(degrees * (65536.0f / 360.0f))));
}
inline int8_t packed_quarter(float units) {
    return static_cast<int8_t>(std::clamp(std::round(units * 4.0f), -128.0f, 127.0f));
}

class MessageWriter {
public:
    template <typename T> void write(T value) {
        const size_t at = bytes_.size();
        bytes_.resize(at + sizeof(T));
        std::memcpy(bytes_.data() + at, &value, sizeof(T));
    }
    void u8(uint32_t value) { write(static_cast<uint8_t>(value)); }
    void i16(int32_t value) { write(static_cast<int16_t>(value)); }
    void u32(uint32_t value) { write(value); }
    void i32(int32_t value) { write(value); }
    void raw(std::span<const uint8_t> bytes) {
        bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
    }

    void coordinate(float units) { write(packed_coordinate(units)); }
    void position(const glm::vec3& place) {
        for (int i = 0; i < 3; ++i)
            coordinate(place[i]);
    }
    void angle8(float degrees) { write(packed_angle8(degrees)); }
    void angle16(float degrees) { write(packed_angle16(degrees)); }
    void quarters(const glm::vec3& offset) {
        for (int i = 0; i < 3; ++i)
            write(packed_quarter(offset[i]));
    }
    /// Up to the first NUL of `text`, and a NUL.
    void text(std::string_view text) {
        text = text.substr(0, text.find('\0'));
        bytes_.insert(bytes_.end(), text.begin(), text.end());
        bytes_.push_back(0);
    }

    const std::vector<uint8_t>& bytes() const { return bytes_; }
    void clear() { bytes_.clear(); }

private:
    std::vector<uint8_t> bytes_;
};

} // namespace vigil::dm2
