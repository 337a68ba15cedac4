// SPDX-License-Identifier: GPL-2.0-or-later
// Next event estimation: a light chosen by the technique, one point on it, one shadow ray; and a second one where the technique asks for it.
#ifndef VIGIL_PATHTRACE_NEXT_EVENT_GLSL
#define VIGIL_PATHTRACE_NEXT_EVENT_GLSL

#include "light/importance.glsl"
#include "shared/reservoir.h"
#include "light/technique.glsl"
#include "pathtrace/environment.glsl"
#include "shared/light_point.h"

/// What light samples add to a surface.
struct DirectLight {
    vec3 radiance; // towards the viewer: an unbiased estimate of that of all the technique's lights
    bool explored; // see LightChoice
    uint light;    // that the first of them drew which drew one, or NONE
};

/// A point on a light, and what it contributes unless something is in between.
struct PointChoice {
    vec3 point;
    vec3 direction; // to it
    vec3 value;     // BRDF * cosine / density: a mean over the points weighed
};

/// Weighs pt_light_points points of a light, spread evenly, and keeps one in proportion to its contribution; `value` is then their
/// mean, on the colour of the one kept (resampled importance sampling, Talbot et al. 2005; as the points have the light's density each, it is unbiased
/// for any number of them). With a good choice of lights the choice of the point makes most of the noise, and is the cheaper of the two.
PointChoice choose_point(Surface surface, Light light, vec2 u, float v) {
    const int density = frame.settings.pt_light_density;
    const SphericalTriangle near = near_light(light, surface.origin, density);
    float share = 0.0;
    if (HAS_GLOSS && surface.brdf.f0 > 0.0 && density == LIGHT_DENSITY_AUTO && !is_environment(light))
        share = lobe_share(prepare_importance(surface), surface.view, surface.brdf, light);
    PointChoice choice = PointChoice(vec3(0.0), vec3(0.0), vec3(0.0));
    const int points = is_sun(light) ? 1 : frame.settings.pt_light_points;
    Reservoir reservoir = new_reservoir(v);
    for (int i = 0; i < points; ++i) {
        const vec2 place = fract(u + float(i) * (vec2(R2_STEPS) / 4294967296.0));
        LightSample seen;
        if (is_sun(light)) seen = sample_sun(place);
        else seen = sample_light_glossy(light, near, surface.origin, surface.normal, surface.view, surface.brdf, share, place);
        if (!(seen.geometry > 0.0)) continue;
        const vec3 value = finite_or_zero(brdf_evaluate(surface.brdf, surface.normal, surface.view, seen.direction).value * seen.geometry);
        reservoir_add(reservoir, uint(i), max(value.x, max(value.y, value.z)));
        if (reservoir.chosen == uint(i)) choice = PointChoice(seen.point, seen.direction, value);
    }
    if (reservoir.chosen != NONE) choice.value *= reservoir.sum / (reservoir.chosen_importance * float(points));
    return choice;
}

/// Whether sky or sun, which the light number `id` is, can be seen in a direction.
bool environment_seen(uint id, Light light, vec3 origin, vec3 direction, uint seed) {
    Hit hit;
    if (!trace_closest(Ray(origin, 0.0, direction, 1e30), seed, hit) || !is_sky(hit)) return false;
    return is_sun(light) || sky_light(hit, origin, direction) == id;
}

