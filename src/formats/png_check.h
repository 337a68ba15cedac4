// SPDX-License-Identifier: GPL-2.0-or-later
// What a PNG file goes through before stb_image sees it. Not for use outside src/formats (see
// image.h).
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace vigil {

/// The file as stb_image may see it: without IDAT chunks of no bytes, which are allowed, but which
/// stb_image copies to a null pointer. Unpacks the pixel data (PNG specification, second edition)
/// without keeping it. Throws Error naming the file and the fault: chunks that leave the file, a
/// picture that is too large, data that is damaged or unpacks to less or to much more than the
/// picture's rows.
std::vector<uint8_t> checked_png(std::string_view name, std::span<const uint8_t> bytes);

} // namespace vigil
