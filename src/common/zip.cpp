// SPDX-License-Identifier: GPL-2.0-or-later
// ZIP archives (.pkz): the central directory is checked when the archive is opened, one file's
// header, data and checksum when it is read. zlib unpacks; sizes never come from what it produces.
#include "common/binary_file.h"
#include "common/error.h"
#include "common/file_source.h"
#include "common/file_system.h"

#include <algorithm>
#include <zlib.h>

namespace vigil {

namespace {

constexpr std::uint32_t end_signature = 0x06054b50;
constexpr std::uint32_t central_signature = 0x02014b50;
constexpr std::uint32_t local_signature = 0x04034b50;
constexpr std::uint64_t end_bytes = 22;
constexpr std::uint64_t central_bytes = 46;
constexpr std::uint64_t local_bytes = 30;
constexpr std::uint64_t max_comment_bytes = 65535;

// Deflate cannot pack better than 1032 to 1 (zlib's technical notes); a larger promise is a lie.
constexpr std::uint64_t max_ratio = 1032;

enum Method : std::uint16_t { stored = 0, deflated = 8 };

struct Packed {
    std::uint64_t header; ///< offset of the local header
    std::uint64_t bytes;
    std::uint32_t crc;
    std::uint16_t method;
    bool encrypted;
};

class Inflater {
public:
    Inflater() {
        // Negative window bits: raw deflate data without zlib's own header, as ZIP stores it.
        if (inflateInit2(&stream_, -MAX_WBITS) != Z_OK) fail("out of memory for unpacking");
    }
    ~Inflater() { inflateEnd(&stream_); }
    Inflater(const Inflater&) = delete;
    Inflater& operator=(const Inflater&) = delete;

    /// Unpacks `packed` into exactly `output`; false when the data is damaged or of another size.
    bool unpack(std::span<std::uint8_t> packed, std::span<std::uint8_t> output) {
        std::uint8_t nowhere = 0; // zlib wants a place even for an empty file
        stream_.next_in = packed.data();
        stream_.avail_in = static_cast<uInt>(packed.size());
        stream_.next_out = output.empty() ? &nowhere : output.data();
        stream_.avail_out = static_cast<uInt>(output.size());
        return inflate(&stream_, Z_FINISH) == Z_STREAM_END && stream_.avail_out == 0;
    }

private:
    z_stream stream_ = {};
};

class Zip : public ListedSource {
public:
    explicit Zip(const std::filesystem::path& file)
        : ListedSource(file.string(), true), file_(file) {
        read_central_directory();
        report_skipped();
    }

private:
    std::vector<std::uint8_t> read_file(std::size_t index) const override;
    std::uint64_t find_end_record(std::vector<std::uint8_t>& record) const;
    void read_central_directory();

