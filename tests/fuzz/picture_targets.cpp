// SPDX-License-Identifier: GPL-2.0-or-later
// Pictures, each through the function that every texture comes through.
#include "formats/image.h"
#include "target.h"

#include <vector>
#include <zlib.h>

namespace vigil::fuzz {

namespace {

void decode(std::string_view name, Input bytes) {
    parse_or_refuse(name, [&] {
        const Image image = decode_image(name, bytes);
        require(image.width > 0 && image.height > 0, "the picture is empty");
        require(image.rgba.size() == std::size_t{4} * image.width * image.height,
                "the picture has not its size");
    });
}

using Bytes = std::vector<std::uint8_t>;

void put_big_endian(std::span<std::uint8_t> four, std::uint64_t value) {
    for (std::size_t i = 0; i < 4; ++i)
        four[i] = static_cast<std::uint8_t>(value >> (24 - 8 * i));
}

/// The checksum is left 0: right_checksums() follows.
void append_chunk(Bytes& file, std::string_view kind, const Bytes& content) {
    file.resize(file.size() + 4);
    put_big_endian(std::span(file).last(4), content.size());
    file.insert(file.end(), kind.begin(), kind.end());
    file.insert(file.end(), content.begin(), content.end());
    file.insert(file.end(), 4, 0);
}

/// A PNG whose chunks all have the right checksum: libpng would not look beyond a wrong one.
void right_checksums(Bytes& file) {
    constexpr std::size_t signature = 8, around = 12; // bytes of a chunk besides its content
    for (std::size_t at = signature; at + around <= file.size();) {
        std::size_t size = 0;
        for (std::size_t i = 0; i < 4; ++i)
            size = size << 8 | file[at + i];
        if (size > file.size() - at - around) return;
        put_big_endian(std::span(file).subspan(at + 8 + size, 4),
                       crc32_z(0, file.data() + at + 4, 4 + size));
        at += around + size;
    }
}

} // namespace

void fuzz_wal(Input bytes) {
    decode("x.wal", bytes);
}
void fuzz_pcx(Input bytes) {
    decode("x.pcx", bytes);
}
void fuzz_tga(Input bytes) {
    decode("x.tga", bytes);
}
void fuzz_png(Input bytes) {
    Bytes file(bytes.begin(), bytes.end());
    right_checksums(file);
    decode("x.png", file);
}
/// Width, height, colour type, depth and interlacing, one byte each, then the rows.
void fuzz_png_rows(Input bytes) {
    constexpr std::size_t header_bytes = 5;
    if (bytes.size() < header_bytes) return;
    const Input rows = bytes.subspan(header_bytes);
    Bytes packed(compressBound(rows.size()));
    uLongf packed_bytes = packed.size();
    require(compress2(packed.data(), &packed_bytes, rows.data(), rows.size(), 1) == Z_OK,
            "zlib packs nothing");
    packed.resize(packed_bytes);
    const Bytes header = {0,        0,        0, static_cast<std::uint8_t>(bytes[0] + 1),
                          0,        0,        0, static_cast<std::uint8_t>(bytes[1] + 1),
                          bytes[3], bytes[2], 0, 0,
                          bytes[4]};
    Bytes file = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    append_chunk(file, "IHDR", header);
    append_chunk(file, "PLTE", Bytes(768, 0x55));
    append_chunk(file, "IDAT", packed);
    append_chunk(file, "IEND", {});
    right_checksums(file);
    decode("x.png", file);
}
void fuzz_jpg(Input bytes) {
    decode("x.jpg", bytes);
}

} // namespace vigil::fuzz
