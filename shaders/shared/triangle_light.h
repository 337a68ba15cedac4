// SPDX-License-Identifier: GPL-2.0-or-later
// Sampling a triangular emitter uniformly by area, as seen from a point. One sign decides whether a
// light faces the point (`light_facing`), and light selection (ltc.h) asks the same function, so
// that no light is drawn which cannot contribute, and none that can is left out. Visibility is the
// caller's.
#ifndef VIGIL_SHARED_TRIANGLE_LIGHT_H
#define VIGIL_SHARED_TRIANGLE_LIGHT_H

#include "glsl.h"
#include "sampling.h"
#include "scene_types.h"

SHADER_BEGIN

/// A point on a light as seen from a shading point.
struct LightSample {
    vec3 point;     // on the light
    vec3 direction; // unit, from the shading point to `point`
    float distance; // map units
    float geometry; // area * cos(light) / distance^2: what a sample is worth, 1 / pdf; 0 if it is
                    // worth nothing
    float pdf;      // per steradian; 0 if the light faces away, is seen edge-on, or has no area
};

/// Twice the area times the distance of `position` in front of the light's plane (units^3).
/// Positive on the lit side; 0 for lights without area and points exactly in the plane.
SHADER_FN float light_facing(Light light, vec3 position) {
    return dot(cross(light.e1, light.e2), position - light.v0);
}

/// Area in square units.
SHADER_FN float light_area(Light light) {
    return 0.5f * length(cross(light.e1, light.e2));
}

/// Unit normal of the lit side; (0, 0, 0) if the light has no area.
SHADER_FN vec3 light_normal(Light light) {
    // Scaled to its largest component first, so that squares neither vanish nor overflow.
    vec3 n = cross(light.e1, light.e2);
    float largest = max(abs(n.x), max(abs(n.y), abs(n.z)));
    if (!(largest > 0.0f)) return vec3(0.0f);
    return normalize(n / largest);
}

/// How a point of the light is seen from `position`, with the density that area sampling gives it.
SHADER_FN LightSample see_light_point(Light light, vec3 position, vec3 point) {
    LightSample seen;
    seen.point = point;
    vec3 offset = point - position;
    float squared = max(dot(offset, offset), 1e-30f);
    float inverse = inversesqrt(squared);
    seen.distance = squared * inverse;
    seen.direction = offset * inverse;
    // area * cos(light) / d^2 = (|N| / 2) * (facing / (|N| d)) / d^2: the normal's length cancels,
    // slivers are exact.
    float facing = light_facing(light, position);
    seen.geometry = facing > 0.0f ? 0.5f * facing * inverse * inverse * inverse : 0.0f;
    seen.pdf = seen.geometry > 1e-37f ? 1.0f / seen.geometry : 0.0f;
    if (!(seen.pdf > 0.0f)) seen.geometry = 0.0f;
    return seen;
}

/// Draws a point uniformly on the light. Radiance leaving `position` towards the viewer through
/// this sample is light.radiance * (BRDF * cosine) * geometry / (chance of choosing this light), if
/// the point is visible.
SHADER_FN LightSample sample_light(Light light, vec3 position, vec2 u) {
    vec2 weights = sample_triangle(u);
    return see_light_point(light, position, light.v0 + weights.x * light.e1 + weights.y * light.e2);
}

/// Density per steradian with which `sample_light` draws `point`; 0 where it never does.
SHADER_FN float light_pdf(Light light, vec3 position, vec3 point) {
    return see_light_point(light, position, point).pdf;
}

SHADER_END
#endif
