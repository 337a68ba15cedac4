// SPDX-License-Identifier: GPL-2.0-or-later
// Builds little-endian files in memory for the format tests, so that every byte of a test's input
// is stated in the test. It checks nothing: tests write faulty files on purpose.
#pragma once

#include <glm/vec3.hpp>

#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <string_view>
#include <vector>

namespace vigil {

using Bytes = std::vector<uint8_t>;

template <typename T> void append(Bytes& out, T value) {
    const size_t at = out.size();
    out.resize(at + sizeof(T));
    std::memcpy(out.data() + at, &value, sizeof(T));
}
template <typename T> void append_list(Bytes& out, std::initializer_list<T> values) {
    for (const T value : values)
        append(out, value);
}
inline void append_vec3(Bytes& out, const glm::vec3& value) {
    append(out, value.x);
    append(out, value.y);
    append(out, value.z);
}
/// Text padded with NULs (or cut) to `size` bytes.
inline void append_text(Bytes& out, std::string_view text, size_t size) {
    for (size_t i = 0; i < size; ++i)
        append<uint8_t>(out, i < text.size() ? static_cast<uint8_t>(text[i]) : uint8_t{0});
}
inline void append_bytes(Bytes& out, const Bytes& bytes) {
    out.insert(out.end(), bytes.begin(), bytes.end());
}
template <typename T> void patch(Bytes& out, size_t at, T value) {
    std::memcpy(out.data() + at, &value, sizeof(T));
}

} // namespace vigil
