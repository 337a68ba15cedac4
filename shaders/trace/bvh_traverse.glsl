// SPDX-License-Identifier: GPL-2.0-or-later
// Walks one bottom-level hierarchy with a ray: nearer child first, the other on a private stack.
// The text compiles as GLSL and as C++ (tests): whoever includes it defines `uvec4
// bvh_load_node(uint word)` and `BvhTriangle bvh_load_triangle(uint index)` before. Instances are
// not known here.
#ifndef VIGIL_TRACE_BVH_TRAVERSE_GLSL
#define VIGIL_TRACE_BVH_TRAVERSE_GLSL

SHADER_BEGIN

/// Looks for a hit in (ray.t_min, hit.t) under `root`; on success writes `hit` and returns true.
/// Give hit.t = ray.t_max to start with. With `any_hit` the first hit found ends the walk.
/// `translucent` false promises that all triangles are opaque.
SHADER_FN bool bvh_traverse(uint root, Ray ray, uint seed, uint instance, bool any_hit,
                            bool translucent, INOUT(Hit) hit) {
    vec3 inverse = bvh_reciprocal3(ray.direction);
    uint stack[BVH_MAX_DEPTH];
    uint stack_size = 0u;
    uint reference = root;
    bool found = false;
    while (true) {
        // Inner nodes: go to the nearer child that is hit, remember the other.
        while ((reference & BVH_LEAF) == 0u) {
            uint word = reference * BVH_NODE_WORDS;
            uvec4 a = bvh_load_node(word);
            uvec4 b = bvh_load_node(word + 1u);
            uvec4 c = bvh_load_node(word + 2u);
            uvec4 d = bvh_load_node(word + 3u);
            vec3 lower_0 = uintBitsToFloat(uvec3(a.x, a.y, a.z));
            vec3 upper_0 = uintBitsToFloat(uvec3(b.x, b.y, b.z));
            vec3 lower_1 = uintBitsToFloat(uvec3(c.x, c.y, c.z));
            vec3 upper_1 = uintBitsToFloat(uvec3(d.x, d.y, d.z));
            float t_0 = bvh_box_entry(lower_0, upper_0, ray.origin, inverse, ray.t_min, hit.t);
            float t_1 = bvh_box_entry(lower_1, upper_1, ray.origin, inverse, ray.t_min, hit.t);
            bool first = t_0 <= t_1;
            uint near_reference = first ? a.w : b.w;
            uint far_reference = first ? b.w : a.w;
            if (max(t_0, t_1) < 3e38f) {
                stack[stack_size] = far_reference;
                stack_size += 1u;
            }
            if (min(t_0, t_1) < 3e38f) {
                reference = near_reference;
            } else {
                if (stack_size == 0u) return found;
                stack_size -= 1u;
                reference = stack[stack_size];
            }
        }
        // A leaf: test its triangles.
        uint index = reference & BVH_LEAF_FIRST_MASK;
        uint end = index + 1u + ((reference >> BVH_LEAF_COUNT_SHIFT) & BVH_LEAF_COUNT_MASK);
        for (; index < end; index += 1u) {
            BvhTriangle triangle = bvh_load_triangle(index);
            float t;
            float u;
            float v;
            bool front;
            if (bvh_triangle_hit(triangle.v0, triangle.e1, triangle.e2, ray.origin, ray.direction,
                                 ray.t_min, hit.t, t, u, v, front) &&
                (!translucent || bvh_covered(triangle.flags, front, seed, instance, index))) {
                hit.t = t;
                hit.primitive = index;
                hit.instance = instance;
                hit.barycentrics = vec2(u, v);
                hit.front = front;
                found = true;
                if (any_hit) return true;
            }
        }
        if (stack_size == 0u) return found;
        stack_size -= 1u;
        reference = stack[stack_size];
    }
    return found;
}

SHADER_END
#endif
