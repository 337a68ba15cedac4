// SPDX-License-Identifier: GPL-2.0-or-later
// Walks one bottom-level hierarchy with a ray, nearer children first (for any hit, larger ones
// first, after Nah and Manocha 2014), with a stack of one word per level. Every round of the loop
// loads one record and does the work of an inner record and of a leaf: lanes that run in lockstep
// then never wait for each other's kind (docs/internals/tracing.md has the alternatives). The text compiles
// as GLSL and as C++ (tests): whoever includes it defines `uvec4 bvh_load_node(uint word)` before.
#ifndef VIGIL_TRACE_BVH_TRAVERSE_GLSL
#define VIGIL_TRACE_BVH_TRAVERSE_GLSL

SHADER_BEGIN

/// Children still to visit, in one word: their node in bits 8..31; below, two bits for each child,
/// next one first, closed by a one.
SHADER_CONST uint BVH_PENDING_NONE = 1u;

SHADER_FN bool bvh_pending_empty(uint pending) { return (pending & 0xfcu) == 0u; }

/// The second to fourth of the sorted children as a pending word.
SHADER_FN uint bvh_pending(uvec4 children, uint node) {
    uint list = children.w == BVH_NO_CHILD ? 1u : 4u | (children.w & 3u);
    list = children.z == BVH_NO_CHILD ? 1u : (list << 2) | (children.z & 3u);
    list = children.y == BVH_NO_CHILD ? 1u : (list << 2) | (children.y & 3u);
    return (node << 8) | list;
}

/// Looks for a hit in (ray.t_min, hit.t) in the hierarchy whose first node is `root`; on success
/// writes `hit` and returns true. Give hit.t = ray.t_max to start with. With `any_hit` the first
/// hit found ends the walk, and only the return value is defined. `translucent` false promises that
/// all triangles are opaque; `opacity` is the instance's, 0..255.
SHADER_FN bool bvh_traverse(uint root, Ray ray, uint seed, uint instance, bool any_hit, bool translucent, uint opacity, INOUT(Hit) hit) {
    vec3 inverse = bvh_reciprocal3(ray.direction);
    uint stack[BVH_MAX_DEPTH];
    uint stack_size = 0u;
    uint pending = BVH_PENDING_NONE;
    uint record = root * 4u;
    float limit = hit.t;
    uint nearest = NONE; // twice the record of the nearest hit, plus one for its second triangle
    while (true) {
        uint word = record * BVH_RECORD_WORDS;
        uvec4 a = bvh_load_node(word);
        uvec4 b = bvh_load_node(word + 1u);
        uvec4 c = bvh_load_node(word + 2u);
        uvec4 meta = bvh_load_node(word + 3u);
        bool leaf = (meta.w & BVH_LEAF) != 0u;
        if (leaf) {
            BvhPairHit pair = bvh_pair_hit(a, b, c, ray.origin, ray.direction, ray.t_min, limit);
            if (translucent) {
                uint first = bvh_faded(meta.y, opacity);
                uint second = bvh_faded(meta.y >> 8, opacity);
                if (!bvh_covered(first, pair.front_of_first, seed, instance, meta.x)) pair.t.x = BVH_MISS;
                if (!bvh_covered(second, pair.front_of_second, seed, instance, meta.x + 1u)) pair.t.y = BVH_MISS;
            }
            float t = min(pair.t.x, pair.t.y);
            if (t < limit) {
                limit = t;
                nearest = 2u * record + (pair.t.y < pair.t.x ? 1u : 0u);
                if (any_hit) break;
            }
        }

        // Go to the nearest child that is entered. What was pending before goes on the stack:
        // stored always, kept if need be, as a store that only some lanes do costs more.
        uvec4 children = bvh_sorted_children(a, b, c, meta, ray.origin, inverse, ray.t_min, limit, !any_hit);
        bool down = children.x != BVH_NO_CHILD && !leaf;
        stack[stack_size] = pending;
        stack_size += down && !bvh_pending_empty(pending) ? 1u : 0u;
        uint node = meta.w & BVH_CHILD_NODE_MASK;
        if (down) {
            record = node * 4u + (children.x & 3u);
            pending = bvh_pending(children, node);
        } else {
            if (bvh_pending_empty(pending)) {
                if (stack_size == 0u) break;
                stack_size -= 1u;
                pending = stack[stack_size];
            }
            record = (pending >> 8) * 4u + (pending & 3u);
            pending = (pending & 0xffffff00u) | ((pending & 0xffu) >> 2);
        }
    }
    if (nearest == NONE) return false;
    if (any_hit) return true;

    // Fill in what the loop did not carry along.
    uint word = (nearest >> 1) * BVH_RECORD_WORDS;
    bool second = (nearest & 1u) != 0u;
    uvec4 meta = bvh_load_node(word + 3u);
    BvhPairHit pair =
        bvh_pair_hit(bvh_load_node(word), bvh_load_node(word + 1u), bvh_load_node(word + 2u), ray.origin, ray.direction, 0.0f, BVH_MISS);
    vec4 weights = pair.barycentrics;
    hit.t = limit;
    hit.primitive = meta.x + (second ? 1u : 0u);
    hit.instance = instance;
    hit.barycentrics = second ? bvh_unrotate(vec2(weights.z, weights.w), (meta.y >> 18) & 3u)
                              : bvh_unrotate(vec2(weights.x, weights.y), (meta.y >> 16) & 3u);
    hit.front = second ? pair.front_of_second : pair.front_of_first;
    return true;
}

SHADER_END
#endif
