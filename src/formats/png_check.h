// SPDX-License-Identifier: GPL-2.0-or-later
// What a PNG file goes through before stb_image sees it. Not for use outside src/formats (see
// image.h).
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace vigil {

/// Unpacks the pixel data of a PNG (PNG specification, second edition) without keeping it. Throws
/// Error naming the file and the fault: chunks that leave the file, a picture that is too large,
/// data that is damaged or unpacks to less or to much more than the picture's rows.
void check_png(std::string_view name, std::span<const uint8_t> bytes);

/// The file without IDAT chunks of no bytes, which are allowed, but which stb_image copies to a
/// null pointer. `bytes` have passed check_png.
std::vector<uint8_t> without_empty_data(std::span<const uint8_t> bytes);

} // namespace vigil
