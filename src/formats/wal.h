// SPDX-License-Identifier: GPL-2.0-or-later
// WAL, Quake II's wall texture: a 100-byte header and four mip levels of palette indices. Only the
// largest level is decoded; the renderer filters its own mip levels.
#pragma once

#include "formats/image.h"

#include <string>

namespace vigil {

struct Wal {
    Image image;
    std::string name;      ///< name inside the file
    std::string next_name; ///< next frame of an animation, empty: none
    uint32_t flags = 0;    ///< SurfaceFlag bits that editors take as defaults
    uint32_t contents = 0; ///< ContentsFlag bits, likewise
    int32_t value = 0;     ///< light value, likewise
};

/// Decodes a WAL file through `palette`, or through fallback_palette() where it is nullptr. Walls
/// are opaque; only where the header's flags hold SURF_ALPHATEST is index 255 transparent. Throws
/// Error naming the file and the fault.
Wal decode_wal(std::string_view name, std::span<const uint8_t> bytes, const Palette* palette);

} // namespace vigil
