// SPDX-License-Identifier: GPL-2.0-or-later
// Buffers of the guiding passes. They make this frame's octree ("new") from that of the frame before ("old") and from the
// samples that the path tracer put into its leaves; host side: refresh/vkpt/guiding/guiding.cpp.
#ifndef VIGIL_GUIDING_PASSES_GLSL
#define VIGIL_GUIDING_PASSES_GLSL

#include "shared/bindings.h"
#include "shared/guiding_types.h"
#include "shared/octree.h"
#include "shared/scene_types.h"

layout(set = 0, binding = BINDING_PASS_HEADER, scalar) restrict readonly buffer HeaderBlock { GuidingHeader header; };
layout(set = 0, binding = BINDING_PASS_OLD_NODES, scalar) restrict readonly buffer OldNodeBlock {
    uint old_node_count;
    uint old_nodes[];
};
layout(set = 0, binding = BINDING_PASS_OLD_CELLS, scalar) restrict readonly buffer OldCellBlock { uvec2 old_cells[]; };
layout(set = 0, binding = BINDING_PASS_OLD_LEAVES, scalar) restrict buffer OldLeafBlock { uint old_leaves[]; };
layout(set = 0, binding = BINDING_PASS_NEW_NODES, scalar) restrict buffer NewNodeBlock {
    uint new_node_count;
    uint new_nodes[];
};
layout(set = 0, binding = BINDING_PASS_NEW_CELLS, scalar) restrict buffer NewCellBlock { uvec2 new_cells[]; };
layout(set = 0, binding = BINDING_PASS_NEW_LEAVES, scalar) restrict buffer NewLeafBlock { uint new_leaves[]; };
// What becomes of old nodes (plan_*), and where new ones come from (plan_source): four arrays, one word per node.
layout(set = 0, binding = BINDING_PASS_PLAN, scalar) restrict coherent buffer PlanBlock { uint plan[]; };
layout(set = 0, binding = BINDING_PASS_SAMPLES, scalar) restrict buffer SampleBlock { uint light_samples[]; };
layout(set = 0, binding = BINDING_PASS_NEW_CACHES, scalar) restrict writeonly buffer VlcBlock { uint vlc_lights[]; };
// What to work on: old leaves to deduplicate, old leaves to merge, old nodes whose guider learns.
layout(set = 0, binding = BINDING_PASS_LISTS, scalar) restrict buffer ListBlock { uint lists[]; };
layout(set = 0, binding = BINDING_PASS_WORK, scalar) restrict buffer WorkBlock { GuidingWork work; };

layout(set = 0, binding = BINDING_PASS_OLD_CACHES, scalar) restrict buffer OldVlcBlock { uint old_caches[]; };

layout(set = 0, binding = BINDING_PASS_RAYS, scalar) restrict readonly buffer RaySampleBlock { uint ray_samples[]; };

layout(push_constant, scalar) uniform SettingsBlock { GuidingSettings settings; };

uint leaf_capacity() { return 8u * header.node_capacity; }

uint leaf_word(LeafArray array, uint leaf) { return leaf_array_word(array, leaf, header.node_capacity); }

// Words of the lists' entries.
uint deduplicate_entry(uint i) { return i; }
uint merge_entry(uint i) { return leaf_capacity() + i; }
uint guide_entry(uint i) { return 2u * leaf_capacity() + i; }

uint node_word(NodeArray array, uint node) { return node_array_word(array, node, header.node_capacity); }

ShareMemory load_share(uint node) {
    const uint words = node_word(NODE_SHARE, node);
    return share_unpack(uvec2(old_leaves[words], old_leaves[words + 1u]));
}

/// Rays of an old node's leaves: those that brought something, stored or not, and the others.
uvec2 old_node_rays(uint node) {
    const uint words = node_word(NODE_RAYS, node);
    return uvec2(old_leaves[words], old_leaves[words + 1u]);
}

/// Rays that bring something, which an old node is to expect; of a frame without guided ones, as many as there is room for.
uint expected_rays(uint node) {
    if (settings.unguided == 0u) return old_node_rays(node).x;
    return old_leaves[node_word(NODE_RAY_STORAGE, node) + 1u] * 4u / 5u; // room has a quarter to spare
}

uint old_leaf_count(uint leaf) { return old_leaves[leaf_word(LEAF_COUNT, leaf)]; }

/// First of the words of a cache's buckets (VLC_BUCKET_WORDS), in the buffer of caches.
uint bucket_words(uint first, uint buckets) { return first + buckets * settings.bucket; }

// Bits of a plan's marks: children to split, and whether the node itself collapses into a leaf.
const uint MARK_SPLITS = 0xffu;
const uint MARK_COLLAPSES = 0x100u;

uint plan_marks(uint node) { return node; }
uint plan_node(uint node) { return header.node_capacity + node; }       // the node as it is in the new tree
uint plan_place(uint node) { return 2u * header.node_capacity + node; } // its index there
/// A new node's source: an old node, or the old leaf that was split, with SOURCE_SPLIT.
uint plan_source(uint new_node) { return 3u * header.node_capacity + new_node; }

/// How many samples one of the eight parts of a leaf that is split is to expect: surfaces cross half of them. What its storage is
/// made for.
uint demand_of_part(uint count) { return (count + 3u) / 4u; }

/// Divides the room for `capacity` samples among `owners`: each gets what it expects with a quarter to spare, as far as three quarters of the
/// room go; the rest evenly, for surfaces that come into view. `all` is what all owners expect together.
uint room_for(uint demand, uint all, uint capacity, uint owners) {
    const float wanted = 1.25 * float(all);
    const float divisible = 0.75 * float(capacity);
    const float share = wanted > divisible ? divisible / wanted : 1.0;
    return uint(1.25 * share * float(demand)) + (capacity - uint(min(wanted, divisible))) / owners;
}

#endif
