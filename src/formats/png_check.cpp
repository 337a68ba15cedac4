// SPDX-License-Identifier: GPL-2.0-or-later
// Walks the chunks of a PNG and counts what zlib makes of its IDAT chunks; see png_check.h.
// Colours, filters and all other chunks are left to stb_image.
#include "formats/png_check.h"

#include "common/error.h"
#include "common/printable.h"
#include "formats/byte_reader.h"
#include "formats/image_stb.h"

#include <array>
#include <zlib.h>

namespace vigil {

namespace {

constexpr size_t signature_bytes = 8;

uint32_t big_endian(ByteReader& reader) {
    const auto bytes = reader.take(4);
    return uint32_t{bytes[0]} << 24 | uint32_t{bytes[1]} << 16 | uint32_t{bytes[2]} << 8 | bytes[3];
}

struct PngHeader {
    uint32_t width = 0, height = 0;
    uint32_t bits = 0; ///< of a pixel
    bool interlaced = false;
};

/// Channels of a colour type; 0: there is no such type.
uint32_t channels_of(uint8_t color_type) {
    switch (color_type) {
    case 0: // grey
    case 3: // palette
        return 1;
    case 2:
        return 3;
    case 4:
        return 2;
    case 6:
        return 4;
    default:
        return 0;
    }
}

PngHeader read_header(std::string_view name, ByteReader& reader) {
    PngHeader header;
    header.width = big_endian(reader);
    header.height = big_endian(reader);
    const uint8_t depth = reader.u8(), color_type = reader.u8();
    reader.skip(2); // methods of packing and filtering; there is one of each
    header.interlaced = reader.u8() != 0;
    check_image_size(name, header.width, header.height);
    if (depth == 0 || depth > 16 || channels_of(color_type) == 0)
        fail("{}: PNG with {} bits in channels of kind {}", name, depth, color_type);
    header.bits = depth * channels_of(color_type);
    return header;
}

/// Bytes of `height` rows, each behind the byte that names its filter.
uint64_t bytes_of(uint64_t width, uint64_t height, uint32_t bits) {
    return width == 0 ? 0 : height * (1 + (width * bits + 7) / 8);
}

uint64_t unpacked_bytes(const PngHeader& header) {
    if (!header.interlaced) return bytes_of(header.width, header.height, header.bits);
    // Adam7: each pass takes every dx-th column from x on, and every dy-th row from y on.
    struct Pass {
        uint32_t x, y, dx, dy;
    };
    constexpr std::array<Pass, 7> passes = {{{0, 0, 8, 8},
                                             {4, 0, 8, 8},
                                             {0, 4, 4, 8},
                                             {2, 0, 4, 4},
                                             {0, 2, 2, 4},
                                             {1, 0, 2, 2},
                                             {0, 1, 1, 2}}};
    uint64_t bytes = 0;
    for (const Pass& pass : passes)
        bytes += bytes_of((uint64_t{header.width} + pass.dx - 1 - pass.x) / pass.dx,
                          (uint64_t{header.height} + pass.dy - 1 - pass.y) / pass.dy, header.bits);
    return bytes;
}

/// Counts unpacked bytes up to a limit.
class Counter {
public:
    Counter(std::string_view name, uint64_t limit) : name_(name), limit_(limit) {
        if (inflateInit(&stream_) != Z_OK) fail("{}: out of memory for unpacking", name);
    }
    ~Counter() { inflateEnd(&stream_); }
    Counter(const Counter&) = delete;
    Counter& operator=(const Counter&) = delete;

    void add(std::span<const uint8_t> packed) {
        stream_.next_in = const_cast<Bytef*>(packed.data()); // zlib does not write there
        stream_.avail_in = static_cast<uInt>(packed.size());
        while (!ended_ && stream_.avail_in > 0) {
            stream_.next_out = nowhere_.data();
            stream_.avail_out = static_cast<uInt>(nowhere_.size());
            const int status = inflate(&stream_, Z_NO_FLUSH);
            bytes_ += nowhere_.size() - stream_.avail_out;
            if (bytes_ > limit_)
                fail("{}: the PNG unpacks to more than the {} bytes of its picture", name_, limit_);
            ended_ = status == Z_STREAM_END;
            if (!ended_ && status != Z_OK)
                fail("{}: the PNG's pixel data is damaged ({})", name_,
                     stream_.msg != nullptr ? stream_.msg : "zlib gives no reason");
        }
    }
    uint64_t bytes() const { return bytes_; }

private:
    std::string_view name_;
    uint64_t limit_;
    uint64_t bytes_ = 0;
    bool ended_ = false;
    z_stream stream_ = {};
    std::array<uint8_t, 16384> nowhere_;
};

} // namespace

std::vector<uint8_t> checked_png(std::string_view name, std::span<const uint8_t> bytes) {
    const std::string what = fmt::format("{}: PNG", name);
    ByteReader reader(what, bytes);
    reader.skip(signature_bytes);

    // The first chunk tells the size; a few bytes more than that are some writers' habit.
    const uint32_t header_bytes = big_endian(reader);
    if (reader.text(4) != "IHDR" || header_bytes != 13)
        fail("{}: the PNG does not begin with a header", name);
    const uint64_t needed = unpacked_bytes(read_header(name, reader));
    reader.skip(4); // checksum
    constexpr uint64_t slack = 4096;
    Counter counter(name, needed + slack);

    std::vector<uint8_t> kept(bytes.begin(),
                              bytes.begin() + static_cast<ptrdiff_t>(reader.position()));
    for (bool ended = false; !ended;) {
        const size_t first = reader.position();
        const uint32_t size = big_endian(reader);
        const std::string kind = reader.text(4);
        const auto content = reader.take(size);
        ended = kind == "IEND";
        if (!ended) reader.skip(4); // checksum; nobody reads the last one
        if (kind == "IDAT") counter.add(content);
        if (kind == "IDAT" && size == 0) continue;
        const auto chunk = bytes.subspan(first, reader.position() - first);
        kept.insert(kept.end(), chunk.begin(), chunk.end());
    }
    if (counter.bytes() < needed)
        fail("{}: the PNG's pixel data ends after {} of {} bytes", name, counter.bytes(), needed);
    return kept;
}

} // namespace vigil
