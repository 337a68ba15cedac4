// SPDX-License-Identifier: GPL-2.0-or-later
// Writes picture files for the tests: TGA of every kind Vigil reads, PCX and WAL by hand, PNG and
// JPG through stb_image_write.
#pragma once

#include "byte_writer.h"
#include "formats/image.h"

#include <string_view>

namespace vigil {

/// A picture whose every texel differs from its neighbours; alpha varies too.
Image test_picture(uint32_t width, uint32_t height);

struct TgaKind {
    uint8_t type = 2;       ///< 2: colour, 3: grey, 10: colour, run-length encoded
    uint8_t bits = 24;      ///< 8, 24 or 32
    uint8_t descriptor = 0; ///< 0x20: top row first, 0x10: rows right to left, low bits: alpha bits
};

Bytes write_tga(const Image& image, const TgaKind& kind);
Bytes write_png(const Image& image);
Bytes write_jpg(const Image& image, int quality);

/// Palette index (x + 16 y) mod 256 at (x, y); palette entry i is (i, 255 - i, i / 2).
Palette test_palette();
Bytes write_pcx(uint32_t width, uint32_t height);
Bytes write_wal(uint32_t width, uint32_t height, uint32_t flags);

} // namespace vigil
