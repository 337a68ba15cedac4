// SPDX-License-Identifier: GPL-2.0-or-later
// File names of a sky box; the geometry is in sky.h. It opens no files.
#include "formats/sky.h"

#include <fmt/format.h>

namespace vigil {

std::vector<std::string> sky_candidates(std::string_view sky, size_t side) {
    std::vector<std::string> names;
    for (const char* extension : {"png", "jpg", "tga", "pcx"})
        names.push_back(fmt::format("env/{}{}.{}", sky, sky_sides.at(side).suffix, extension));
    return names;
}

} // namespace vigil
