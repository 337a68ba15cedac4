#version 460
// SPDX-License-Identifier: GPL-2.0-or-later
// Pass `accumulate`: folds this frame into the running mean (of one frame while nothing is accumulated) and takes the mean
// luminance of each tile for the automatic exposure.
#extension GL_GOOGLE_include_directive : require
#include "shared/extensions.glsl"
#include "post/picture.glsl"
#include "shared/running_mean.h"

layout(local_size_x = 8, local_size_y = 8) in;

shared vec2 tile[64];

/// The sum of a tile in the order of a tree, which barriers are few of: eight lanes add up eight each, and one of them their sums.
vec2 tile_sum(uint lane) {
    barrier();
    if (lane < 8u) {
        const vec2 first = (tile[lane] + tile[lane + 32u]) + (tile[lane + 16u] + tile[lane + 48u]);
        tile[lane] = first + ((tile[lane + 8u] + tile[lane + 40u]) + (tile[lane + 24u] + tile[lane + 56u]));
    }
    barrier();
    return ((tile[0] + tile[4]) + (tile[2] + tile[6])) + ((tile[1] + tile[5]) + (tile[3] + tile[7]));
}

void main() {
    const uvec2 pixel = gl_GlobalInvocationID.xy;
    const uint lane = gl_LocalInvocationIndex;
    tile[lane] = vec2(0.0);
    if (all(lessThan(pixel, frame.size))) {
        const uint index = pixel.y * frame.size.x + pixel.x;
        const uint carry_index = frame.size.x * frame.size.y + index;
        vec3 value, carry = vec3(0.0);
        if (turn.accumulated > 0u) value = mean_radiance[index];
        if (turn.accumulated > 1u) carry = mean_radiance[carry_index];
        add_to_mean(value, carry, turn.accumulated, radiance[index] / float(path_count));
        mean_radiance[index] = value;
        // Of one frame it is 0, and nobody reads it.
        if (turn.accumulated > 0u) mean_radiance[carry_index] = carry;
        tile[lane] = vec2(luminance(value), 1.0);
    }
    const vec2 sum = tile_sum(lane);
    // A tile's mean hardly knows noise, which a mean of single pixels' roots would take for darkness.
    // Black tiles say nothing about how bright the rest should look.
    const float brightness = sum.x / sum.y;
    const vec2 counted = brightness > 1e-6 ? vec2(pow(brightness, 1.0 / 3.0), 1.0) : vec2(0.0);
    if (lane == 0u) exposure_tiles[gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x] = counted;
}
