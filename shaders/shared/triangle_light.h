// SPDX-License-Identifier: GPL-2.0-or-later
// Sampling a triangular emitter as seen from a point: uniformly by area, or, where it is so near
// that its points differ much in what they are worth, uniformly by solid angle. (The paper samples
// by area always. Near a lamp that has no finite variance: whatever chooses the lights, a few
// samples then decide the error of a picture.) One sign decides whether a light faces the point
// (`light_facing`), and light selection (ltc.h) asks the same function, so that no light is drawn
// which cannot contribute, and none that can is left out. Visibility is the caller's.
#ifndef VIGIL_SHARED_TRIANGLE_LIGHT_H
#define VIGIL_SHARED_TRIANGLE_LIGHT_H

#include "glsl.h"
#include "sampling.h"
#include "scene_types.h"
#include "spherical_triangle.h"

SHADER_BEGIN

/// The light as a triangle in the world when seen from `position`: the sun goes where its viewer
/// goes.
SHADER_FN Light light_from(Light light, vec3 position) {
    if ((light.flags & LIGHT_SUN) != 0u) light.v0 += position;
    return light;
}

/// A point on a light as seen from a shading point.
struct LightSample {
    vec3 point;     // on the light
    vec3 direction; // unit, from the shading point to `point`
    float distance; // map units
    float geometry; // area * cos(light) / distance^2: 1 / pdf of a sample; 0 if it
                    // contributes nothing
    float pdf;      // per steradian; 0 if the light faces away, is seen edge-on, or has no area
};

/// Twice the area times the distance of `position` in front of the light's plane (units^3).
/// Positive on the lit side; 0 for lights without area and points exactly in the plane.
SHADER_FN float light_facing(Light light, vec3 position) { return dot(cross(light.e1, light.e2), position - light.v0); }

/// Area in square units.
SHADER_FN float light_area(Light light) { return 0.5f * length(cross(light.e1, light.e2)); }

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

/// Solid angle of the light's lit side in steradian, in [0, 2 pi); 0 where it faces away. The
/// relative error is below 16 max(k, 1) 2^-24, where k says how the triangle conditions the formula
/// (tests/numerics/lights_test.cpp): 1 for small and large lights of ordinary shape, more for needles
/// and for lights seen along their plane.
SHADER_FN float light_solid_angle(Light light, vec3 position) {
    const float facing = light_facing(light, position);
    if (!(facing > 0.0f)) return 0.0f;
    const vec3 a = light.v0 - position;
    const vec3 b = a + light.e1;
    const vec3 c = a + light.e2;
    const vec3 inverse = vec3(inversesqrt(dot(a, a)), inversesqrt(dot(b, b)), inversesqrt(dot(c, c)));
    const float volume = facing * inverse.x * inverse.y * inverse.z;
    const float angle = 2.0f * atan(volume, 1.0f + dot(a, b) * (inverse.x * inverse.y) + dot(b, c) * (inverse.y * inverse.z) +
                                                dot(c, a) * (inverse.z * inverse.x));
    return angle > 0.0f ? angle : 0.0f; // also for NaN: at a corner
}

/// How dense points are drawn on a light: the choices of pt_light_density, in their order.
SHADER_CONST int LIGHT_DENSITY_AUTO = 0;        // by solid angle where the light is near, else by area
SHADER_CONST int LIGHT_DENSITY_AREA = 1;        // evenly over its area: the paper
SHADER_CONST int LIGHT_DENSITY_SOLID_ANGLE = 2; // evenly over what is seen of it: Quake II RTX

/// Below this solid angle (steradian) `auto` samples a light by area.
SHADER_CONST float LIGHT_NEAR_SOLID_ANGLE = 0.02f;

/// The light as a spherical triangle if it is sampled by solid angle; otherwise its solid_angle is
/// 0.
SHADER_FN SphericalTriangle near_light(Light light, vec3 position, int density) {
    SphericalTriangle seen;
    seen.solid_angle = 0.0f;
    if (density == LIGHT_DENSITY_AREA) return seen;
    // A light of less than half its distance in size is far, without a closer look.
    const vec3 a = light.v0 - position;
    const bool always = density == LIGHT_DENSITY_SOLID_ANGLE;
    if (!always && 4.0f * (dot(light.e1, light.e1) + dot(light.e2, light.e2)) < dot(a, a)) return seen;
    const vec3 b = a + light.e1;
    const vec3 c = a + light.e2;
    if (!(light_facing(light, position) > 0.0f) || !(dot(a, a) > 0.0f) || !(dot(b, b) > 0.0f) || !(dot(c, c) > 0.0f)) return seen;
    seen = spherical_triangle(a, light.e1, light.e2);
    // Whose density is beyond all floats is left to its area, which says the same.
    if (!(seen.solid_angle > (always ? 1e-37f : LIGHT_NEAR_SOLID_ANGLE))) seen.solid_angle = 0.0f;
    return seen;
}

SHADER_FN SphericalTriangle near_light(Light light, vec3 position) { return near_light(light, position, LIGHT_DENSITY_AUTO); }

/// Where a line meets the light's plane, as weights of e1 and e2; not finite along the plane.
SHADER_FN vec2 light_plane_point(Light light, vec3 position, vec3 direction) {
    const vec3 across = cross(direction, light.e2);
    const vec3 offset = position - light.v0;
    return vec2(dot(offset, across), dot(direction, cross(offset, light.e1))) / dot(light.e1, across);
}

/// Draws a point on the light; `near` is near_light's. Radiance leaving `position` towards the
/// viewer through this sample is light.radiance * (BRDF * cosine) * geometry / (chance of choosing
/// this light), if the point is visible.
SHADER_FN LightSample sample_light(Light light, SphericalTriangle near, vec3 position, vec2 u) {
    vec2 weights;
    if (near.solid_angle > 0.0f) weights = sample_spherical_triangle(near, u);
    else weights = sample_triangle(u);
    LightSample seen = see_light_point(light, position, light.v0 + weights.x * light.e1 + weights.y * light.e2);
    if (near.solid_angle > 0.0f) {
        seen.geometry = near.solid_angle;
        seen.pdf = 1.0f / near.solid_angle;
    }
    return seen;
}

SHADER_FN LightSample sample_light(Light light, vec3 position, vec2 u) {
    return sample_light(light, near_light(light, position), position, u);
}

/// Density per steradian with which `sample_light` draws `point`; 0 where it never does.
SHADER_FN float light_pdf(Light light, SphericalTriangle near, vec3 position, vec3 point) {
    return near.solid_angle > 0.0f ? 1.0f / near.solid_angle : see_light_point(light, position, point).pdf;
}

SHADER_FN float light_pdf(Light light, vec3 position, vec3 point) { return light_pdf(light, near_light(light, position), position, point); }

SHADER_END
#endif
