#version 460
// SPDX-License-Identifier: GPL-2.0-or-later
// Pass `filter_tiles`: what is known of the light in a tile of 4 x 4 pixels. First, how bright samples are there, over some frames: one pixel alone hardly
// knows. Second, what part of it comes from lamps that have changed since the frame before: of this frame's samples, which know lamps that came, and of
// the last frame's, which know lamps that went. In the place of samples that are traced again (Schied et al., "Gradient Estimation for Real-Time Adaptive
// Temporal Filtering", 2018): it needs no rays.
#extension GL_GOOGLE_include_directive : require
#include "shared/extensions.glsl"
#include "filter/tiles.glsl"
#include "shared/firewall.h"

const float NEW_PART = 0.1; // of this frame in what is known of brightness

void main() {
    const ivec2 place = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(place, ivec2(tile_count())))) return;
    const bool has_past = (frame.filter_flags & FILTER_HISTORY) != 0u && frame.last_size == frame.size; // tiles lie where they lay
    const bool changes = (frame.filter_flags & FILTER_CHANGES) != 0u;
    FilterTile tile = FilterTile(vec4(0.0), vec2(0.0), vec2(0.0));
    vec2 count = vec2(0.0);
    for (int i = 0; i < FILTER_TILE * FILTER_TILE; ++i) {
        const ivec2 pixel = FILTER_TILE * place + ivec2(i % FILTER_TILE, i / FILTER_TILE);
        if (!inside_picture(pixel)) continue;
        const uint index = pixel_index(pixel);
        if (load_primary_hit(index).primitive != NONE) {
            const FilterInput seen = load_filter_input(index);
            const vec2 bright = sample_brightness(seen);
            tile.mean += bright;
            tile.second_moments += bright * bright;
            count += vec2(1.0, has_indirect_turn(uvec2(pixel), indirect_turn) ? 1.0 : 0.0);
            if (changes) tile.changed += vec4(bright * vec2(light_change(seen.direct_light), light_change(seen.indirect_light)), bright);
        }
        if (!changes || !has_past) continue;
        const FilterSurface last = load_surface(last_half() + index);
        if (last.depth == 0.0) continue;
        const vec2 bright = unpackHalf2x16(last.brightness);
        const FilterStatistics drawn = load_statistics(last_half() + index);
        tile.changed += vec4(bright * vec2(light_change(drawn.direct_light), light_change(drawn.indirect_light)), bright);
    }
    tile.mean /= max(count, vec2(1.0));
    tile.second_moments /= max(count, vec2(1.0));
    const uint index = tile_index(place);
    const FilterTile before = load_tile(index);
    if (has_past && is_finite_nonnegative(vec3(before.mean, dot(before.second_moments, vec2(1.0))))) {
        // What was known of lamps that have changed is of no use.
        const vec2 part = clamp(tile.changed.xy / max(tile.changed.zw, vec2(1e-6)), vec2(NEW_PART), vec2(1.0));
        tile.mean = mix(before.mean, tile.mean, part);
        tile.second_moments = mix(before.second_moments, tile.second_moments, part);
    }
    filter_tiles[index] = tile;
}
