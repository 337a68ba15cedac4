#version 460
// SPDX-License-Identifier: GPL-2.0-or-later
// Pass `filter_changes`: what part of the light in a tile of 4 x 4 pixels comes from lamps that have changed since the frame before: of this frame's
// samples, which know lamps that came, and of the last frame's, which know lamps that went. In the place of samples that are traced again (Schied et
// al., "Gradient Estimation for Real-Time Adaptive Temporal Filtering", 2018): it needs no rays. Only in frames in which a lamp has changed.
#extension GL_GOOGLE_include_directive : require
#include "shared/extensions.glsl"
#include "filter/filter.glsl"

void main() {
    const ivec2 tile = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(tile, ivec2(change_tiles())))) return;
    vec4 sum = vec4(0.0); // changed and all, direct; the same, indirect
    for (int i = 0; i < CHANGE_TILE * CHANGE_TILE; ++i) {
        const ivec2 pixel = CHANGE_TILE * tile + ivec2(i % CHANGE_TILE, i / CHANGE_TILE);
        if (!inside_picture(pixel)) continue;
        const uint index = pixel_index(pixel);
        if (primary_hits[index].primitive != NONE) {
            const FilterInput now = filter_input[index];
            const vec2 bright = min(luminances(now.direct, now.indirect) / float(path_count), vec2(FILTER_MAX));
            sum += vec4(light_change(now.direct_light) * bright.x, bright.x, light_change(now.indirect_light) * bright.y, bright.y);
        }
        if ((frame.filter_flags & FILTER_HISTORY) == 0u) continue;
        const FilterSurface last = filter_surfaces[last_half() + index];
        if (last.depth == 0.0) continue;
        const vec2 bright = unpackHalf2x16(last.brightness);
        sum += vec4(light_change(last.direct_light) * bright.x, bright.x, light_change(last.indirect_light) * bright.y, bright.y);
    }
    filter_tiles[tile.y * int(change_tiles().x) + tile.x] = sum;
}
