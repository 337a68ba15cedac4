// SPDX-License-Identifier: GPL-2.0-or-later
// WAL decoder; see wal.h. Layout: name[32], width, height, offsets of 4 mip levels, next name[32],
// flags, contents, value; all little-endian.
#include "formats/wal.h"

#include "common/error.h"
#include "formats/bsp.h"
#include "formats/byte_reader.h"
#include "formats/image_decoders.h"

namespace vigil {

Wal decode_wal(std::string_view name, std::span<const uint8_t> bytes, const Palette* palette) {
    const std::string what = fmt::format("{}: WAL header", name);
    ByteReader reader(what, bytes);
    Wal wal;
    wal.name = reader.text(32);
    const uint32_t width = reader.u32(), height = reader.u32();
    const uint32_t offset = reader.u32();
    reader.skip(3 * sizeof(uint32_t)); // the smaller mip levels
    wal.next_name = reader.text(32);
    reader.get(wal.flags, wal.contents, wal.value);
    check_image_size(name, width, height);
    const size_t count = size_t{width} * height;
    if (offset > bytes.size() || count > bytes.size() - offset)
        fail("{}: WAL: {} x {} texels at byte {} do not fit into a file of {} bytes", name, width,
             height, offset, bytes.size());

    const Palette colors = palette ? *palette : fallback_palette();
    const bool cut_out = (wal.flags & SURF_ALPHATEST) != 0;
    wal.image = {width, height, {}};
    wal.image.rgba.resize(4 * count);
    for (size_t i = 0; i < count; ++i) {
        const uint8_t index = bytes[offset + i];
        for (size_t channel = 0; channel < 3; ++channel)
            wal.image.rgba[4 * i + channel] = colors[index][channel];
        wal.image.rgba[4 * i + 3] = cut_out && index == 255 ? 0 : 255;
    }
    return wal;
}

} // namespace vigil
