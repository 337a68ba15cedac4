// SPDX-License-Identifier: GPL-2.0-or-later
// An indirect ray: how it is drawn, by the BRDF or by what was learned about directions, and what it brings from where it
// ends. Compiled once per technique; a technique whose lights are found by rays also collects their emission.
#ifndef VIGIL_PATHTRACE_INDIRECT_RAY_GLSL
#define VIGIL_PATHTRACE_INDIRECT_RAY_GLSL

#include "scene/firewall.glsl"
#include "pathtrace/sky.glsl"
#include "pathtrace/next_event.glsl"
#include "guiding/guider.glsl"
#include "guiding/octree.glsl"

// Later hits see textures through a wide cone: their detail is averaged by the integral anyway.
const float INDIRECT_SPREAD = 0.1;

/// Next event estimation draws sky and sun, too.
bool samples_environment() { return HAS_ENVIRONMENT && LIGHTS_FOUND_BY_RAYS == 0; }
/// Whether there is anything for a ray to bring from where nothing is lit.
bool rays_find_light() { return LIGHTS_FOUND_BY_RAYS != 0 || (HAS_SKY && !HAS_ENVIRONMENT); }

/// Whether paths bring the light of bounces beyond their last one. Where rays find light, the last one does not end at a surface that is lit.
bool has_tail() { return GUIDES != 0 && frame.settings.pt_tail != 0 && frame.settings.pt_bounces > 0 && !rays_find_light(); }

/// A ray's part in what its surface's leaf learns about directions.
struct Guided {
    uint leaf;      // that stores it
    uvec2 grid;     // cell of its direction
    float pdf;      // per steradian
    float brdf_pdf; // the same if the BRDF had drawn it
    float part;     // of the density that is the guider's
    float reflects; // luminance of BRDF times cosine
};

/// Radiance that a ray from `surface` collects from what it runs into, without what next event estimation covers.
vec3 collect(Surface surface, Ray ray, Hit hit, Vertex vertex, float brdf_pdf) {
    if (!vertex.sky) return LIGHTS_FOUND_BY_RAYS != 0 ? vertex.emission : vec3(0.0);
    if (!samples_environment()) return sky_radiance(ray.direction);
    vec3 sum = vec3(0.0);
    uint light = sky_light(hit, ray.origin, ray.direction);
    vec3 radiance = sky_box_radiance(ray.direction);
    // Of the sky, and then of the sun: one loop for both, as what a technique inlines is long.
    for (uint parts = meets_sun(ray.direction) ? 2u : 1u; parts > 0u; --parts) {
        float part = 1.0;
        if (light != NONE) {
            const float inverse_density = environment_inverse_density(load_light(light), ray.origin, ray.direction);
            part -= sampled_share(light_probability(surface, light), inverse_density, brdf_pdf);
        }
        sum += part * radiance;
        light = frame.sun_light;
        radiance = frame.sun_radiance;
    }
    return sum;
}

/// Draws a direction by the BRDF.
vec3 draw_plain_direction(Surface surface, inout Random random, out BrdfValue seen, out Guided guided) {
    const BrdfSample drawn = brdf_sample(surface.brdf, surface.normal, surface.view, random_next3(random));
    seen = drawn.seen;
    guided = Guided(NONE, uvec2(0u), 0.0, seen.pdf, 0.0, 0.0);
    return drawn.direction;
}

#if GUIDES == 0
vec3 draw_direction(Surface surface, inout Random random, out BrdfValue seen, out Guided guided) {
    return draw_plain_direction(surface, random, seen, guided);
}
#else
/// Draws directions by the BRDF and, in a part of the draws, by the guider of the surface's node (paper, section 5.2). Of several, one is
/// kept in proportion to what it is expected to bring (resampled importance sampling, Talbot et al. 2005): BRDF times cosine, times the guider's
/// density, mixed with an even one by the same part. `seen.pdf` is then an estimate, and its inverse is unbiased.
vec3 draw_direction(Surface surface, inout Random random, out BrdfValue seen, out Guided guided) {
    if (guiding.guides == 0u) return draw_plain_direction(surface, random, seen, guided);
    const SurfaceLeaves found = find_leaves(surface.position, previous_position(surface));
    const uint node = octree_node_of(found.cache);
    const Guide guide = guide_prepare(load_guide(node));
    const float share = share_of(load_share(node), 1.0 - frame.settings.pt_cdq_brdf);
    const int count = frame.settings.pt_guide_directions;
    const float choice = random_next(random);
    vec3 direction = surface.normal;
    seen = BrdfValue(vec3(0.0), 0.0);
    guided.brdf_pdf = 0.0;
    guided.part = 0.0;
    guided.reflects = 0.0;
    float sum = 0.0, kept = 0.0;
    for (int i = 0; i < count; ++i) {
        const vec3 u = random_next3(random);
        vec3 candidate;
        float density;
        if (fract(choice + float(i) / float(count)) < share) {
            candidate = guide_sample(guide, u, density);
        } else {
            candidate = brdf_sample(surface.brdf, surface.normal, surface.view, u).direction;
            density = guide_pdf(guide, candidate);
        }
        const BrdfValue value = brdf_evaluate(surface.brdf, surface.normal, surface.view, candidate);
        const float mixture = guide_mixture_pdf(density, value.pdf, 1.0 - share);
        const float reflects = luminance(value.value);
        const float expected = reflects * guide_mixture_pdf(density, 1.0 / (4.0 * PI), 1.0 - share);
        const float weight = mixture > 0.0 ? expected / mixture : 0.0;
        if (!(weight > 0.0)) continue;
        sum += weight;
        if (sum > weight && random_next(random) * sum >= weight) continue;
        direction = candidate;
        seen = value;
        kept = expected;
        guided.brdf_pdf = value.pdf;
        guided.part = min(share * density / mixture, 1.0);
        guided.reflects = reflects;
    }
    seen.pdf = sum > 0.0 ? float(count) * kept / sum : 0.0;
    guided.leaf = found.samples;
    guided.grid = ray_sample_cell(direction);
    guided.pdf = seen.pdf;
    if (STORES_LIGHT_SAMPLES == 0 && path_index == 0u) count_surface(found.samples);
    return direction;
}
#endif

