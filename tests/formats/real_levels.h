// SPDX-License-Identifier: GPL-2.0-or-later
// Finds the six real levels that other people built; they are not part of the project. Tests that
// use them skip themselves where they are missing.
#pragma once

#include "byte_writer.h"

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>

namespace vigil {

/// Folder of the real levels: $VIGIL_SHARED/levels, or ../shared/levels beside the sources.
inline std::optional<std::filesystem::path> real_levels_folder() {
    const char* shared = std::getenv("VIGIL_SHARED");
    const std::filesystem::path root =
        shared ? std::filesystem::path(shared)
               : std::filesystem::path(VIGIL_SOURCE_DIR).parent_path() / "shared";
    if (!std::filesystem::exists(root / "levels" / "baseq2" / "maps")) return std::nullopt;
    return root / "levels";
}

inline Bytes read_file(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return Bytes(std::istreambuf_iterator<char>(file), {});
}

/// A row of the levels' README.
struct RealLevel {
    const char* name;
    size_t faces, clusters, emissive_faces, max_emissive_in_pvs, median_emissive_in_pvs;
    size_t sky_faces, brush_models;
};

inline constexpr std::array<RealLevel, 6> real_levels = {{
    {"e3m6", 9037, 1666, 757, 123, 22, 124, 65},
    {"e3m4", 7956, 1268, 429, 67, 24, 51, 130},
    {"end", 3004, 500, 398, 152, 61, 0, 50},
    {"dm3", 3987, 668, 340, 227, 18, 38, 6},
    {"e1m1", 6684, 1204, 230, 65, 15, 75, 57},
    {"start", 6987, 1149, 157, 24, 8, 93, 54},
}};

} // namespace vigil
