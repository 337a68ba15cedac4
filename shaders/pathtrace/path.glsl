// SPDX-License-Identifier: GPL-2.0-or-later
// What the passes of the path tracer share: pixel addressing, the random streams, and storing and loading primary hits.
#ifndef VIGIL_PATHTRACE_PATH_GLSL
#define VIGIL_PATHTRACE_PATH_GLSL

#include "pathtrace/surface.glsl"
#include "shared/random.h"

// One work group is a tile of 8 x 8 pixels.
layout(local_size_x = 8, local_size_y = 8) in;

// Each pass draws from a stream of its own, so that passes do not depend on how many numbers another used.
const uint STREAM_PRIMARY = 0u;
const uint STREAM_DIRECT = 1u;
const uint STREAM_INDIRECT = 2u;
const uint STREAM_VIEW = 3u;
const uint STREAM_COUNT = 4u;

Random path_random(uvec2 pixel, uint stream) {
    const uint path = frame.frame * path_count + path_index;
    return random_begin(pixel, path * STREAM_COUNT + stream, uint(frame.cvars.pt_seed));
}

bool pixel_of_invocation(out uvec2 pixel, out uint index) {
    pixel = gl_GlobalInvocationID.xy;
    index = pixel.y * frame.size.x + pixel.x;
    return all(lessThan(pixel, frame.size));
}

/// Adds to the pixel's sum of this frame. What is not finite is counted and kept out: it would stay in every mean.
void add_radiance(uint index, vec3 value, bool first) {
    if (!all(lessThan(abs(value), vec3(3e38)))) { // also false for NaN
        atomicAdd(counters.nonfinite, 1u);
        primary_hits[index].flags |= PRIMARY_HIT_NONFINITE;
        value = vec3(0.0);
    }
    radiance[index] = first ? value : radiance[index] + value;
}

Surface load_primary_surface(PrimaryHit hit) {
    Surface surface;
    surface.position = hit.position;
    surface.normal = hit.normal;
    surface.origin = offset_ray_origin(hit.position, hit.normal);
    surface.view = normalize(frame.camera_origin - hit.position);
    surface.brdf = brdf_lambert(hit.albedo);
    if (HAS_GLOSS) {
        const vec2 gloss = unpackHalf2x16(hit.gloss);
        surface.brdf.alpha = gloss.x;
        surface.brdf.f0 = gloss.y;
    }
    surface.primitive = hit.primitive;
    surface.instance = hit.instance;
    return surface;
}

#endif
