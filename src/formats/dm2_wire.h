// SPDX-License-Identifier: GPL-2.0-or-later
// The values of protocol 34 in a block of a demo, in both directions: MessageReader and
// MessageWriter take the same calls, so that one function with the fields of a message serves
// either. What is wrong in an untrusted demo throws Error with its name and the byte of the file
// where it is. Written values beyond what a field can hold are clamped, angles wrap.
#pragma once

#include "formats/byte_reader.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <string>
#include <vector>

namespace vigil::dm2 {

/// One of the types `Ts`, constant where it is written.
template <typename Value, typename... Ts>
concept Is = (std::same_as<std::remove_const_t<Value>, Ts> || ...);

class MessageReader {
public:
    static constexpr bool reads = true;

    /// `offset` is where `bytes` begin in the file. `name` must outlive the reader.
    MessageReader(std::string_view name, uint64_t offset, std::span<const uint8_t> bytes)
        : name_(name), offset_(offset), what_(fmt::format("{}: block at byte {}", name, offset)),
          bytes_(bytes), reader_(what_, bytes) {}
    MessageReader(const MessageReader&) = delete;
    MessageReader& operator=(const MessageReader&) = delete;

    uint8_t u8() { return reader_.u8(); }
    template <typename T> void u8(T& value) { value = static_cast<T>(reader_.u8()); }
    template <typename T> void u16(T& value) { value = reader_.u16(); }
    template <typename T> void i16(T& value) { value = reader_.i16(); }
    void u32(uint32_t& value) { value = reader_.u32(); }
    void i32(int32_t& value) { value = reader_.i32(); }
    void raw(std::vector<uint8_t>& bytes, size_t count) {
        const auto taken = reader_.take(count);
        bytes.assign(taken.begin(), taken.end());
    }

    /// Map units, in eighths.
    void coordinate(float& units) { units = static_cast<float>(reader_.i16()) * 0.125f; }
    void position(glm::vec3& place) {
        for (int i = 0; i < 3; ++i)
            coordinate(place[i]);
    }
    /// Degrees: [0, 360) in 256 steps, and [-180, 180) in 65,536.
    void angle8(float& degrees) { degrees = static_cast<float>(reader_.u8()) * (360.0f / 256.0f); }
    void angles16(glm::vec3& degrees) {
        for (int i = 0; i < 3; ++i)
            degrees[i] = static_cast<float>(reader_.i16()) * (360.0f / 65536.0f);
    }
    /// Three offsets of a quarter unit or degree each, within -32 .. 31.75.
    void quarters(glm::vec3& offset) {
        for (int i = 0; i < 3; ++i)
            offset[i] = 0.25f * static_cast<float>(reader_.read<int8_t>());
    }
    /// Text up to a NUL, which is read too.
    void text(std::string& text) {
        const auto rest = bytes_.subspan(reader_.position());
        const std::string_view chars(reinterpret_cast<const char*>(rest.data()), rest.size());
        const size_t length = chars.find('\0');
        if (length == std::string_view::npos) bad("a text has no end");
        reader_.skip(length + 1);
        text = chars.substr(0, length);
    }

    bool at_end() const { return reader_.remaining() == 0; }

    /// Refuses the demo unless `right`.
    template <typename... Args>
    void expect(bool right, fmt::format_string<Args...> text, Args&&... args) const {
        if (!right) bad(text, std::forward<Args>(args)...);
    }
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

class MessageWriter {
public:
    static constexpr bool reads = false;

    void u8(uint32_t value) { write(static_cast<uint8_t>(value)); }
    void u16(uint32_t value) { write(static_cast<uint16_t>(value)); }
    void i16(int32_t value) { write(static_cast<int16_t>(value)); }
    void u32(uint32_t value) { write(value); }
    void i32(int32_t value) { write(value); }
    /// All of `bytes`; the count is for reading.
    void raw(std::span<const uint8_t> bytes, size_t = 0) {
        bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
    }

    void coordinate(float units) {
        write(static_cast<int16_t>(std::clamp(std::round(units * 8.0f), -32768.0f, 32767.0f)));
    }
    void position(const glm::vec3& place) {
        for (int i = 0; i < 3; ++i)
            coordinate(place[i]);
    }
    void angle8(float degrees) { write(static_cast<uint8_t>(steps(degrees * (256.0f / 360.0f)))); }
    void angles16(const glm::vec3& degrees) {
        for (int i = 0; i < 3; ++i)
            write(static_cast<int16_t>(steps(degrees[i] * (65536.0f / 360.0f))));
    }
    void quarters(const glm::vec3& offset) {
        for (int i = 0; i < 3; ++i)
            write(static_cast<int8_t>(std::clamp(std::round(offset[i] * 4.0f), -128.0f, 127.0f)));
    }
    /// Up to the first NUL of `text`, and a NUL.
    void text(std::string_view text) {
        text = text.substr(0, text.find('\0'));
        bytes_.insert(bytes_.end(), text.begin(), text.end());
        bytes_.push_back(0);
    }
    template <typename... Args> void expect(bool, fmt::format_string<Args...>, Args&&...) const {}

    const std::vector<uint8_t>& bytes() const { return bytes_; }
    void clear() { bytes_.clear(); }

private:
    template <typename T> void write(T value) {
        const size_t at = bytes_.size();
        bytes_.resize(at + sizeof(T));
        std::memcpy(bytes_.data() + at, &value, sizeof(T));
    }
    static int64_t steps(float value) { return static_cast<int64_t>(std::round(value)); }

    std::vector<uint8_t> bytes_;
};

/// Whether `fields(wire, state)` writes the same of both.
template <typename State, typename Fields>
bool sent_equal(const State& a, const State& b, Fields fields) {
    MessageWriter of_a, of_b;
    fields(of_a, a);
    fields(of_b, b);
    return of_a.bytes() == of_b.bytes();
}

/// The state as it arrives, where `fields(wire, state)` writes and reads all of it that is rounded.
template <typename State, typename Fields> State as_sent(State state, Fields fields) {
    MessageWriter writer;
    fields(writer, std::as_const(state));
    MessageReader reader("", 0, writer.bytes());
    fields(reader, state);
    return state;
}

} // namespace vigil::dm2
