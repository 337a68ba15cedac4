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

void main() {
    const uvec2 pixel = gl_GlobalInvocationID.xy;
    const uint lane = gl_LocalInvocationIndex;
    tile[lane] = vec2(0.0);
    if (all(lessThan(pixel, frame.size))) {
        const uint index = pixel.y * frame.size.x + pixel.x;
        const uint carry_index = frame.size.x * frame.size.y + index;
        vec3 value = mean_radiance[index];
        vec3 carry = mean_radiance[carry_index];
        add_to_mean(value, carry, frame.accumulated, radiance[index] / float(path_count));
        mean_radiance[index] = value;
        mean_radiance[carry_index] = carry;
        tile[lane] = vec2(luminance(value), 1.0);
    }
    for (uint step = 32u; step > 0u; step >>= 1) {
        barrier();
        if (lane < step) tile[lane] += tile[lane + step];
    }
    // A tile's mean hardly knows noise, which a mean of logarithms of single pixels would take for darkness or for light.
    // Black tiles say nothing about how bright the rest should look.
    const float brightness = tile[0].x / tile[0].y;
    const vec2 counted = brightness > 1e-6 ? vec2(log2(brightness), 1.0) : vec2(0.0);
    if (lane == 0u) exposure_tiles[gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x] = counted;
}
