// SPDX-License-Identifier: GPL-2.0-or-later
// Quake's PACK archives. Entries may share bytes (some packers store equal files once); every read
// is bounded by the archive, so that costs nothing.
#include "common/binary_file.h"
#include "common/error.h"
#include "common/file_source.h"
#include "common/file_system.h"

#include <algorithm>
#include <cstring>

namespace vigil {

namespace {

constexpr std::uint64_t header_bytes = 12;
constexpr std::uint64_t entry_bytes = 64;
constexpr std::size_t name_bytes = 56;

class Pak : public ListedSource {
public:
    explicit Pak(const std::filesystem::path& file)
        : ListedSource(file.string(), true), file_(file) {
        // The header names the place and size of the directory.
        if (file_.size() < header_bytes)
            fail("{}: truncated: {} bytes are no pak header", name(), file_.size());
        const auto header = file_.read(0, header_bytes);
        if (std::memcmp(header.data(), "PACK", 4) != 0) fail("{}: is not a pak file", name());
        const std::uint64_t offset = read_u32(header, 4);
        const std::uint64_t bytes = read_u32(header, 8);
        if (bytes % entry_bytes != 0)
            fail("{}: directory of {} bytes is not made of {}-byte entries", name(), bytes,
                 entry_bytes);
        if (offset + bytes > file_.size())
            fail("{}: truncated: the directory ends at byte {} of {}", name(), offset + bytes,
                 file_.size());

        // Each entry is a name, which a NUL ends unless it fills its field, and a range of the
        // file.
        const auto directory = file_.read(offset, bytes);
        for (std::uint64_t at = 0; at < bytes; at += entry_bytes) {
            const auto entry = std::span(directory).subspan(at, entry_bytes);
            const auto end = std::find(entry.begin(), entry.begin() + name_bytes, 0);
            std::string path(entry.begin(), end);
            const std::uint64_t start = read_u32(entry, name_bytes);
            const std::uint64_t length = read_u32(entry, name_bytes + 4);
            if (start + length > file_.size())
                fail("{}: entry {} ends at byte {} of {}", name(), at / entry_bytes, start + length,
                     file_.size());
            if (add(std::move(path), length)) starts_.push_back(start);
        }
        report_skipped();
    }

private:
    std::vector<std::uint8_t> read_file(std::size_t index) const override {
        return file_.read(starts_[index], files()[index].bytes);
    }

    BinaryFile file_;
    std::vector<std::uint64_t> starts_; ///< parallel to files()
};

} // namespace

std::unique_ptr<FileSource> open_pak(const std::filesystem::path& path) {
    return std::make_unique<Pak>(path);
}

} // namespace vigil
