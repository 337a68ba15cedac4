// SPDX-License-Identifier: GPL-2.0-or-later
// A loaded level: the checked BSP file and its decompressed visibility. It is read once and never
// changes; what moves in it belongs to the client and the renderer.
#pragma once

#include "formats/bsp.h"
#include "level/pvs.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace vigil {

class FileSystem;

struct Level {
    std::string name; ///< without folder and extension: "warehouse"
    Bsp bsp;
    Pvs pvs;
};

/// Reads maps/NAME.bsp. `name` may be given as "NAME", "NAME.bsp" or "maps/NAME.bsp".
/// Throws Error naming the file and the fault.
std::shared_ptr<const Level> load_level(const FileSystem& files, std::string_view name);

/// Names of all levels that load_level could read, sorted.
std::vector<std::string> list_levels(const FileSystem& files);

} // namespace vigil
