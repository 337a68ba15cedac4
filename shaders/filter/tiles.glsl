// SPDX-License-Identifier: GPL-2.0-or-later
// Tiles of pixels: what is known of the light around a pixel (filter_tiles.comp).
#ifndef VIGIL_FILTER_TILES_GLSL
#define VIGIL_FILTER_TILES_GLSL

#include "filter/filter.glsl"

layout(set = SET_FILTER, binding = BINDING_FILTER_TILES, scalar) restrict writeonly buffer FilterTileBlock { FilterTile filter_tiles[]; };
layout(set = SET_FILTER, binding = BINDING_FILTER_TILE_RECORDS) uniform utextureBuffer tile_records; // the same to read
// By light id, with FILTER_CHANGES: how much it has changed, 0..1 (light/light_changes.h).
layout(set = SET_FILTER, binding = BINDING_FILTER_LIGHT_CHANGES, scalar) restrict readonly buffer LightChangeBlock {
    float light_changes[];
};

FilterTile load_tile(uint index) {
    const vec4 known = load_floats(tile_records, 2 * int(index) + 1);
    return FilterTile(load_floats(tile_records, 2 * int(index)), known.xy, known.zw);
}

float light_change(uint light) { return light < frame.light_count ? light_changes[light] : 0.0; }

uvec2 tile_count() { return (frame.size + uint(FILTER_TILE - 1)) / uint(FILTER_TILE); }
uint tile_index(ivec2 tile) { return uint(tile.y) * tile_count().x + uint(tile.x); }
/// That of a pixel, or the one `step` tiles from it; at the picture's edge its own.
ivec2 tile_near(ivec2 pixel, ivec2 step) { return clamp(pixel / FILTER_TILE + step, ivec2(0), ivec2(tile_count()) - 1); }

/// Luminances of the frame's samples, direct and indirect.
vec2 sample_brightness(FilterInput seen) { return min(luminances(seen.direct, seen.indirect) / float(path_count), vec2(FILTER_MAX)); }

/// How bright samples are around a pixel, in the four nearest tiles: means and means of squares, direct and indirect.
void brightness_around(ivec2 pixel, out vec2 mean, out vec2 second_moments) {
    const ivec2 side = 2 * (pixel % FILTER_TILE / (FILTER_TILE / 2)) - 1;
    mean = second_moments = vec2(0.0);
    for (int i = 0; i < 4; ++i) {
        const FilterTile tile = load_tile(tile_index(tile_near(pixel, side * ivec2(i & 1, i >> 1))));
        mean += 0.25 * tile.mean;
        second_moments += 0.25 * tile.second_moments;
    }
}

/// Part of the light around a pixel that comes from lamps that have changed, direct and indirect, in 3 x 3 tiles `apart` from each other.
vec2 changed_around(ivec2 pixel, int apart) {
    vec4 sum = vec4(0.0);
    for (int i = 0; i < 9; ++i) sum += load_tile(tile_index(tile_near(pixel, apart * ivec2(i % 3 - 1, i / 3 - 1)))).changed;
    return sum.xy / max(sum.zw, vec2(1e-6));
}

#endif
