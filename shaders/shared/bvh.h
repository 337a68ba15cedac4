// SPDX-License-Identifier: GPL-2.0-or-later
// Ray against box and triangle, and the node format of the hierarchy that the compute backend
// walks. The triangle test is Moeller and Trumbore's (1997), the box test the slab method with
// Ize's (2013) error margin. Buffers and the traversal loop are not here: see
// trace/bvh_traverse.glsl.
#ifndef VIGIL_SHARED_BVH_H
#define VIGIL_SHARED_BVH_H

#include "glsl.h"
#include "scene_types.h"

SHADER_BEGIN

struct Ray {
    vec3 origin;
    float t_min;
    vec3 direction; // any length; t counts in its lengths
    float t_max;
};

struct Hit {
    float t;
    uint primitive;    // index in BvhTriangle[] and Primitive[]
    uint instance;     // index in Instance[]
    vec2 barycentrics; // weights of v1 and v2
    bool front;        // met from the side cross(e1, e2) points to
};

/// A node is four uvec4: the boxes of its two children and one reference to each.
///   0: lower_0.xyz, reference_0   1: upper_0.xyz, reference_1   2: lower_1.xyz   3: upper_1.xyz
/// An absent child has an inverted box.
SHADER_CONST uint BVH_NODE_WORDS = 4u;

/// A reference is a node index, or a leaf: bit 31, then (triangle count - 1) in 4 bits, then the
/// first triangle.
SHADER_CONST uint BVH_LEAF = 0x80000000u;
SHADER_CONST uint BVH_LEAF_COUNT_SHIFT = 27u;
SHADER_CONST uint BVH_LEAF_COUNT_MASK = 15u;
SHADER_CONST uint BVH_LEAF_FIRST_MASK = 0x07ffffffu;

/// The builder keeps every path from the root shorter than this.
SHADER_CONST uint BVH_MAX_DEPTH = 64u;

/// A node of the top level, in depth-first order. When the ray enters an inner node's box the next
/// node to visit is the following one, otherwise `skip`. Leaves hold all that is needed to walk the
/// instance.
struct TopNode {
    vec3 lower; // world space
    uint skip;  // next node when this one is missed or done, or TOP_END
    vec3 upper;
    uint instance; // index in Instance[], or NONE in inner nodes
    mat4x3 object_from_world;
    uint root; // node index in the bottom-level buffer
};

SHADER_CONST uint TOP_END = 0xffffffffu;

/// Reciprocal of one component of a direction. Components below 1e-20 are clamped to it with their
/// sign, so that products with finite distances are never NaN: the ray then misses the slab it runs
/// outside of and stays inside the other for every t that matters.
SHADER_FN float bvh_reciprocal(float d) {
    if (abs(d) < 1e-20f) return d < 0.0f ? -1e20f : 1e20f;
    return 1.0f / d;
}

SHADER_FN vec3 bvh_reciprocal3(vec3 d) {
    return vec3(bvh_reciprocal(d.x), bvh_reciprocal(d.y), bvh_reciprocal(d.z));
}

/// Ize's margin: makes the slab test conservative under rounding of its three operations.
SHADER_CONST float BVH_BOX_MARGIN = 1.0000005f;

/// Entry distance into the box, or 3e38 when the ray misses it within (t_min, t_max). `inverse` as
/// from bvh_reciprocal3.
SHADER_FN float bvh_box_entry(vec3 lower, vec3 upper, vec3 origin, vec3 inverse, float t_min,
                              float t_max) {
    vec3 t_lower = (lower - origin) * inverse;
    vec3 t_upper = (upper - origin) * inverse;
    vec3 near3 = min(t_lower, t_upper);
    vec3 far3 = max(t_lower, t_upper);
    float t_near = max(max(near3.x, near3.y), max(near3.z, t_min));
    float t_far = min(min(far3.x, far3.y), min(far3.z, t_max)) * BVH_BOX_MARGIN;
    return t_near <= t_far && lower.x <= upper.x ? t_near : 3e38f;
}

/// Ray against triangle. On a hit t lies in (t_min, t_max), u and v are the weights of v1 and v2,
/// and `front` tells that the ray meets the side cross(e1, e2) points to. Zero-area triangles are
/// never hit. u and v may leave [0, 1] by 1e-5 so that rays along a shared edge do not slip
/// through.
SHADER_FN bool bvh_triangle_hit(vec3 v0, vec3 e1, vec3 e2, vec3 origin, vec3 direction, float t_min,
                                float t_max, OUT(float) t, OUT(float) u, OUT(float) v,
                                OUT(bool) front) {
    vec3 p = cross(direction, e2);
    float determinant = dot(e1, p);
    float inverse = 1.0f / determinant;
    vec3 s = origin - v0;
    u = dot(s, p) * inverse;
    vec3 q = cross(s, e1);
    v = dot(direction, q) * inverse;
    t = dot(e2, q) * inverse;
    front = determinant > 0.0f;
    return determinant != 0.0f && u >= -1e-5f && v >= -1e-5f && u + v <= 1.00001f && t > t_min &&
           t < t_max;
}

/// The coverage test's random number in 0..254, a hash of what identifies the crossing (the mixer
/// is Wellons' lowbias32). Equal for every backend and every traversal order.
SHADER_FN uint bvh_coverage_hash(uint seed, uint instance, uint primitive) {
    uint x = seed ^ (primitive * 0x9e3779b9u) ^ (instance * 0x85ebca6bu);
    x ^= x >> 16;
    x *= 0x7feb352du;
    x ^= x >> 15;
    x *= 0x846ca68bu;
    x ^= x >> 16;
    return uint((x >> 8) % 255u);
}

/// Whether a triangle with these flags stops the ray here. Opaque: always. Translucent: only seen
/// from its front, and with probability coverage / 255.
SHADER_FN bool bvh_covered(uint flags, bool front, uint seed, uint instance, uint primitive) {
    uint coverage = flags & TRIANGLE_COVERAGE_MASK;
    if (coverage == 255u) return true;
    return front && bvh_coverage_hash(seed, instance, primitive) < coverage;
}

SHADER_END
#endif
