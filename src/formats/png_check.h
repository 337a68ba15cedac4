// SPDX-License-Identifier: GPL-2.0-or-later
// The check that a PNG file is what it claims before stb_image allocates anything for it. Not for
// use outside src/formats (see image.h).
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace vigil {

/// Unpacks the pixel data of a PNG (PNG specification, second edition) without keeping it. Throws
/// Error naming the file and the fault: chunks that leave the file, a picture that is too large,
/// data that is damaged or unpacks to less or to much more than the picture's rows.
void check_png(std::string_view name, std::span<const uint8_t> bytes);

} // namespace vigil
