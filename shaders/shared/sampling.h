// SPDX-License-Identifier: GPL-2.0-or-later
// Maps from the unit square to directions, triangles, discs and cones with their densities, the
// orthonormal basis that turns local directions into world ones, and the offset that lifts a ray
// off the surface it starts on. Every map accepts all of [0, 1)^2. No BRDF and no light lives here.
#ifndef VIGIL_SHARED_SAMPLING_H
#define VIGIL_SHARED_SAMPLING_H

#include "glsl.h"

SHADER_BEGIN

SHADER_CONST float PI = 3.14159265358979f;
SHADER_CONST float TWO_PI = 6.28318530717959f;
SHADER_CONST float INVERSE_PI = 0.318309886183791f;

/// An index below `count` > 0, each equally likely for u in [0, 1).
SHADER_FN uint draw_index(float u, uint count) { return min(uint(u * float(count)), count - 1u); }

/// A right-handed orthonormal basis: cross(tangent, bitangent) = normal.
struct Basis {
    vec3 tangent;
    vec3 bitangent;
    vec3 normal;
};

/// Basis around a unit vector, without branches or singular directions, (0, 0, -1) included.
/// Source: Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 2017.
SHADER_FN Basis make_basis(vec3 normal) {
    float s = normal.z >= 0.0f ? 1.0f : -1.0f;
    float a = -1.0f / (s + normal.z);
    float b = normal.x * normal.y * a;
    Basis basis;
    basis.tangent = vec3(1.0f + s * normal.x * normal.x * a, s * b, -s * normal.x);
    basis.bitangent = vec3(b, s + normal.y * normal.y * a, -normal.y);
    basis.normal = normal;
    return basis;
}

SHADER_FN vec3 to_world(Basis basis, vec3 local) { return local.x * basis.tangent + local.y * basis.bitangent + local.z * basis.normal; }

SHADER_FN vec3 to_local(Basis basis, vec3 world) {
    return vec3(dot(world, basis.tangent), dot(world, basis.bitangent), dot(world, basis.normal));
}

/// Uniform in the unit disc; density 1 / pi.
SHADER_FN vec2 sample_disk(vec2 u) {
    float radius = sqrt(u.x);
    float angle = TWO_PI * u.y;
    return vec2(radius * cos(angle), radius * sin(angle));
}

/// Unit vector around +z with density cos / pi per steradian. Its z is at least 2^-12, so the
/// density is never zero.
SHADER_FN vec3 sample_cosine_hemisphere(vec2 u) {
    vec2 disk = sample_disk(u);
    return vec3(disk.x, disk.y, sqrt(1.0f - u.x));
}

SHADER_FN float cosine_hemisphere_pdf(float cosine) { return max(cosine, 0.0f) * INVERSE_PI; }

/// Uniform on the sphere; density 1 / (4 pi).
SHADER_FN vec3 sample_sphere(vec2 u) {
    float z = 1.0f - 2.0f * u.x;
    float radius = 2.0f * sqrt(u.x * (1.0f - u.x));
    float angle = TWO_PI * u.y;
    return vec3(radius * cos(angle), radius * sin(angle), z);
}

/// Uniform in the cone around +z whose half angle a is given as 1 - cos(a) in (0, 2]. The sun's is
/// about 1e-5, where cos(a) itself would have lost most of its digits: use `cone_size`.
SHADER_FN vec3 sample_cone(vec2 u, float one_minus_cosine) {
    float depth = u.x * one_minus_cosine;
    float radius = sqrt(depth * (2.0f - depth));
    float angle = TWO_PI * u.y;
    return vec3(radius * cos(angle), radius * sin(angle), 1.0f - depth);
}

SHADER_FN float cone_pdf(float one_minus_cosine) { return 1.0f / (TWO_PI * one_minus_cosine); }

/// 1 - cos(half_angle), without cancellation; radians.
SHADER_FN float cone_size(float half_angle) {
    float s = sin(0.5f * half_angle);
    return 2.0f * s * s;
}

/// Whether a unit direction lies in that cone around the unit axis. Measured by the chord between
/// the two, so that it is as exact for a small cone as for a large one.
SHADER_FN bool in_cone(vec3 direction, vec3 axis, float one_minus_cosine) {
    vec3 chord = direction - axis;
    return dot(chord, chord) <= 2.0f * one_minus_cosine;
}

/// Barycentric weights of vertices 1 and 2, uniform over the triangle, density 1 / area; their sum
/// is at most 1. Source: Heitz, "A Low-Distortion Map Between Triangle and Square", 2019. Needs no
/// square root.
SHADER_FN vec2 sample_triangle(vec2 u) {
    vec2 folded = u.y > u.x ? vec2(0.5f * u.x, u.y - 0.5f * u.x) : vec2(u.x - 0.5f * u.y, 0.5f * u.y);
    return folded;
}

/// The offset below per unit of the position's largest coordinate: 8 to 16 units in the last place.
SHADER_CONST float RAY_OFFSET_SCALE = 1.0f / 524288.0f;
/// Positions near the origin are still sums of vertices far from it: count them as at least this
/// far.
SHADER_CONST float RAY_OFFSET_REACH = 1024.0f;

/// Moves a point of a surface off it, along the unit geometric normal of the side the ray leaves
/// from. A point interpolated from the triangle's vertices is off its plane by at most one unit in
/// the last place of the coordinates; the offset is 8 to 16: 0.002 at the origin, 0.008 at 4,096
/// and 0.06 at 32,768 map units, far below the thinnest walls (1 unit). A point at origin + t *
/// direction may be off by more (docs/internals/light-sampling.md).
SHADER_FN vec3 offset_ray_origin(vec3 position, vec3 normal) {
    vec3 size = abs(position);
    float reach = max(max(size.x, size.y), max(size.z, RAY_OFFSET_REACH));
    return position + (reach * RAY_OFFSET_SCALE) * normal;
}

SHADER_END
#endif
