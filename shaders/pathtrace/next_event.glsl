// SPDX-License-Identifier: GPL-2.0-or-later
// Next event estimation: one light chosen by the technique, one point on it, one shadow ray.
#ifndef VIGIL_PATHTRACE_NEXT_EVENT_GLSL
#define VIGIL_PATHTRACE_NEXT_EVENT_GLSL

#include "light/technique.glsl"

/// What one light sample adds to a surface.
struct DirectLight {
    vec3 radiance; // towards the viewer: an unbiased estimate of that of all the technique's lights
    bool explored; // see LightChoice
};

/// Radiance of a chosen light towards the surface's viewer by way of the point that `u` draws, divided by all
/// probabilities; 0 where something is in between.
vec3 sampled_radiance(Surface surface, LightChoice choice, vec2 u, uint seed) {
    if (choice.light == NONE) return vec3(0.0);
    const Light light = lights[choice.light];
    const LightSample seen = sample_light(light, surface.origin, u);
    if (!(seen.geometry > 0.0)) return vec3(0.0);
    const vec3 reflected = brdf_evaluate(surface.brdf, surface.normal, surface.view, seen.direction).value;
    const vec3 value = reflected * light.radiance * (seen.geometry / choice.probability);
    if (!(max(value.x, max(value.y, value.z)) > 0.0)) return vec3(0.0);

    // From just above the surface to just above the light.
    Ray ray;
    ray.origin = surface.origin;
    const vec3 to_light = offset_ray_origin(seen.point, light_normal(light)) - ray.origin;
    const float distance = length(to_light);
    ray.direction = to_light / max(distance, 1e-20);
    ray.t_min = 0.0;
    ray.t_max = distance;
    if (trace_occluded(ray, seed)) return vec3(0.0);
    return value;
}

DirectLight next_event_estimate(Surface surface, inout Random random) {
    const LightChoice choice = choose_light(surface, random);
    const vec2 u = random_next2(random);
    const uint seed = random_next_words(random).x;
    const vec3 value = sampled_radiance(surface, choice, u, seed);
    // One path per pixel teaches: what is stored is bounded by the resolution.
    if (LEARNS_FROM_LIGHT_SAMPLES != 0 && path_index == 0u) learn_light(choice, value != vec3(0.0));
    return DirectLight(value, choice.explored);
}

#endif
