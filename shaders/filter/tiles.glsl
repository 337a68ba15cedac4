// SPDX-License-Identifier: GPL-2.0-or-later
// Tiles of pixels: what is known of the light around a pixel (filter_tiles.comp).
#ifndef VIGIL_FILTER_TILES_GLSL
#define VIGIL_FILTER_TILES_GLSL

#include "filter/filter.glsl"

layout(set = SET_FILTER, binding = BINDING_FILTER_TILES, scalar) restrict buffer FilterTileBlock { FilterTile filter_tiles[]; };
// By light id, with FILTER_CHANGES: how much it has changed, 0..1 (light/light_changes.h).
layout(set = SET_FILTER, binding = BINDING_FILTER_LIGHT_CHANGES, scalar) restrict readonly buffer LightChangeBlock {
    float light_changes[];
};

float light_change(uint light) { return light < frame.light_count ? light_changes[light] : 0.0; }

uvec2 tile_count() { return (frame.size + uint(FILTER_TILE - 1)) / uint(FILTER_TILE); }
uint tile_index(ivec2 tile) { return uint(tile.y) * tile_count().x + uint(tile.x); }
/// That of a pixel, or the one `step` tiles from it; at the picture's edge its own.
ivec2 tile_near(ivec2 pixel, ivec2 step) { return clamp(pixel / FILTER_TILE + step, ivec2(0), ivec2(tile_count()) - 1); }

/// Luminances of the frame's samples, direct and indirect.
vec2 sample_brightness(uint index) {
    return min(luminances(filter_input[index].direct, filter_input[index].indirect) / float(path_count), vec2(FILTER_MAX));
}

/// How bright samples are in the 3 x 3 tiles around a pixel: mean and mean square.
FilterTile brightness_around(ivec2 pixel) {
    FilterTile sum = FilterTile(vec4(0.0), vec2(0.0), vec2(0.0));
    for (int i = 0; i < 9; ++i) {
        const uint index = tile_index(tile_near(pixel, ivec2(i % 3 - 1, i / 3 - 1)));
        sum.mean += filter_tiles[index].mean / 9.0;
        sum.second_moments += filter_tiles[index].second_moments / 9.0;
    }
    return sum;
}

/// Part of the light around a pixel that comes from lamps that have changed, direct and indirect, in 3 x 3 tiles `apart` from each other.
vec2 changed_around(ivec2 pixel, int apart) {
    vec4 sum = vec4(0.0);
    for (int i = 0; i < 9; ++i) sum += filter_tiles[tile_index(tile_near(pixel, apart * ivec2(i % 3 - 1, i / 3 - 1)))].changed;
    return sum.xy / max(sum.zw, vec2(1e-6));
}

#endif
