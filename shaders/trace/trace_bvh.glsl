// SPDX-License-Identifier: GPL-2.0-or-later
// The compute backend: the static world first, then the top level over the other instances, which
// is threaded (each node knows where to go on when its box is missed) and so needs no stack.
// Formats are in shared/bvh.h; include trace.glsl, not this.
#ifndef VIGIL_TRACE_BVH_GLSL
#define VIGIL_TRACE_BVH_GLSL

// With TRACE_TEXEL=0, the default, the nodes are a storage buffer, else records (records.glsl) of the same bytes. Which is faster on lavapipe
// depends on its version: docs/internals/tracing.md.
#ifndef TRACE_TEXEL
#define TRACE_TEXEL 0
#endif
#if TRACE_TEXEL
layout(set = SET_SCENE, binding = BINDING_BVH_NODES) uniform utextureBuffer bvh_nodes;

uvec4 bvh_load_node(uint word) { return texelFetch(bvh_nodes, int(word)); }
#else
layout(set = SET_SCENE, binding = BINDING_BVH_NODES, scalar) restrict readonly buffer BvhNodes { uvec4 bvh_nodes[]; };

uvec4 bvh_load_node(uint word) { return bvh_nodes[word]; }
#endif
layout(set = SET_SCENE, binding = BINDING_TOP_NODES) uniform utextureBuffer top_nodes; // TopNode[]

#include "bvh_traverse.glsl"

bool trace_backend(Ray ray, uint seed, uint mask, bool any_hit, out Hit hit) {
    hit = Hit(ray.t_max, NONE, NONE, vec2(0.0), false);
    if (!HAS_INSTANCES) {
        return bvh_traverse(0u, ray, seed, 0u, any_hit, HAS_TRANSLUCENT, 255u, hit);
    }
    // One loop over "the next hierarchy to walk", so that the walk is compiled once: first the
    // world, then whatever the top level finds.
    vec3 inverse = bvh_reciprocal3(ray.direction);
    Ray local = ray;
    uint root = 0u;
    uint instance = 0u;
    uint flags = INSTANCE_PLAIN;
    uint next = 0u;
    bool found = false;
    while (true) {
        const uint opacity = HAS_EFFECTS ? bvh_opacity(flags) : 255u;
        if ((!HAS_EFFECTS || (flags & mask) != 0u) && bvh_traverse(root, local, seed, instance, any_hit, HAS_TRANSLUCENT, opacity, hit)) {
            found = true;
            if (any_hit) return true;
        }
        // Find the next instance whose box the ray enters before the nearest hit so far.
        bool leaf = false;
        while (!leaf && next != TOP_END) {
            const int at = int(next) * TOP_NODE_TEXELS;
            const uvec4 lower = texelFetch(top_nodes, at), upper = texelFetch(top_nodes, at + 1);
            bool enters =
                bvh_box_entry(uintBitsToFloat(lower.xyz), uintBitsToFloat(upper.xyz), ray.origin, inverse, ray.t_min, hit.t) < 3e38;
            if (HAS_EFFECTS && enters && upper.w != NONE) {
                flags = texelFetch(top_nodes, at + 5).y;
                enters = (flags & mask) != 0u;
            }
            leaf = enters && upper.w != NONE;
            if (leaf) {
                const mat4x3 object_from_world = load_transform(top_nodes, at + 2);
                root = texelFetch(top_nodes, at + 5).x;
                instance = upper.w;
                local.origin = object_from_world * vec4(ray.origin, 1.0);
                local.direction = object_from_world * vec4(ray.direction, 0.0);
            }
            next = enters && !leaf ? next + 1u : lower.w;
        }
        if (!leaf) return found;
    }
    return found;
}

#endif
