// SPDX-License-Identifier: GPL-2.0-or-later
// PNG by libpng, JPG by libjpeg-turbo, TGA by stb_image, with the checks that these leave to their
// callers. Not for use outside src/formats (see image.h).
#pragma once

#include "formats/image.h"

namespace vigil {

/// Throws Error where a picture of this size is empty or beyond the limits of image.h.
void check_image_size(std::string_view name, uint64_t width, uint64_t height);
/// The same, and where a file of so many bytes cannot hold it, at `most` pixels a byte.
void check_image_size(std::string_view name, uint64_t width, uint64_t height, uint64_t bytes,
                      uint64_t most);

/// Each throws Error naming the file and the fault. 16-bit channels are reduced to 8 bits. A JPG is
/// grey or colour; CMYK is refused.
Image decode_png(std::string_view name, std::span<const uint8_t> bytes);
Image decode_jpg(std::string_view name, std::span<const uint8_t> bytes);
Image decode_tga(std::string_view name, std::span<const uint8_t> bytes);

} // namespace vigil