/// Radiance of a chosen light towards the surface's viewer by way of a point of it that `u` draws, divided by all
/// probabilities; 0 where something is in between. `outcome` is one of LIGHT_*. With `ray_follows` the BRDF also draws a ray from the surface, which
/// collects a part of what comes from sky and sun: the rest counts here.
vec3 sampled_radiance(Surface surface, LightChoice choice, vec3 u, uint seed, bool ray_follows, out uint outcome) {
    outcome = LIGHT_UNTRIED;
    if (choice.light == NONE) return vec3(0.0);
    const Light light = load_light(choice.light);
    const PointChoice seen = choose_point(surface, light, u.xy, u.z);
    vec3 radiance = light.radiance;
    if (is_environment(light)) radiance = is_sun(light) ? frame.sun_flux : sky_box_radiance(seen.direction);
    vec3 value = finite_or_zero(seen.value * radiance * choice.weight);
    if (!(max(value.x, max(value.y, value.z)) > 0.0)) return vec3(0.0);

    bool visible;
    if (is_environment(light) && (light.flags & LIGHT_WHOLE) == 0u) {
        visible = environment_seen(choice.light, light, surface.origin, seen.direction, seed);
    } else {
        // From just above the surface to just above the light.
        const vec3 to_light = offset_ray_origin(seen.point, light_normal(light)) - surface.origin;
        const float distance = length(to_light);
        visible = !trace_occluded(Ray(surface.origin, 0.0, to_light / max(distance, 1e-20), distance), seed);
    }
    outcome = visible ? LIGHT_SEEN : LIGHT_SHADOWED;
    if (!visible) return vec3(0.0);
    if (ray_follows && is_environment(light)) {
        const float probability = PROBABILITY_IS_EXACT != 0 ? 1.0 / choice.weight : light_probability(surface, choice.light);
        const float ray_pdf = brdf_evaluate(surface.brdf, surface.normal, surface.view, seen.direction).pdf;
        value *= sampled_share(probability, environment_inverse_density(light, surface.origin, seen.direction), ray_pdf);
    }
    return value;
}

/// A number in [0, 1) that the invocations of a subgroup have in common, for each of a path's vertices (0 is the primary hit) another. What only some
/// pixels do is done by whole subgroups, so that no lanes wait; these are rows of a work group. Neighbours' numbers lie far apart, so that everywhere
/// in the picture as many do it as should. For each path they are shifted by a random number.
float subgroup_number(uint vertex) {
    Random random = path_random(uvec2(0x10000u, 0u), STREAM_DIRECT); // a stream that no pixel has
    random.dimension = vertex;
    const uvec2 subgroup = gl_GlobalInvocationID.xy / uvec2(8u, clamp(gl_SubgroupSize / 8u, 1u, 8u));
    const uvec2 steps = subgroup * R2_STEPS;
    return unit_float(random_next_words(random).x + steps.x + steps.y);
}

/// Part of the second draws that are made at the last indirect hit, but for LightChoice.least. They cost as much as at the primary hit, and what
/// they find counts by the path's throughput. Measured: docs/research/history.md. Where a ray follows, `light_probability` must know the number of
/// draws: all are made. So they are where all are wanted: without a cache, or as a light appears.
const float BESIDE_INDIRECT = 0.25;

/// `vertex` counts the path's vertices.
DirectLight next_event_estimate(Surface surface, uint vertex, bool ray_follows, inout Random random) {
    DirectLight direct = DirectLight(vec3(0.0), false, NONE);
    float beside = 0.0;
    // One turn for each draw: what a technique inlines is long.
    while (true) {
        const LightChoice choice = draw_light(surface, beside, random);
        const vec3 u = random_next3(random);
        const uint seed = random_next_words(random).x;
        uint outcome;
        direct.radiance += sampled_radiance(surface, choice, u, seed, ray_follows, outcome);
        direct.explored = direct.explored || choice.explored;
        if (direct.light == NONE) direct.light = choice.light;
        // One path per pixel teaches: what is stored is bounded by the resolution.
        if (LEARNS_FROM_LIGHT_SAMPLES != 0 && path_index == 0u) learn_light(choice, outcome);
        float wanted = choice.beside;
        if (vertex > 0u && !ray_follows && wanted < 1.0) wanted = max(wanted * BESIDE_INDIRECT, min(wanted, choice.least));
        if (DRAWS_BESIDE == 0 || beside > 0.0 || !(subgroup_number(vertex) < wanted)) break;
        beside = wanted;
    }
    return direct;
}

#endif
