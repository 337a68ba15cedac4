// SPDX-License-Identifier: GPL-2.0-or-later
// Ray against boxes and triangles, and the node format of the hierarchy that the compute backend
// walks: four children to a node with 16-bit boxes (after Ylitie et al. 2017) and leaves of two
// triangles with a common edge, tested as by Moeller and Trumbore (1997). Buffers and the traversal
// loop are not here: see trace/bvh_traverse.glsl.
#ifndef VIGIL_SHARED_BVH_H
#define VIGIL_SHARED_BVH_H

#include "glsl.h"
#include "scene_types.h"

SHADER_BEGIN

struct Ray {
    vec3 origin;
    float t_min;    // at least 0
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

/// A node is four records, its children; a record is four uvec4 (64 bytes, a cache line). The root
/// of a hierarchy is record 0 of its first node, whose other records are empty. Inner record: boxes
/// of the four children on a grid of `origin + step * [0, 65535]`.
///   0: x, 1: y, 2: z of the children's boxes, lower in bits 0..15, upper in bits 16..31
///   3: origin.xyz as floats; bits 0..22 the children's node, bits 23..30 the exponent of step
/// Leaf record: triangles (v0, v1, v2) and (v0, v2, v3); a lone one has v3 = v2, an empty leaf
/// none.
///   0: v0, v3.x  1: v1, v3.y  2: v2, v3.z  3: first primitive, flags, unused, BVH_LEAF
/// Flags: coverage of the first and the second triangle in bits 0..7 and 8..15; which of the
/// original triangle's vertices is v0 in bits 16..17 and 18..19.
SHADER_CONST uint BVH_NODE_WORDS = 16u;
SHADER_CONST uint BVH_RECORD_WORDS = 4u;
SHADER_CONST uint BVH_LEAF = 0x80000000u;
SHADER_CONST uint BVH_CHILD_NODE_MASK = 0x007fffffu;
SHADER_CONST uint BVH_STEP_MASK = 0x7f800000u;

/// Inner records on a path from the root, at most: the builder keeps it, the stack relies on it.
SHADER_CONST uint BVH_MAX_DEPTH = 32u;

/// A node of the top level, in depth-first order. When the ray enters an inner node's box the next
/// node to visit is the following one, otherwise `skip`. Leaves hold all that is needed to walk the
/// instance.
struct TopNode {
    vec3 lower; // world space
    uint skip;  // next node when this one is missed or done, or TOP_END
    vec3 upper;
    uint instance; // index in Instance[], or NONE in inner nodes
    mat4x3 object_from_world;
    uint root;  // node index in the bottom-level buffer
    uint flags; // the instance's: INSTANCE_*
    SHADER_PADDING(2)
};
SHADER_CONST int TOP_NODE_TEXELS = 6;

SHADER_CONST uint TOP_END = 0xffffffffu;

/// Farther than any hit.
SHADER_CONST float BVH_MISS = 3e38f;

/// Reciprocal of one component of a direction. Components below 1e-20 are clamped to it with their
/// sign, so that products with finite distances are never NaN: the ray then misses the slab it runs
/// outside of and stays inside the other for every t that matters.
SHADER_FN float bvh_reciprocal(float d) {
    if (abs(d) < 1e-20f) return d < 0.0f ? -1e20f : 1e20f;
    return 1.0f / d;
}

SHADER_FN vec3 bvh_reciprocal3(vec3 d) { return vec3(bvh_reciprocal(d.x), bvh_reciprocal(d.y), bvh_reciprocal(d.z)); }

/// Ize's (2013) margin: makes the slab test conservative under rounding of its three operations.
SHADER_CONST float BVH_BOX_MARGIN = 1.0000005f;

/// Entry distance into the box, or BVH_MISS when the ray misses it within (t_min, t_max). `inverse`
/// as from bvh_reciprocal3. Inverted boxes are missed.
SHADER_FN float bvh_box_entry(vec3 lower, vec3 upper, vec3 origin, vec3 inverse, float t_min, float t_max) {
    vec3 t_lower = (lower - origin) * inverse;
    vec3 t_upper = (upper - origin) * inverse;
    vec3 near3 = min(t_lower, t_upper);
    vec3 far3 = max(t_lower, t_upper);
    float t_near = max(max(near3.x, near3.y), max(near3.z, t_min));
    float t_far = min(min(far3.x, far3.y), min(far3.z, t_max)) * BVH_BOX_MARGIN;
    return t_near <= t_far && lower.x <= upper.x ? t_near : BVH_MISS;
}

/// "No child" in bvh_sorted_children.
SHADER_CONST uint BVH_NO_CHILD = 0xffffffffu;

/// Tests the ray against the children of an inner record (its four uvec4). Returns the children it
/// enters within [t_min, t_max], then BVH_NO_CHILD: the child's number in bits 0..1, above it the
/// distance when sorted `by_distance`, else zero, which keeps the builder's order, largest first.
/// Distances are compared as integers: that is the order of floats that are not negative, and
/// negative ones count as less than t_min >= 0 in any order (float minima that get NaN right cost
/// three times as much on a CPU). 8 steps of the last place make up for rounding relative to t;
/// rounding relative to the box is in the builder's padding.
SHADER_FN uvec4 bvh_sorted_children(uvec4 x, uvec4 y, uvec4 z, uvec4 meta, vec3 origin, vec3 inverse, float t_min, float t_max,
                                    bool by_distance) {
    vec3 grid_origin = uintBitsToFloat(uvec3(meta.x, meta.y, meta.z));
    vec3 step = uintBitsToFloat(meta.w & BVH_STEP_MASK) * inverse;
    vec3 start = (grid_origin - origin) * inverse;
    ivec4 x0 = floatBitsToInt(vec4(x & 0xffffu) * step.x + start.x);
    ivec4 x1 = floatBitsToInt(vec4(x >> 16u) * step.x + start.x);
    ivec4 y0 = floatBitsToInt(vec4(y & 0xffffu) * step.y + start.y);
    ivec4 y1 = floatBitsToInt(vec4(y >> 16u) * step.y + start.y);
    ivec4 z0 = floatBitsToInt(vec4(z & 0xffffu) * step.z + start.z);
    ivec4 z1 = floatBitsToInt(vec4(z >> 16u) * step.z + start.z);
    ivec4 entry = max(max(min(x0, x1), min(y0, y1)), max(min(z0, z1), ivec4(floatBitsToInt(t_min))));
    ivec4 leave = min(min(max(x0, x1), max(y0, y1)), min(max(z0, z1), ivec4(floatBitsToInt(t_max)))) + 8;
    uvec4 key = uvec4(0u, 1u, 2u, 3u);
    if (by_distance) key |= uvec4(entry) & 0xfffffffcu;
    key = mix(uvec4(BVH_NO_CHILD), key, lessThanEqual(entry, leave));
    // Sorting network for four.
    uint low_a = min(key.x, key.y);
    uint high_a = max(key.x, key.y);
    uint low_b = min(key.z, key.w);
    uint high_b = max(key.z, key.w);
    uint middle_a = max(low_a, low_b);
    uint middle_b = min(high_a, high_b);
    return uvec4(min(low_a, low_b), min(middle_a, middle_b), max(middle_a, middle_b), max(high_a, high_b));
}

/// Barycentrics may leave [0, 1] by this much, so that rays along a common edge do not slip
/// through.
SHADER_CONST float BVH_EDGE_MARGIN = 1e-5f;

/// Ray against triangle. On a hit t lies in (t_min, t_max), u and v are the weights of v1 and v2,
/// and `front` tells that the ray meets the side cross(e1, e2) points to. Zero-area triangles are
/// never hit.
SHADER_FN bool bvh_triangle_hit(vec3 v0, vec3 e1, vec3 e2, vec3 origin, vec3 direction, float t_min, float t_max, OUT(float) t,
                                OUT(float) u, OUT(float) v, OUT(bool) front) {
    vec3 p = cross(direction, e2);
    float determinant = dot(e1, p);
    float inverse = 1.0f / determinant;
    vec3 s = origin - v0;
    u = dot(s, p) * inverse;
    vec3 q = cross(s, e1);
    v = dot(direction, q) * inverse;
    t = dot(e2, q) * inverse;
    front = determinant > 0.0f;
    return determinant != 0.0f && u >= -BVH_EDGE_MARGIN && v >= -BVH_EDGE_MARGIN && u + v <= 1.0f + BVH_EDGE_MARGIN && t > t_min &&
           t < t_max;
}

/// The two triangles of a leaf record met by a ray.
struct BvhPairHit {
    vec2 t;              // of the first and the second; BVH_MISS where missed
    vec4 barycentrics;   // weights of v1, v2 in the first and of v2, v3 in the second
    bool front_of_first; // as Hit::front
    bool front_of_second;
};

/// Ray against both triangles of a leaf record, as bvh_triangle_hit. Their common edge saves half
/// of the second.
SHADER_FN BvhPairHit bvh_pair_hit(uvec4 a, uvec4 b, uvec4 c, vec3 origin, vec3 direction, float t_min, float t_max) {
    vec3 v0 = uintBitsToFloat(uvec3(a.x, a.y, a.z));
    vec3 e1 = uintBitsToFloat(uvec3(b.x, b.y, b.z)) - v0;
    vec3 e2 = uintBitsToFloat(uvec3(c.x, c.y, c.z)) - v0;
    vec3 e3 = uintBitsToFloat(uvec3(a.w, b.w, c.w)) - v0;
    vec3 s = origin - v0;
    vec3 p = cross(direction, e2);
    vec3 q = cross(s, e2);
    vec3 r = cross(s, direction);
    float determinant_1 = dot(e1, p);
    float determinant_2 = -dot(e3, p);
    float inverse_1 = 1.0f / determinant_1;
    float inverse_2 = 1.0f / determinant_2;
    float side = dot(s, p); // which side of the common edge
    float u_1 = side * inverse_1;
    float v_1 = -dot(e1, r) * inverse_1;
    float t_1 = -dot(e1, q) * inverse_1;
    float u_2 = dot(e3, r) * inverse_2;
    float v_2 = -side * inverse_2;
    float t_2 = dot(e3, q) * inverse_2;
    bool hit_1 = determinant_1 != 0.0f && u_1 >= -BVH_EDGE_MARGIN && v_1 >= -BVH_EDGE_MARGIN && u_1 + v_1 <= 1.0f + BVH_EDGE_MARGIN &&
                 t_1 > t_min && t_1 < t_max;
    bool hit_2 = determinant_2 != 0.0f && u_2 >= -BVH_EDGE_MARGIN && v_2 >= -BVH_EDGE_MARGIN && u_2 + v_2 <= 1.0f + BVH_EDGE_MARGIN &&
                 t_2 > t_min && t_2 < t_max;
    BvhPairHit hit;
    hit.t = vec2(hit_1 ? t_1 : BVH_MISS, hit_2 ? t_2 : BVH_MISS);
    hit.barycentrics = vec4(u_1, v_1, u_2, v_2);
    hit.front_of_first = determinant_1 > 0.0f;
    hit.front_of_second = determinant_2 > 0.0f;
    return hit;
}

/// Weights of the original triangle's v1 and v2, from those of the record's second and third
/// vertex; `rotation` as in the leaf flags (record vertex k is original vertex (k + rotation) % 3).
SHADER_FN vec2 bvh_unrotate(vec2 weights, uint rotation) {
    float rest = 1.0f - weights.x - weights.y;
    return rotation == 0u ? weights : rotation == 1u ? vec2(rest, weights.x) : vec2(weights.y, rest);
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

/// In place of a seed: whatever covers anything stops the ray.
SHADER_CONST uint BVH_STOP_AT_ALL = 0xffffffffu;

/// Whether a triangle with these flags stops the ray here. Opaque: always. Translucent: only seen
/// from its front, and with probability coverage / 255.
SHADER_FN bool bvh_covered(uint flags, bool front, uint seed, uint instance, uint primitive) {
    uint coverage = flags & TRIANGLE_COVERAGE_MASK;
    if (coverage == 255u) return true;
    if (seed == BVH_STOP_AT_ALL) return front && coverage > 0u;
    return front && bvh_coverage_hash(seed, instance, primitive) < coverage;
}

/// A triangle's flags where its instance has this opacity (0..255).
SHADER_FN uint bvh_faded(uint flags, uint opacity) {
    if (opacity == 255u) return flags;
    return ((flags & TRIANGLE_COVERAGE_MASK) * opacity + 127u) / 255u;
}

/// Opacity of an instance with these flags, 0..255.
SHADER_FN uint bvh_opacity(uint instance_flags) { return (instance_flags >> INSTANCE_OPACITY_SHIFT) & 0xffu; }

SHADER_END
#endif
