// SPDX-License-Identifier: GPL-2.0-or-later
// Builds small pak and zip archives in memory, right ones and wrong ones. For tests only.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace vigil::test {

using Bytes = std::vector<std::uint8_t>;

struct ArchiveFile {
    std::string path;
    std::string content;
    bool deflate = true; ///< zip only: deflated or stored
};

Bytes build_pak(const std::vector<ArchiveFile>& files);
Bytes build_zip(const std::vector<ArchiveFile>& files, const std::string& comment = {});

/// Overwrites 2 or 4 bytes, little-endian.
void poke_u16(Bytes& bytes, std::size_t offset, std::uint32_t value);
void poke_u32(Bytes& bytes, std::size_t offset, std::uint32_t value);

/// Offset of the first central directory entry, and of the end record, of a zip without a comment.
std::size_t zip_directory(const Bytes& zip);
std::size_t zip_end(const Bytes& zip);

} // namespace vigil::test
