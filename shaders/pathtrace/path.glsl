// SPDX-License-Identifier: GPL-2.0-or-later
// What the passes of the path tracer share: pixel addressing, the random streams, and sums of radiance.
#ifndef VIGIL_PATHTRACE_PATH_GLSL
#define VIGIL_PATHTRACE_PATH_GLSL

#include "scene/firewall.glsl"
#include "scene/surface.glsl"
#include "shared/random.h"

// One work group is a tile of 8 x 8 pixels.
layout(local_size_x = 8, local_size_y = 8) in;

// Each pass draws from a stream of its own (RANDOM_STREAMS of them), so that passes do not depend on how many numbers another used.
const uint STREAM_PRIMARY = 0u;
const uint STREAM_DIRECT = 1u;
const uint STREAM_INDIRECT = 2u;
const uint STREAM_VIEW = 3u;

Random path_random(uvec2 pixel, uint stream) {
    return random_path(pixel, path_number(turn.frame, path_count, path_index), stream, uint(frame.settings.pt_seed));
}

bool pixel_of_invocation(out uvec2 pixel, out uint index) {
    pixel = gl_GlobalInvocationID.xy;
    index = pixel.y * frame.size.x + pixel.x;
    const bool inside = all(lessThan(pixel, frame.size));
    if (inside) firewall_pixel = index;
    return inside;
}

bool pixel_of_side_invocation(out uvec2 pixel, out uint index) {
    const bool inside = pixel_of_side(pixel);
    index = pixel.y * frame.size.x + pixel.x;
    if (inside) firewall_pixel = index;
    return inside;
}

/// Of those pixels of the side whose turn it is.
bool pixel_of_indirect_invocation(out uvec2 pixel, out uint index) {
    pixel = indirect_pixel(gl_GlobalInvocationID.xy, indirect_turn) + uvec2(first_column & ~7u, 0u);
    index = pixel.y * frame.size.x + pixel.x;
    const bool inside = inside_side(pixel);
    if (inside) firewall_pixel = index;
    return inside;
}

/// A sum past the firewall.
vec3 radiance_sum(vec3 before, vec3 value) {
    const vec3 sum = before + finite_or_zero(value);
    // Finite values may have a sum that is not.
    const bool fits = is_finite_nonnegative(sum);
    if (!fits) count_nonfinite();
    return fits ? sum : before;
}

/// Adds to the pixel's sum of this frame.
void add_radiance(uint index, vec3 value, bool first) { radiance[index] = radiance_sum(first ? vec3(0.0) : radiance[index], value); }

#endif
