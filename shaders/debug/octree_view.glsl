// SPDX-License-Identifier: GPL-2.0-or-later
// What the octree and its light caches are at a surface, for the views: the leaf with its cell, and what lies in its
// arrays. Only reads; call none of it where guiding is off (guided).
#ifndef VIGIL_DEBUG_OCTREE_VIEW_GLSL
#define VIGIL_DEBUG_OCTREE_VIEW_GLSL

#include "guiding/octree.glsl"
#include "scene/surface.glsl"
#include "shared/random.h"
#include "shared/view_colors.h"

OctreeCell find_cell(vec3 position) {
    const uvec3 grid = octree_grid(position, guiding.corner, guiding.scale);
    return octree_cell(grid, descend(octree_root(), grid).depth);
}

/// A colour that stays the leaf's while the leaf exists: leaves are numbered anew in every frame. Hues are spread over the
/// circle at three lightnesses.
vec3 cell_color(OctreeCell cell) {
    const uvec3 words = hash_pcg3d(cell.corner + 0x9e3779b9u * (cell.depth + 1u));
    const float hue = 6.28318531 * unit_float(words.x);
    const float lightness = 0.55 + 0.15 * float(words.y % 3u);
    return srgb_from_linear(clamp(linear_from_oklab(vec3(lightness, 0.1 * cos(hue), 0.1 * sin(hue))), 0.0, 1.0));
}

/// Whether a border of the cell passes through the pixel. `width` is the pixel's on the surface, in map units.
bool on_cell_border(OctreeCell cell, vec3 position, vec3 normal, float width) {
    const float size = float(octree_cell_size(cell.depth));
    if (size < 5.0 * width * guiding.scale) return false; // nothing but borders would be seen
    const vec3 inside = (position - guiding.corner) * guiding.scale - vec3(cell.corner);
    const vec3 away = max(min(inside, size - inside), 0.0) / guiding.scale;
    // Along the surface; a face that the surface lies in is no border on it.
    const vec3 slope = sqrt(max(1.0 - normal * normal, 0.0));
    const bvec3 near = lessThan(away, 0.6 * width * slope);
    return any(bvec3(near.x && slope.x > 0.1, near.y && slope.y > 0.1, near.z && slope.z > 0.1));
}

uint sample_count(Surface surface) {
    return leaves[leaf_word(LEAF_COUNT, find_leaves(surface.position, previous_position(surface)).samples)];
}

uint bucket_count(Surface surface) {
    return leaves[leaf_word(LEAF_VLC, find_leaves(surface.position, previous_position(surface)).cache) + 1u];
}

uint cached_light_count(Surface surface) {
    return leaves[leaf_word(LEAF_CACHED, find_leaves(surface.position, previous_position(surface)).cache)];
}

#endif