/// Sends a ray from `surface`. Returns false if the path ends there; `weight` is what the ray's radiance is multiplied with.
bool scatter(Surface surface, inout Random random, out vec3 weight, out Ray ray, out Guided guided) {
    BrdfValue seen;
    ray = Ray(surface.origin, 0.0, draw_direction(surface, random, seen, guided), 1e30);
    weight = vec3(0.0);
    if (!(finite_or_zero(seen.pdf) > 0.0)) return false;
    weight = finite_or_zero(seen.value / seen.pdf);
    return max(weight.x, max(weight.y, weight.z)) > 0.0;
}

/// Reflected light counts as no more than this of what arrives: a closed white room would grow brighter for ever.
const float TAIL_LARGEST_ALBEDO = 0.98;

TailMemory find_tail(Surface surface) { return load_tail(find_leaves(surface.position, previous_position(surface)).cache); }

/// With pt_tail, the radiance of all further bounces at a surface: its node's mean, in the surface's colour. Where no ray has been, light is as at
/// the surface `before` on the path: of rays that only learn, many end where no others do.
vec3 tail_radiance(Surface surface, Surface before) {
    const vec3 color = surface.brdf.albedo + surface.brdf.f0;
    const float brightness = luminance(color);
    if (!(brightness > 0.0)) return vec3(0.0);
    TailMemory memory = find_tail(surface);
    if (!(memory.rays > 0.0)) memory = find_tail(before);
    return finite_or_zero(memory.mean * min(1.0, TAIL_LARGEST_ALBEDO / brightness) / brightness * color);
}

/// Where a ray ended.
struct RayEnd {
    vec3 brought; // radiance along the ray, towards its origin: without what further rays find
    vec3 taught;  // the part of it that no light sample draws
    vec3 tail;    // what further rays would find, if that is known (pt_tail)
    uint light;   // that was drawn there, or NONE
    bool goes_on; // a further ray may be sent from `surface`, which is not set otherwise
    Surface surface;
};

/// Sees what is there, and, if `light` is true, samples the lights there, as vertex `vertex_number` of the path; `ray_follows` is whether another
/// ray is sent from there. `surface` is where the ray starts, and `brdf_pdf` the density of its direction by the BRDF.
RayEnd follow_ray(Surface surface, Ray ray, float brdf_pdf, bool light, uint vertex_number, bool ray_follows, inout Random random) {
    RayEnd end;
    end.brought = vec3(0.0);
    end.taught = vec3(0.0);
    end.tail = vec3(0.0);
    end.light = NONE;
    end.goes_on = false;
    Hit hit;
    if (!trace_closest(ray, random_next_words(random).x, hit)) return end;
    const Vertex vertex = describe_hit(ray, hit, INDIRECT_SPREAD, false);
    end.brought = finite_or_zero(collect(surface, ray, hit, vertex, brdf_pdf));
    if (!samples_environment()) end.taught = end.brought;
    if (!vertex.lit || !light) return end;
    end.goes_on = true;
    end.surface = vertex.surface;
    if (LIGHTS_FOUND_BY_RAYS == 0 && HAS_LIGHTS) {
        const DirectLight direct = next_event_estimate(end.surface, vertex_number, ray_follows, random);
        end.brought += direct.radiance;
        end.light = direct.light;
        end.taught = end.brought;
    }
    if (has_tail()) end.tail = tail_radiance(end.surface, surface);
    return end;
}

#endif
