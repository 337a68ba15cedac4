// SPDX-License-Identifier: GPL-2.0-or-later
// Triangles as seen from a point: their solid angle (Van Oosterom and Strackee 1983), and points
// drawn uniformly in it (Arvo, "Stratified Sampling of Spherical Triangles", 1995, with half angles
// instead of angles). In floats good for any triangle, from a lamp of a thousandth of its distance
// to one that fills half of all directions: nothing is computed as a difference of near numbers.
#ifndef VIGIL_SHARED_SPHERICAL_TRIANGLE_H
#define VIGIL_SHARED_SPHERICAL_TRIANGLE_H

#include "glsl.h"

SHADER_BEGIN

struct SphericalTriangle {
    vec3 a; // unit vectors to the corners
    vec3 b;
    vec3 c;
    vec3 nearness;     // 1 / distance of the corners, up to a common factor
    float volume;      // |a . (b x c)|
    float solid_angle; // in [0, 2 pi]
};

/// The triangle with a corner at the offset `a` from the point and edges `e1` and `e2` from there.
/// No corner may be the point itself.
SHADER_FN SphericalTriangle spherical_triangle(vec3 a, vec3 e1, vec3 e2) {
    SphericalTriangle triangle;
    const vec3 b = a + e1;
    const vec3 c = a + e2;
    triangle.nearness = vec3(inversesqrt(dot(a, a)), inversesqrt(dot(b, b)), inversesqrt(dot(c, c)));
    triangle.a = a * triangle.nearness.x;
    triangle.b = b * triangle.nearness.y;
    triangle.c = c * triangle.nearness.z;
    // a . (b x c) = a . (e1 x e2): the edges of a small triangle have their digits, differences of
    // its unit vectors do not.
    triangle.volume = abs(dot(cross(e1, e2), triangle.a)) * triangle.nearness.y * triangle.nearness.z;
    triangle.solid_angle =
        2.0f * atan(triangle.volume, 1.0f + dot(triangle.a, triangle.b) + dot(triangle.b, triangle.c) + dot(triangle.c, triangle.a));
    return triangle;
}

/// A point of the triangle, uniform in its solid angle, as weights of e1 and e2: at least 0, with a
/// sum of at most 1 but for rounding. `u` in [0, 1)^2.
SHADER_FN vec2 sample_spherical_triangle(SphericalTriangle triangle, vec2 u) {
    // An edge from b cuts off the part u.x of the area: it ends at a point between a and c. Halfway
    // from a to there lies a + y c. In the formula of the solid angle of (a, b, end), with `end`
    // written as the reflection of a at that half, everything is linear in a and c.
    const float ac = dot(triangle.a, triangle.c);
    const float half_area = 0.5f * u.x * triangle.solid_angle;
    const float x = triangle.volume * cos(half_area) - (ac + dot(triangle.b, triangle.c)) * sin(half_area);
    const float share = (1.0f + dot(triangle.a, triangle.b)) * sin(half_area);
    // Only the ratio counts, which is 1 where the whole area is cut off.
    const float y = x > share ? max(share / x, 0.0f) : 1.0f;
    const float squared = max(1.0f + y * (2.0f * ac + y), 1e-12f);
    const float end_a = (1.0f - y) * (1.0f + y) / squared;
    const float end_c = 2.0f * y * max(1.0f + y * ac, 0.0f) / squared;

    // A point on that edge: its cosine with b is uniform between 1 and that of the end.
    const float cosine = clamp(end_a * dot(triangle.a, triangle.b) + end_c * dot(triangle.b, triangle.c), -1.0f, 1.0f);
    const float z = 1.0f - u.y * (1.0f - cosine);
    const float t = sqrt(u.y * (1.0f + z) / max(1.0f + cosine, 1e-12f));

    // From weights of unit vectors to weights of corners.
    const vec3 weights = vec3(t * end_a, max(z - t * cosine, 0.0f), t * end_c) * triangle.nearness;
    return vec2(weights.y, weights.z) / max(weights.x + weights.y + weights.z, 1e-37f);
}

SHADER_END
#endif
