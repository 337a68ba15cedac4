// SPDX-License-Identifier: GPL-2.0-or-later
// A decoded picture and the one function that decodes any texture file Vigil reads: PNG, JPG and
// TGA through libraries, WAL and PCX (wal.h, pcx.h). It writes no files and builds no mip levels.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace vigil {

/// 8-bit RGBA, colour sRGB-encoded, alpha linear and not premultiplied, row by row from the top
/// left.
struct Image {
    uint32_t width = 0, height = 0;
    std::vector<uint8_t> rgba; ///< 4 * width * height bytes
};

/// 256 colours, sRGB.
using Palette = std::array<std::array<uint8_t, 3>, 256>;

/// Pictures wider or higher than this, or with more pixels, are refused before anything is
/// allocated.
inline constexpr uint32_t image_max_size = 16384;
inline constexpr uint64_t image_max_pixels = uint64_t{1} << 26;

/// Decodes any supported picture. The content decides where it has a signature (PNG, JPG, PCX),
/// else the extension of `name` (.wal, .tga, ...). `palette` colours WAL files; without one they
/// are shown through fallback_palette(). Throws Error naming the file and the fault.
Image decode_image(std::string_view name, std::span<const uint8_t> bytes,
                   const Palette* palette = nullptr);

/// Where no pics/colormap.pcx is at hand: 16 identical ramps of 16 greys, dark to light. Quake II's
/// own palette is arranged in ramps of 16 as well, so shading survives while hue is lost.
Palette fallback_palette();

/// What a missing texture looks like: 64 x 64, dark grey and magenta squares of 8 texels.
Image checker_image();

/// sRGB byte to linear 0..1 (IEC 61966-2-1).
float srgb_to_linear(uint8_t value);
/// The reverse, rounded; what is not in 0..1 is brought into it, NaN to 0.
uint8_t linear_to_srgb(float linear);

} // namespace vigil
