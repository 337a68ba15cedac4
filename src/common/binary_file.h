// SPDX-License-Identifier: GPL-2.0-or-later
// A regular file opened for reading at any offset; several threads may read at once. It checks
// ranges against the file's size and names the file in errors; it does not cache or map.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace vigil {

class BinaryFile {
public:
    /// Throws Error when the file cannot be opened or is not a regular file (a folder, a pipe).
    explicit BinaryFile(const std::filesystem::path& path);
    ~BinaryFile();
    BinaryFile(const BinaryFile&) = delete;
    BinaryFile& operator=(const BinaryFile&) = delete;

    const std::string& name() const { return name_; }
    std::uint64_t size() const { return size_; }

    /// `bytes` bytes from `offset`. Throws Error when the range leaves the file or the disk fails.
    std::vector<std::uint8_t> read(std::uint64_t offset, std::uint64_t bytes) const;

private:
    std::string name_;
    int descriptor_ = -1;
    std::uint64_t size_ = 0;
};

/// Little-endian numbers in bytes that are checked to be there.
inline std::uint16_t read_u16(std::span<const std::uint8_t> bytes, std::size_t offset) {
    return static_cast<std::uint16_t>(bytes[offset] | bytes[offset + 1] << 8);
}
inline std::uint32_t read_u32(std::span<const std::uint8_t> bytes, std::size_t offset) {
    return read_u16(bytes, offset) | static_cast<std::uint32_t>(read_u16(bytes, offset + 2)) << 16;
}

} // namespace vigil
