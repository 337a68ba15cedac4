// SPDX-License-Identifier: GPL-2.0-or-later
// JPG through libjpeg-turbo, with the checks that are left to its caller: sizes before allocation,
// truncated files, and the number of scans. Not for use outside src/formats (see image.h).
#pragma once

#include "formats/image.h"

namespace vigil {

/// Throws Error naming the file and the fault. Grey and colour pictures; CMYK ones are refused.
Image decode_jpg(std::string_view name, std::span<const uint8_t> bytes);

} // namespace vigil
