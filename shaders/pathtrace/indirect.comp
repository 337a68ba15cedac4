#version 460
// SPDX-License-Identifier: GPL-2.0-or-later
// Pass `indirect`: a BRDF ray from the primary hit, next event estimation where it lands, and from there a last ray that
// collects only what next event estimation does not cover: the sky. Compiled once per technique; a
// technique whose lights are found by rays also collects their emission.
#extension GL_GOOGLE_include_directive : require
#include "shared/extensions.glsl"
#include "pathtrace/path.glsl"
#include "pathtrace/sky.glsl"
#include "pathtrace/next_event.glsl"

#ifndef LIGHTS_FOUND_BY_RAYS
#define LIGHTS_FOUND_BY_RAYS 0
#endif

// Later hits see textures through a wide cone: their detail is averaged by the integral anyway.
const float INDIRECT_SPREAD = 0.1;

/// Radiance that a ray collects from what it runs into, without what next event estimation covers.
vec3 collect(Vertex vertex, vec3 direction) {
    if (vertex.sky) return sky_radiance(direction);
    return LIGHTS_FOUND_BY_RAYS != 0 ? vertex.emission : vec3(0.0);
}

/// Follows the BRDF from `surface`. Returns false if the path ends there.
bool scatter(Surface surface, inout Random random, inout vec3 throughput, out Ray ray) {
    const BrdfSample drawn = brdf_sample(surface.brdf, surface.normal, surface.view, random_next3(random));
    if (!(drawn.seen.pdf > 0.0)) return false;
    throughput *= drawn.seen.value / drawn.seen.pdf;
    ray.origin = surface.origin;
    ray.direction = drawn.direction;
    ray.t_min = 0.0;
    ray.t_max = 1e30;
    return max(throughput.x, max(throughput.y, throughput.z)) > 0.0;
}

vec3 trace_path(Surface surface, inout Random random) {
    vec3 gathered = vec3(0.0);
    vec3 throughput = vec3(1.0);
    const int bounces = frame.cvars.pt_bounces;
    for (int depth = 0; depth <= bounces; ++depth) {
        // Follow the BRDF and see what is there.
        Ray ray;
        if (!scatter(surface, random, throughput, ray)) break;
        Hit hit;
        if (!trace_closest(ray, random_next_words(random).x, hit)) break;
        const Vertex vertex = describe_hit(ray, hit, INDIRECT_SPREAD, false);
        gathered += throughput * collect(vertex, ray.direction);
        if (!vertex.lit || depth == bounces) break;
        // Light it.
        surface = vertex.surface;
        if (LIGHTS_FOUND_BY_RAYS == 0 && HAS_LIGHTS)
            gathered += throughput * next_event_estimate(surface, random).radiance;
    }
    return gathered;
}

void main() {
    uvec2 pixel;
    uint index;
    if (!pixel_of_invocation(pixel, index)) return;
    const PrimaryHit hit = primary_hits[index];
    if (hit.primitive == NONE) return;
    Random random = path_random(pixel, STREAM_INDIRECT);
    add_radiance(index, trace_path(load_primary_surface(hit), random), false);
}
