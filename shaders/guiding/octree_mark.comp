#version 460
// SPDX-License-Identifier: GPL-2.0-or-later
// Pass `octree_mark`, step 1 of the octree (paper, section 6.2, "mark"): one invocation per old node decides which of its leaves are split and
// whether it collapses, and how many samples its leaves are to expect in the new tree. It also lists the leaves that have samples, those whose
// cache is made (they have samples, or had a cache), and the nodes whose leaves have rays.
#extension GL_GOOGLE_include_directive : require
#include "shared/extensions.glsl"
#include "guiding/passes.glsl"

layout(local_size_x = 64) in;

void main() {
    const uint index = gl_GlobalInvocationID.x;
    if (index >= old_node_count) return;
    const uint node = old_nodes[index];
    const uint depth = octree_unpack_cell(old_cells[index]).depth;

    uint marks = 0u;
    uint sum = 0u;
    uint demand = 0u;
    for (uint child = 0u; child < 8u; ++child) {
        if (!octree_is_leaf(node, child)) continue;
        const uint leaf = octree_leaf(index, child);
        const uint count = old_leaf_count(leaf);
        sum += count;
        const bool splits = count > settings.split && depth + 1u < OCTREE_MAX_DEPTH;
        if (splits) marks |= 1u << child;
        demand += splits ? 8u * demand_of_part(count) : count;
        // List it for the caches.
        if (count > 0u) {
            lists[deduplicate_entry(atomicAdd(work.deduplicate_groups.x, 1u))] = leaf;
            const uint room = old_leaves[leaf_word(LEAF_STORAGE, leaf) + 1u];
            if (count > room) atomicAdd(work.dropped, count - room);
        }
        if (count > 0u || old_leaves[leaf_word(LEAF_VLC, leaf) + 1u] > 0u) lists[merge_entry(atomicAdd(work.merge_groups.x, 1u))] = leaf;
    }
    uint rays = 0u;
    if (settings.guided != 0u) {
        const uvec2 own = old_node_rays(index);
        if (own.x + own.y > 0u) lists[guide_entry(atomicAdd(work.guide_groups.x, 1u))] = index;
        if (own.x > 0u) atomicAdd(work.rays, own.x);
        const uint room = old_leaves[node_word(NODE_RAY_STORAGE, index) + 1u];
        if (own.x > room) atomicAdd(work.rays_dropped, own.x - room);
        rays = expected_rays(index);
    }
    uint ray_demand = rays + uint(bitCount(marks)) * demand_of_part(rays);
    if (index > 0u && (node & MARK_SPLITS) == OCTREE_ALL_LEAVES && sum < settings.collapse) {
        marks = MARK_COLLAPSES;
        demand = sum;
        ray_demand = 0u;
        atomicAdd(work.collapses, 1u);
    }
    if (sum > 0u) {
        atomicAdd(work.samples, sum);
        atomicAdd(work.demand, demand);
    }
    if (ray_demand > 0u) atomicAdd(work.ray_demand, ray_demand);
    plan[plan_marks(index)] = marks;
}