    BinaryFile file_;
    std::uint64_t directory_start_ = 0;
    std::vector<Packed> packed_; ///< parallel to files()
};

// The end record is the last thing in the file but for a comment, whose length it states.
std::uint64_t Zip::find_end_record(std::vector<std::uint8_t>& record) const {
    const std::uint64_t tail_bytes = std::min(file_.size(), end_bytes + max_comment_bytes);
    const auto tail = file_.read(file_.size() - tail_bytes, tail_bytes);
    for (std::uint64_t back = end_bytes; back <= tail_bytes; ++back) {
        const std::uint64_t at = tail_bytes - back;
        if (read_u32(tail, at) != end_signature) continue;
        if (read_u16(tail, at + 20) != back - end_bytes) continue;
        record.assign(tail.begin() + static_cast<std::ptrdiff_t>(at),
                      tail.begin() + static_cast<std::ptrdiff_t>(at + end_bytes));
        return file_.size() - back;
    }
    fail("{}: truncated or not a zip file: it has no end record", name());
}

void Zip::read_central_directory() {
    // The end record: one disk, no ZIP64, and a directory that lies before it.
    std::vector<std::uint8_t> end;
    const std::uint64_t end_start = find_end_record(end);
    const std::uint16_t count = read_u16(end, 10);
    const std::uint64_t bytes = read_u32(end, 12);
    directory_start_ = read_u32(end, 16);
    if (count == 0xffff || bytes == 0xffffffff || directory_start_ == 0xffffffff)
        fail("{}: zip64 archives are not supported", name());
    if (read_u16(end, 4) != 0 || read_u16(end, 6) != 0 || read_u16(end, 8) != count)
        fail("{}: zip archives of several disks are not supported", name());
    if (directory_start_ + bytes > end_start)
        fail("{}: the directory ends at byte {}, behind its end record at {}", name(),
             directory_start_ + bytes, end_start);

    // The entries: a fixed part, then name, extra fields and comment.
    const auto directory = file_.read(directory_start_, bytes);
    std::uint64_t at = 0;
    for (int i = 0; i < count; ++i) {
        if (bytes - at < central_bytes)
            fail("{}: the directory lacks entry {} of {}", name(), i, count);
        const auto entry = std::span(directory).subspan(at);
        if (read_u32(entry, 0) != central_signature)
            fail("{}: entry {} of the directory is damaged", name(), i);
        const std::uint64_t name_bytes = read_u16(entry, 28);
        const std::uint64_t entry_size =
            central_bytes + name_bytes + read_u16(entry, 30) + read_u16(entry, 32);
        if (entry_size > bytes - at) fail("{}: entry {} leaves the directory", name(), i);
        at += entry_size;

        const auto text = entry.subspan(central_bytes, name_bytes);
        std::string path(text.begin(), text.end());
        if (path.ends_with('/')) continue; // a folder
        const Packed packed = {read_u32(entry, 42), read_u32(entry, 20), read_u32(entry, 16),
                               read_u16(entry, 10), (read_u16(entry, 8) & 1) != 0};
        const std::uint64_t unpacked = read_u32(entry, 24);
        if (packed.header + local_bytes + packed.bytes > directory_start_)
            fail("{}: entry {} leaves the archive", name(), i);
        if (add(std::move(path), unpacked)) packed_.push_back(packed);
    }
}

std::vector<std::uint8_t> Zip::read_file(std::size_t index) const {
    const File& file = files()[index];
    const Packed& packed = packed_[index];
    const auto refuse = [&](std::string_view fault) {
        fail("{} in {}: {}", file.path, name(), fault);
    };
    if (packed.encrypted) refuse("is encrypted");
    if (packed.method != stored && packed.method != deflated)
        refuse("is neither stored nor deflated");
    if (file.bytes > max_file_bytes) refuse("unpacks to more than the limit of 512 MiB");
    if (packed.method == stored && packed.bytes != file.bytes)
        refuse("is stored, but its two sizes differ");
    if (file.bytes > packed.bytes * max_ratio) refuse("claims an impossible unpacked size");

    // The local header repeats name and extra fields, whose lengths may differ from the
    // directory's.
    const auto header = file_.read(packed.header, local_bytes);
    if (read_u32(header, 0) != local_signature) refuse("its local header is damaged");
    const std::uint64_t start =
        packed.header + local_bytes + read_u16(header, 26) + read_u16(header, 28);
    if (start + packed.bytes > directory_start_) refuse("its data leaves the archive");

    auto data = file_.read(start, packed.bytes);
    if (packed.method == deflated) {
        std::vector<std::uint8_t> unpacked(file.bytes);
        if (!Inflater().unpack(data, unpacked))
            refuse("is damaged, or its unpacked size is not the declared one");
        data = std::move(unpacked);
    }
    if (crc32_z(0, data.data(), data.size()) != packed.crc) refuse("its checksum is wrong");
    return data;
}

} // namespace

std::unique_ptr<FileSource> open_zip(const std::filesystem::path& path) {
    return std::make_unique<Zip>(path);
}

} // namespace vigil
