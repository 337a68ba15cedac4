// SPDX-License-Identifier: GPL-2.0-or-later
// PNG and TGA through stb_image, with the checks it lacks: sizes before allocation, truncated TGA,
// TGA rows stored right to left. Not for use outside src/formats (see image.h).
#pragma once

#include "formats/image.h"

namespace vigil {

/// Throws Error where a picture of this size is empty or beyond the limits of image.h.
void check_image_size(std::string_view name, uint64_t width, uint64_t height);

/// Each throws Error naming the file and the fault. 16-bit channels are reduced to 8 bits.
Image decode_png(std::string_view name, std::span<const uint8_t> bytes);
Image decode_tga(std::string_view name, std::span<const uint8_t> bytes);

} // namespace vigil
