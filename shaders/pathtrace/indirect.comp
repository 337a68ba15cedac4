#version 460
// SPDX-License-Identifier: GPL-2.0-or-later
// Pass `indirect`: a ray from the primary hit, drawn by the BRDF or by what was learned about directions, next event estimation where it lands, and
// from there a last ray for what next event estimation does not cover: the sky, unless that is sampled as a light, and the emission of lights that
// a technique leaves to rays. Without either there is no last ray. Compiled once per technique.
#extension GL_GOOGLE_include_directive : require
#include "shared/extensions.glsl"
#include "pathtrace/path.glsl"
#include "pathtrace/indirect_ray.glsl"

/// `brought` is the luminance that the ray brought to its surface's viewer.
void learn_direction(Guided guided, float brought) {
    if (GUIDES == 0 || path_index != 0u || guiding.guides == 0u) return;
    // Brighter than a sample can say is as bright as it can.
    const float estimate = min(finite_or_zero(brought), 1e15);
    // Where BRDF and cosine are weighed anyway, the guider learns where light comes from; else both are a part of it.
    const float sought = frame.settings.pt_guide_directions > 1 && guided.reflects > 0.0 ? estimate / guided.reflects : estimate;
    const float contribution = guided.pdf > 0.0 ? finite_or_zero(sought * sqrt(guided.pdf)) : 0.0;
    if (contribution > 0.0)
        store_ray_sample(guided.leaf, uvec2(ray_sample_pack(guided.grid, contribution), pack_sums(estimate * estimate, guided.part)));
    else count_blank_ray(guided.leaf);
}

/// Part of the paths that send one more ray than pt_bounces, only to learn what tails bring where paths end: places that the camera has not seen.
const float TAIL_LEARNERS = 0.125;
/// No vertex has this number: where that ray ends, light samples have theirs.
const uint TAIL_NUMBER = 32u;

/// Whether a path does. Whole subgroups do, as with light samples.
bool learns_tail() { return has_tail() && path_index == 0u && guiding.stores != 0u && subgroup_number(TAIL_NUMBER) < TAIL_LEARNERS; }

/// `light` is what was drawn where the first ray ended.
vec3 trace_path(Surface surface, inout Random random, out uint light) {
    light = NONE;
    vec3 gathered = vec3(0.0);
    vec3 throughput = vec3(1.0);
    // Of the first ray: what it brings grows with what others find. Little is kept while rays are traced: graphics cards trace more at once then.
    Guided first;
    float first_brought = 0.0;
    bool sent = false;
    const int bounces = frame.settings.pt_bounces;
    const int lit_ends = learns_tail() ? bounces + 1 : bounces;
    for (int depth = 0; depth <= lit_ends; ++depth) {
        if (depth == lit_ends && !rays_find_light()) break;
        // Send a ray, see what is there, and light it.
        Ray ray;
        vec3 weight;
        Guided guided;
        if (!scatter(surface, random, weight, ray, guided)) {
            learn_direction(guided, 0.0);
            break;
        }
        throughput *= weight;
        const bool lit = depth < lit_ends;
        const RayEnd end =
            follow_ray(surface, ray, guided.brdf_pdf, lit, uint(depth + 1), lit && (depth + 1 < bounces || rays_find_light()), random);
        // The tail is in the place of further rays. What is sent only to learn brings nothing.
        const vec3 tail = depth + 1 == bounces ? end.tail : vec3(0.0);
        const bool counts = depth < bounces || lit_ends == bounces;
        if (counts) gathered += throughput * (end.brought + tail);
        // Learn from it.
        if (depth == 0) {
            first = guided;
            sent = true;
            light = end.light;
        } else {
            learn_direction(guided, luminance(weight * (end.taught + end.tail)));
        }
        if (counts) first_brought += luminance(throughput * (end.taught + tail));
        if (!end.goes_on) break;
        surface = end.surface;
    }
    if (sent) learn_direction(first, first_brought);
    return gathered;
}

void main() {
    uvec2 pixel;
    uint index;
    if (!pixel_of_indirect_invocation(pixel, index)) return;
    const PrimaryHit hit = load_primary_hit(index);
    if (hit.primitive == NONE) return;
    Random random = path_random(pixel, STREAM_INDIRECT);
    uint light;
    const vec3 gathered = trace_path(load_primary_surface(hit), random, light);
    add_radiance(index, gathered, false);
    if (frame.filter_flags == 0u) return;
    const vec3 before = path_index > 0u ? filter_input[index].indirect : vec3(0.0);
    filter_input[index].indirect = radiance_sum(before, gathered / filter_albedo(hit));
    if (path_index == 0u) filter_input[index].indirect_light = light;
}
