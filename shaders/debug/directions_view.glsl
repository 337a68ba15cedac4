// SPDX-License-Identifier: GPL-2.0-or-later
// `pt_view cdq`, drawn over the picture: the leaves of the octree node under the crosshair stay bright, and two octahedral maps show
// with which density their quadtree draws directions, and the density in proportion to the light that arrives there (paper, figure 10).
#ifndef VIGIL_DEBUG_DIRECTIONS_VIEW_GLSL
#define VIGIL_DEBUG_DIRECTIONS_VIEW_GLSL

#include "debug/direction_map.glsl"
#include "guiding/guider.glsl"
#include "guiding/octree.glsl"
#include "scene/surface.glsl"
#include "shared/view_colors.h"

/// A density per steradian on its scale.
vec3 density_color(float density) { return density > 0.0 ? color_map(density_on_scale(density)) : VIEW_EMPTY; }

/// Density of the guider's draws.
vec3 guide_color(Surface surface, DirectionInset inset) {
#if GUIDES == 0
    return VIEW_OFF;
#else
    const SurfaceLeaves found = find_leaves(surface.position, previous_position(surface));
    const Guide guide = guide_prepare(load_guide(octree_node_of(found.cache)));
    const vec3 color = density_color(guide_pdf(guide, octahedral_decode(inset.uv)));
    return guide_border(guide, inset.uv, float(inset.edge)) ? 0.7 * color : color;
#endif
}

/// The light that arrives, as a density: divided by its integral over all directions.
vec3 arriving_color(DirectionInset inset) {
    float sum = 0.0;
    for (uint group = 0u; group < DIRECTION_MAP_GROUPS; ++group) sum += direction_sums[group];
    const uvec2 cell = uvec2(inset.uv * float(DIRECTION_MAP_EDGE));
    const float part = directions[cell.y * DIRECTION_MAP_EDGE + cell.x] / max(sum, 1e-30);
    const float per_square = part * float(DIRECTION_MAP_EDGE * DIRECTION_MAP_EDGE);
    return density_color(per_square * octahedral_density(octahedral_decode(inset.uv)));
}

vec3 inset_color(Surface surface, DirectionInset inset) {
    if (on_horizon(surface.normal, inset.uv, 1.0 / float(inset.edge))) return VIEW_HORIZON;
    return inset.kind == INSET_QUADTREE ? guide_color(surface, inset) : arriving_color(inset);
}

/// A cross around the crosshair's pixel, which stays free.
bool on_crosshair(uvec2 pixel) {
    const uvec2 away = uvec2(abs(ivec2(pixel) - ivec2(crosshair_pixel(frame.size))));
    const uint size = max(frame.size.y / 60u, 2u);
    return min(away.x, away.y) == 0u && max(away.x, away.y) > size / 3u && max(away.x, away.y) <= size;
}

/// `at_crosshair` is the surface there, if `found`; `here` that of the pixel, if `hit`.
vec3 directions_color(uvec2 pixel, vec3 picture, Surface at_crosshair, bool found, Surface here, bool hit) {
    const DirectionInset inset = direction_inset(pixel, frame.size);
    if (inset.kind != INSET_NONE) return found ? inset_color(at_crosshair, inset) : VIEW_OFF;
    if (on_crosshair(pixel)) return VIEW_HORIZON;
    if (guided == 0u || !found) return picture;
    const bool same_node = hit && octree_node_of(find_leaves(here.position, previous_position(here)).cache) ==
                                      octree_node_of(find_leaves(at_crosshair.position, previous_position(at_crosshair)).cache);
    return same_node ? picture : VIEW_OTHER_LEAF * picture;
}

#endif
