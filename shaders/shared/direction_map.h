// SPDX-License-Identifier: GPL-2.0-or-later
// Measures of `pt_view cdq`: the map of the light that arrives at the crosshair from all directions, and where the picture's two
// squares (insets) show octahedral maps: the quadtree's density on the left, the light on the right. The same text for
// the shaders that make and show it and for tests. The scale of densities is in view_colors.h.
#ifndef VIGIL_SHARED_DIRECTION_MAP_H
#define VIGIL_SHARED_DIRECTION_MAP_H

#include "glsl.h"
#include "octahedral.h"

SHADER_BEGIN

/// Cells of the map along an edge; one path per cell and frame. Made by work groups of 8 x 8 cells, each of which adds its cells up.
SHADER_CONST uint DIRECTION_MAP_EDGE = 64u;
SHADER_CONST uint DIRECTION_MAP_GROUPS = (DIRECTION_MAP_EDGE / 8u) * (DIRECTION_MAP_EDGE / 8u);

/// Pixel under the crosshair.
SHADER_FN uvec2 crosshair_pixel(uvec2 size) { return size / 2u; }

SHADER_CONST uint INSET_NONE = 0u;
SHADER_CONST uint INSET_QUADTREE = 1u;
SHADER_CONST uint INSET_ARRIVING = 2u;

/// A pixel's place in an inset.
struct DirectionInset {
    uint kind; // INSET_*
    uint edge; // of the square, pixels
    vec2 uv;   // the pixel's centre on the octahedral map; v grows upwards
};

/// The insets lie beside each other in the lower right quarter of a picture of `size` pixels, at least 16 x 16.
SHADER_FN DirectionInset direction_inset(uvec2 pixel, uvec2 size) {
    const uint gap = max(size.y / 90u, 1u);
    DirectionInset inset;
    inset.edge = min((size.x / 2u - 3u * gap) / 2u, size.y / 2u - 2u * gap);
    inset.kind = INSET_NONE;
    inset.uv = vec2(0.0f);
    // From the lower right corner.
    const uvec2 from = size - 1u - min(pixel, size - 1u);
    const uint step = inset.edge + gap;
    if (from.y < gap || from.y - gap >= inset.edge || from.x < gap || from.x - gap >= inset.edge + step) return inset;
    const uint place = (from.x - gap) % step;
    if (place >= inset.edge) return inset;
    inset.kind = from.x - gap < step ? INSET_ARRIVING : INSET_QUADTREE;
    inset.uv = (vec2(float(inset.edge - 1u - place), float(from.y - gap)) + 0.5f) / float(inset.edge);
    return inset;
}

/// Whether the horizon of a surface passes the pixel at `uv`, whose edge on the map is `width`: its upper or right neighbour
/// looks to the other side.
SHADER_FN bool on_horizon(vec3 normal, vec2 uv, float width) {
    const bool here = dot(normal, octahedral_point(uv)) > 0.0f;
    const bool right = dot(normal, octahedral_point(min(uv + vec2(width, 0.0f), vec2(1.0f)))) > 0.0f;
    const bool above = dot(normal, octahedral_point(min(uv + vec2(0.0f, width), vec2(1.0f)))) > 0.0f;
    return right != here || above != here;
}

SHADER_END
#endif
