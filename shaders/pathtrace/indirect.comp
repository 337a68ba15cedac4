#version 460
// SPDX-License-Identifier: GPL-2.0-or-later
// Pass `indirect`: a ray from the primary hit, drawn by the BRDF or by what was learned about directions, next event estimation where it lands, and from there a last ray that
// collects only what next event estimation does not cover: the sky. Compiled once per technique; a
// technique whose lights are found by rays also collects their emission.
#extension GL_GOOGLE_include_directive : require
#include "shared/extensions.glsl"
#include "pathtrace/path.glsl"
#include "pathtrace/sky.glsl"
#include "pathtrace/next_event.glsl"
#include "guiding/octree.glsl"
#include "shared/cdq.h"

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

/// A ray's part in what its surface's leaf learns about directions.
struct Guided {
    uint leaf;  // that stores it
    uvec2 grid; // cell of its direction
    float pdf;  // per steradian
};

/// Draws a direction by the BRDF, or, in a part of the draws, by the quadtree of the surface's leaf (paper, section 5.2). Its density
/// is that of the mixture.
vec3 draw_direction(Surface surface, inout Random random, out BrdfValue seen, out Guided guided) {
    const vec3 u = random_next3(random);
    if (CDQ_BITS == 0u) {
        const BrdfSample drawn = brdf_sample(surface.brdf, surface.normal, surface.view, u);
        seen = drawn.seen;
        return drawn.direction;
    }
    const SurfaceLeaves found = find_leaves(surface);
    const uvec4 tree = load_cdq(found.cache);
    const float brdf_part = frame.cvars.pt_cdq_brdf;
    vec3 direction;
    if (random_next(random) < brdf_part)
        direction = brdf_sample(surface.brdf, surface.normal, surface.view, u).direction;
    else
        direction = cdq_sample(tree, CDQ_BITS, u);
    seen = brdf_evaluate(surface.brdf, surface.normal, surface.view, direction);
    const vec2 uv = octahedral_encode(direction);
    seen.pdf = mix(cdq_leaf_pdf(CDQ_BITS, cdq_find(tree, uv).depth, direction), seen.pdf, brdf_part);
    guided.leaf = found.samples;
    guided.grid = uvec2(uv * float(1u << CDQ_MAX_DEPTH));
    guided.pdf = seen.pdf;
    if (LEARNS_FROM_LIGHT_SAMPLES == 0 && path_index == 0u) count_surface(found.samples);
    return direction;
}

/// Sends a ray from `surface`. Returns false if the path ends there; `weight` is what the ray's radiance is multiplied with.
bool scatter(Surface surface, inout Random random, out vec3 weight, out Ray ray, out Guided guided) {
    BrdfValue seen;
    ray.origin = surface.origin;
    ray.direction = draw_direction(surface, random, seen, guided);
    ray.t_min = 0.0;
    ray.t_max = 1e30;
    weight = vec3(0.0);
    if (!(seen.pdf > 0.0)) return false;
    weight = seen.value / seen.pdf;
    return max(weight.x, max(weight.y, weight.z)) > 0.0;
}

void learn_direction(Guided guided, vec3 brought) {
    if (CDQ_BITS != 0u && path_index == 0u) store_ray_sample(guided.leaf, guided.grid, luminance(brought) * inversesqrt(guided.pdf));
}

vec3 trace_path(Surface surface, inout Random random) {
    vec3 gathered = vec3(0.0);
    vec3 throughput = vec3(1.0);
    // Of the first ray: what it brings grows with what the second finds.
    Guided first;
    vec3 first_brought = vec3(0.0);
    bool sent = false;
    const int bounces = frame.cvars.pt_bounces;
    for (int depth = 0; depth <= bounces; ++depth) {
        // Send a ray and see what is there.
        Ray ray;
        vec3 weight;
        Guided guided;
        if (!scatter(surface, random, weight, ray, guided)) break;
        throughput *= weight;
        Hit hit;
        vec3 brought = vec3(0.0);
        Vertex vertex;
        vertex.lit = false;
        if (trace_closest(ray, random_next_words(random).x, hit)) {
            vertex = describe_hit(ray, hit, INDIRECT_SPREAD, false);
            brought = collect(vertex, ray.direction);
        }
        // Light it.
        const bool goes_on = vertex.lit && depth < bounces;
        if (goes_on) {
            surface = vertex.surface;
            if (LIGHTS_FOUND_BY_RAYS == 0 && HAS_LIGHTS) brought += next_event_estimate(surface, random).radiance;
        }
        gathered += throughput * brought;
        // Learn from it.
        if (depth == 0) {
            first = guided;
            first_brought = brought;
            sent = true;
        } else {
            first_brought += weight * brought;
            learn_direction(guided, brought);
        }
        if (!goes_on) break;
    }
    if (sent) learn_direction(first, first_brought);
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
