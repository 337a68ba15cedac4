// SPDX-License-Identifier: GPL-2.0-or-later
// The smallest level that uses every lump: two clusters on either side of x = 0, a floor and a
// ceiling quad, one brush, one brush model. Tests change single fields before they write the file.
#pragma once

#include "byte_writer.h"

#include <array>
#include <string>

namespace vigil {

/// Lump numbers of the IBSP header.
enum LevelLump : size_t {
    level_entities,
    level_planes,
    level_vertices,
    level_visibility,
    level_nodes,
    level_texinfo,
    level_faces,
    level_lighting,
    level_leafs,
    level_leaf_faces,
    level_leaf_brushes,
    level_edges,
    level_surf_edges,
    level_models,
    level_brushes,
    level_brush_sides,
    level_pop,
    level_areas,
    level_area_portals,
    level_lump_count
};

/// Bytes of one record in each lump.
inline constexpr std::array<size_t, level_lump_count> level_record_sizes = {
    1, 20, 12, 1, 28, 76, 20, 1, 28, 2, 2, 4, 4, 48, 12, 4, 1, 8, 8};

inline constexpr size_t level_header_size = 8 + 8 * level_lump_count;

using LevelLumps = std::array<Bytes, level_lump_count>;

/// What the level looks like:
///  - face 0: floor quad z = 0, x and y in 0..64, facing up, emissive texture "lamp", value 100
///  - face 1: ceiling quad z = 64, facing down (back side of its plane), texture "+0roof"
///  - face 2: belongs to brush model 1; the floor's polygon again
///  - leaf 0 solid; leaf 1 cluster 0 (x >= 0) with faces 0, 1, 2; leaf 2 cluster 1 (x < 0)
///  - cluster 0 sees itself only, cluster 1 sees both
LevelLumps small_level();

/// A complete file: header, lumps in order, `trailing` bytes behind them.
Bytes write_level(const LevelLumps& lumps, size_t trailing = 0);

} // namespace vigil
