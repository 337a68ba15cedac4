// SPDX-License-Identifier: GPL-2.0-or-later
// Layout: length of the kind (32 bits), the kind, length of the content (64 bits), its CRC-32, the
// content; numbers in the machine's byte order, as caches stay on their machine.
#include "common/sealed.h"

#include <cstdint>
#include <cstring>
#include <zlib.h>

namespace vigil {

namespace {

std::string header_of(std::string_view kind, std::uint64_t bytes, std::uint32_t checksum) {
    const auto kind_bytes = static_cast<std::uint32_t>(kind.size());
    std::string header;
    header.append(reinterpret_cast<const char*>(&kind_bytes), sizeof(kind_bytes));
    header.append(kind);
    header.append(reinterpret_cast<const char*>(&bytes), sizeof(bytes));
    header.append(reinterpret_cast<const char*>(&checksum), sizeof(checksum));
    return header;
}

std::uint32_t checksum_of(std::span<const std::byte> content) {
    return static_cast<std::uint32_t>(
        crc32_z(0, reinterpret_cast<const Bytef*>(content.data()), content.size()));
}

} // namespace

std::string seal(std::string_view kind, std::span<const std::byte> content) {
    std::string file = header_of(kind, content.size(), checksum_of(content));
    file.append(reinterpret_cast<const char*>(content.data()), content.size());
    return file;
}

std::optional<std::span<const std::byte>> unseal(std::string_view kind,
                                                 std::span<const std::byte> file) {
    const std::size_t header_bytes = header_of(kind, 0, 0).size();
    if (file.size() < header_bytes) return std::nullopt;
    const auto content = file.subspan(header_bytes);
    const std::string expected = header_of(kind, content.size(), checksum_of(content));
    if (std::memcmp(file.data(), expected.data(), header_bytes) != 0) return std::nullopt;
    return content;
}

} // namespace vigil
