#version 460
// SPDX-License-Identifier: GPL-2.0-or-later
// Pass `octree_adapt`, step 3 of the octree: one invocation per old node that is still there writes the node at its new place, and adds up how many
// samples the leaves of the new tree are to expect.
#extension GL_GOOGLE_include_directive : require
#include "shared/extensions.glsl"
#include "guiding/passes.glsl"
#include "guiding/octree_demand.glsl"

layout(local_size_x = 64) in;

void main() {
    const uint index = gl_GlobalInvocationID.x;
    if (index >= old_node_count) return;
    if ((plan[plan_marks(index)] & MARK_COLLAPSES) != 0u) return;
    const uint node = old_nodes[index];
    const uint first_inner = plan[plan_first_inner(index)];

    // A child is an inner node if its source says so; refused splits left none.
    uint leaf_mask = 0u;
    uint demand = 0u;
    uint place = first_inner;
    for (uint child = 0u; child < 8u; ++child) {
        bool inner;
        if (octree_is_leaf(node, child)) {
            const uint leaf = octree_leaf(index, child);
            inner = (plan[plan_marks(index)] & (1u << child)) != 0u && place < new_node_count &&
                    plan[plan_source(place)] == (SOURCE_SPLIT | leaf);
            demand += inner ? 8u * demand_of_part(old_leaf_count(leaf)) : old_leaf_count(leaf);
        } else {
            const uint old_inner = octree_inner_child(node, child);
            inner = (plan[plan_marks(old_inner)] & MARK_COLLAPSES) == 0u;
            if (!inner) demand += demand_of_collapsed(old_inner);
        }
        if (inner) ++place;
        else leaf_mask |= 1u << child;
    }
    new_nodes[plan[plan_place(index)]] = octree_node(leaf_mask, first_inner);
    if (demand > 0u) atomicAdd(work.demand, demand);
}
