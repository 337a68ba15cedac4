// SPDX-License-Identifier: GPL-2.0-or-later
// PCX as Quake II uses it: 8 bits per pixel, one plane, run-length encoded, 256-colour palette at
// the end of the file (pics/colormap.pcx carries the game's palette). Other PCX kinds are refused.
#pragma once

#include "formats/image.h"

namespace vigil {

struct Pcx {
    uint32_t width = 0, height = 0;
    std::vector<uint8_t> indices; ///< width * height palette indices from the top left
    Palette palette{};
};

/// Throws Error naming the file and the fault.
Pcx decode_pcx(std::string_view name, std::span<const uint8_t> bytes);

/// The picture in colour. Index 255 is transparent (alpha 0), as in Quake II's 2D pictures and
/// skins; models ignore alpha.
Image to_image(const Pcx& pcx);

} // namespace vigil
