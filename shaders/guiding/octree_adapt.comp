#version 460
// SPDX-License-Identifier: GPL-2.0-or-later
// Pass `octree_adapt`, step 2 of the octree (paper, section 6.2, "rebuild"): the nodes of the new tree. Old nodes are stored breadth-first;
// so are new ones if each node's inner children are placed in the order of their old parents. One running sum over the
// old nodes gives all places at once, whatever the depth: one work group, 256 parts. Then the nodes go to their places.
#extension GL_GOOGLE_include_directive : require
#include "shared/extensions.glsl"
#include "guiding/passes.glsl"

const uint LANES = 256u;
layout(local_size_x = LANES) in;

// Inner children that were there before, and those that come from splits, in the parts of all lanes up to this one.
shared uvec2 sums[LANES];

/// Children of an old node that are inner nodes in the new tree: x: those that survive, y: those that are split now.
uvec2 inner_children(uint index) {
    const uint node = old_nodes[index];
    const uint marks = plan[plan_marks(index)];
    if ((marks & MARK_COLLAPSES) != 0u) return uvec2(0u);
    uint surviving = 0u;
    for (uint child = 0u; child < 8u; ++child) {
        if (octree_is_leaf(node, child)) continue;
        const uint inner = octree_inner_child(node, child);
        if ((plan[plan_marks(inner)] & MARK_COLLAPSES) == 0u) ++surviving;
    }
    return uvec2(surviving, uint(bitCount(marks & MARK_SPLITS)));
}

void main() {
    const uint lane = gl_LocalInvocationID.x;
    const uint part = (old_node_count + LANES - 1u) / LANES;
    const uint first = min(lane * part, old_node_count);
    const uint end = min(first + part, old_node_count);

    // Sum up each part, then all parts before it.
    uvec2 own = uvec2(0u);
    for (uint i = first; i < end; ++i) own += inner_children(i);
    sums[lane] = own;
    for (uint step = 1u; step < LANES; step <<= 1u) {
        barrier();
        const uvec2 before = lane >= step ? sums[lane - step] : uvec2(0u);
        barrier();
        sums[lane] += before;
    }
    barrier();
    const uvec2 total = sums[LANES - 1u];
    const uint room = header.node_capacity - 1u - total.x; // the root and the surviving nodes always fit
    uvec2 before = sums[lane] - own;

    // Place the children; splits beyond the room do not take place.
    for (uint i = first; i < end; ++i) {
        const uint node = old_nodes[i];
        const uint marks = plan[plan_marks(i)];
        if ((marks & MARK_COLLAPSES) != 0u) continue;
        const OctreeCell cell = octree_unpack_cell(old_cells[i]);
        const uint first_inner = 1u + before.x + min(before.y, room);
        uint place = first_inner;
        uint leaf_mask = OCTREE_ALL_LEAVES;
        for (uint child = 0u; child < 8u; ++child) {
            if (!octree_is_leaf(node, child)) {
                const uint inner = octree_inner_child(node, child);
                if ((plan[plan_marks(inner)] & MARK_COLLAPSES) != 0u) continue;
                plan[plan_place(inner)] = place;
                plan[plan_source(place)] = inner;
                ++before.x;
            } else if ((marks & (1u << child)) != 0u) {
                const uint leaf = octree_leaf(i, child);
                if (before.y++ >= room) { // it stays one leaf
                    const uint count = old_leaf_count(leaf);
                    atomicAdd(work.demand, count - 8u * demand_of_part(count));
                    continue;
                }
                plan[plan_source(place)] = SOURCE_SPLIT | leaf;
                new_nodes[place] = octree_node(OCTREE_ALL_LEAVES, 0u);
            } else {
                continue;
            }
            leaf_mask &= ~(1u << child);
            new_cells[place] = octree_pack_cell(octree_child_cell(cell, child));
            ++place;
        }
        plan[plan_node(i)] = octree_node(leaf_mask, first_inner);
    }
    if (lane == 0u) { // the root stays where it is
        plan[plan_place(0u)] = 0u;
        plan[plan_source(0u)] = 0u;
        new_cells[0] = old_cells[0];
    }
    memoryBarrierBuffer();
    barrier();
    for (uint i = lane; i < old_node_count; i += LANES)
        if ((plan[plan_marks(i)] & MARK_COLLAPSES) == 0u) new_nodes[plan[plan_place(i)]] = plan[plan_node(i)];
    if (lane != 0u) return;
    new_node_count = 1u + total.x + min(total.y, room);
    work.nodes = new_node_count;
    work.augment_groups.x = (8u * new_node_count + 63u) / 64u;
    work.splits = min(total.y, room);
    work.splits_refused = total.y - min(total.y, room);
}
