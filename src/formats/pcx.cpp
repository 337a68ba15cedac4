// SPDX-License-Identifier: GPL-2.0-or-later
// PCX decoder; see pcx.h. Layout: a 128-byte header, run-length encoded rows, and 769 bytes at the
// end (the marker 12 and 256 RGB triples). Runs may cross rows; Quake II's own files do.
#include "formats/pcx.h"

#include "common/error.h"
#include "formats/byte_reader.h"
#include "formats/image_decoders.h"

#include <algorithm>

namespace vigil {

namespace {

constexpr size_t header_size = 128;
constexpr size_t palette_size = 768;

} // namespace

Pcx decode_pcx(std::string_view name, std::span<const uint8_t> bytes) {
    const std::string what = fmt::format("{}: PCX header", name);
    ByteReader header(what, bytes);
    const uint8_t manufacturer = header.u8(), version = header.u8();
    const uint8_t encoding = header.u8(), bits = header.u8();
    const uint32_t x0 = header.u16(), y0 = header.u16(), x1 = header.u16(), y1 = header.u16();
    header.skip(53); // resolution, 16-colour palette, reserved byte
    const uint8_t planes = header.u8();
    const size_t bytes_per_line = header.u16();
    if (manufacturer != 0x0a || version != 5 || encoding != 1 || bits != 8 || planes != 1)
        fail("{}: not a PCX with 8 bits per pixel in one plane", name);
    if (x1 < x0 || y1 < y0) fail("{}: the PCX picture is empty", name);
    Pcx pcx;
    pcx.width = x1 - x0 + 1;
    pcx.height = y1 - y0 + 1;
    check_image_size(name, pcx.width, pcx.height);
    if (bytes_per_line < pcx.width)
        fail("{}: PCX rows of {} bytes hold no {} pixels", name, bytes_per_line, pcx.width);
    if (bytes.size() < header_size + 1 + palette_size ||
        bytes[bytes.size() - palette_size - 1] != 12)
        fail("{}: the PCX has no palette at its end", name);

    const auto colors = bytes.last(palette_size);
    for (size_t i = 0; i < palette_size; ++i)
        pcx.palette[i / 3][i % 3] = colors[i];

    // Two top bits set: the low six are a count for the next byte. Padding at row ends is dropped.
    const std::string rows = fmt::format("{}: PCX pixels", name);
    ByteReader reader(rows, bytes.subspan(header_size, bytes.size() - header_size - 769));
    pcx.indices.resize(size_t{pcx.width} * pcx.height);
    uint32_t run = 0;
    uint8_t value = 0;
    for (size_t y = 0; y < pcx.height; ++y)
        for (size_t x = 0; x < bytes_per_line; ++x) {
            while (run == 0) {
                value = reader.u8();
                run = 1;
                if ((value & 0xc0) == 0xc0) {
                    run = value & 0x3f;
                    value = reader.u8();
                }
            }
            --run;
            if (x < pcx.width) pcx.indices[y * pcx.width + x] = value;
        }
    return pcx;
}

Image to_image(const Pcx& pcx) {
    Image image{pcx.width, pcx.height, {}};
    image.rgba.reserve(4 * pcx.indices.size());
    for (const uint8_t index : pcx.indices) {
        const auto& color = pcx.palette[index];
        image.rgba.insert(image.rgba.end(), color.begin(), color.end());
        image.rgba.push_back(index == 255 ? 0 : 255);
    }
    return image;
}

} // namespace vigil
