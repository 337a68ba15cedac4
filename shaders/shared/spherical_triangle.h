// SPDX-License-Identifier: GPL-2.0-or-later
// Triangles as seen from a point: their solid angle (Van Oosterom and Strackee 1983), and
// directions drawn uniformly in it (Arvo, "Stratified Sampling of Spherical Triangles", 1995). In
// floats, good from about 0.01 steradian on: smaller ones are better sampled by area.
#ifndef VIGIL_SHARED_SPHERICAL_TRIANGLE_H
#define VIGIL_SHARED_SPHERICAL_TRIANGLE_H

#include "glsl.h"

SHADER_BEGIN

/// Unit vectors to the corners, counter-clockwise around the triangle's inside or clockwise.
struct SphericalTriangle {
    vec3 a;
    vec3 b;
    vec3 c;
    float volume;      // |a . (b x c)|
    float solid_angle; // in [0, 2 pi]
};

/// Offsets from the point to the corners, none of them zero.
SHADER_FN SphericalTriangle spherical_triangle(vec3 a, vec3 b, vec3 c) {
    SphericalTriangle triangle;
    triangle.a = normalize(a);
    triangle.b = normalize(b);
    triangle.c = normalize(c);
    triangle.volume = abs(dot(triangle.a, cross(triangle.b, triangle.c)));
    triangle.solid_angle =
        2.0f * atan(triangle.volume, 1.0f + dot(triangle.a, triangle.b) +
                                         dot(triangle.b, triangle.c) + dot(triangle.c, triangle.a));
    return triangle;
}

/// Unit vector perpendicular to `axis` (unit), on the side of `towards`.
SHADER_FN vec3 perpendicular(vec3 axis, vec3 towards) {
    const vec3 across = towards - dot(towards, axis) * axis;
    return across * inversesqrt(max(dot(across, across), 1e-30f));
}

/// A direction inside the triangle; `u` in [0, 1)^2.
SHADER_FN vec3 sample_spherical_triangle(SphericalTriangle triangle, vec2 u) {
    // The angle at a, between the planes of its two edges.
    const vec3 ab = cross(triangle.a, triangle.b);
    const vec3 ac = cross(triangle.a, triangle.c);
    const float scale = inversesqrt(max(dot(ab, ab) * dot(ac, ac), 1e-30f));
    const float cos_alpha = clamp(dot(ab, ac) * scale, -1.0f, 1.0f);
    const float sin_alpha = triangle.volume * scale;

    // The edge from b that cuts off the part u.x of the area: it ends between a and c.
    const float area = u.x * triangle.solid_angle;
    const float s = sin(area) * cos_alpha - cos(area) * sin_alpha;
    const float t = cos(area) * cos_alpha + sin(area) * sin_alpha;
    const float p = t - cos_alpha;
    const float q = s + sin_alpha * dot(triangle.a, triangle.b);
    const float divisor = (q * s + p * t) * sin_alpha;
    const float cos_end = abs(divisor) > 1e-20f
                              ? clamp(((q * t - p * s) * cos_alpha - q) / divisor, -1.0f, 1.0f)
                              : 1.0f;
    const vec3 end = cos_end * triangle.a + sqrt(max(1.0f - cos_end * cos_end, 0.0f)) *
                                                perpendicular(triangle.a, triangle.c);

    // A point on that edge.
    const float z = 1.0f - u.y * (1.0f - dot(end, triangle.b));
    return z * triangle.b + sqrt(max(1.0f - z * z, 0.0f)) * perpendicular(triangle.b, end);
}

SHADER_END
#endif
