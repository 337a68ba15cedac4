// SPDX-License-Identifier: GPL-2.0-or-later
// The octree as whoever traces paths sees it (paper, section 6.3): finds the leaf whose cache a place uses and the leaf
// that its samples go to, in one walk from the root, and stores samples.
#ifndef VIGIL_GUIDING_OCTREE_GLSL
#define VIGIL_GUIDING_OCTREE_GLSL

#include "shared/bindings.h"
#include "shared/guiding_types.h"
#include "shared/octree.h"
#include "trace/records.glsl"

layout(set = SET_GUIDING, binding = BINDING_GUIDING_HEADER, scalar) restrict readonly buffer GuidingHeaderBlock { GuidingHeader guiding; };
layout(set = SET_GUIDING, binding = BINDING_GUIDING_NODES) uniform utextureBuffer octree_words; // number of inner nodes, and the nodes
layout(set = SET_GUIDING, binding = BINDING_GUIDING_LEAVES, scalar) restrict buffer LeafBlock { uint leaves[]; };
layout(set = SET_GUIDING,
       binding = BINDING_GUIDING_LEAF_WORDS) uniform utextureBuffer leaf_words; // the same, of what this frame does not write
layout(set = SET_GUIDING, binding = BINDING_GUIDING_SAMPLES, scalar) restrict writeonly buffer LightSampleBlock { uint light_samples[]; };
layout(set = SET_GUIDING, binding = BINDING_GUIDING_VLC) uniform utextureBuffer vlc_words; // light ids

layout(set = SET_GUIDING, binding = BINDING_GUIDING_RAYS, scalar) restrict writeonly buffer RaySampleBlock { uint ray_samples[]; };

/// The leaves of a surface: the one it was in a frame ago, where its cache is, and the one it is in now, where
/// its samples go. They are the same for what does not move.
struct SurfaceLeaves {
    uint cache;
    uint samples;
};

uint leaf_word(LeafArray array, uint leaf) { return leaf_array_word(array, leaf, guiding.node_capacity); }

/// Ends a walk to a smallest cell.
uint load_octree_node(uint node) { return load_word(octree_words, 1u + node); }

OctreeDescent descend(OctreeDescent descent, uvec3 grid) {
    while (descent.leaf == NONE) octree_descend(descent, load_octree_node(descent.node), grid);
    return descent;
}

/// `previous` is where what is at `position` now was a frame ago.
SurfaceLeaves find_leaves(vec3 position, vec3 previous) {
    const uvec3 now = octree_grid(position, guiding.corner, guiding.scale);
    const uvec3 before = octree_grid(previous, guiding.corner, guiding.scale);
    // Both walks are one until the paths part.
    OctreeDescent both = octree_root();
    while (both.leaf == NONE && octree_child(before, both.depth) == octree_child(now, both.depth))
        octree_descend(both, load_octree_node(both.node), now);
    return SurfaceLeaves(descend(both, before).leaf, descend(both, now).leaf);
}

uint node_word(NodeArray array, uint node) { return node_array_word(array, node, guiding.node_capacity); }

/// Counts a surface or a ray, unless nothing is learned from this frame.
void count(uint counter) {
    if (guiding.stores != 0u) atomicAdd(leaves[counter], 1u);
}

/// Counts a sample, and gives it the next place of a storage, if there is room. Both are words of leaves or nodes.
bool take_place(uint counter, uint storage, out uint place) {
    if (guiding.stores == 0u) return false;
    const uint number = atomicAdd(leaves[counter], 1u);
    place = load_word(leaf_words, storage) + number;
    return number < load_word(leaf_words, storage + 1u);
}

/// Stores a light sample (LIGHT_SAMPLE_*), if the leaf has room; counts it in any case.
void store_light_sample(uint leaf, uint light_sample) {
    uint place;
    if (take_place(leaf_word(LEAF_COUNT, leaf), leaf_word(LEAF_STORAGE, leaf), place)) light_samples[place] = light_sample;
}

/// Counts a surface whose light sample is of no use, so that the octree follows surfaces with every technique.
void count_surface(uint leaf) { count(leaf_word(LEAF_COUNT, leaf)); }

/// Counts a ray that brought nothing.
void count_blank_ray(uint leaf) { count(node_word(NODE_RAYS, octree_node_of(leaf)) + 1u); }

/// Stores a ray sample, if the leaf's node has room; counts it in any case.
void store_ray_sample(uint leaf, uvec2 ray_sample) {
    const uint node = octree_node_of(leaf);
    uint place;
    if (!take_place(node_word(NODE_RAYS, node), node_word(NODE_RAY_STORAGE, node), place)) return;
    ray_samples[RAY_SAMPLE_WORDS * place] = ray_sample.x;
    ray_samples[RAY_SAMPLE_WORDS * place + 1u] = ray_sample.y;
}

ShareMemory load_share(uint node) {
    const uint first = node_word(NODE_SHARE, node);
    return share_unpack(uvec2(load_word(leaf_words, first), load_word(leaf_words, first + 1u)));
}

TailMemory load_tail(uint leaf) {
    const uint first = node_word(NODE_TAIL, octree_node_of(leaf));
    return tail_unpack(uvec2(load_word(leaf_words, first), load_word(leaf_words, first + 1u)));
}

/// What a node's guider draws by.
uvec4 load_guide(uint node) {
    const uint first = node_word(NODE_GUIDE, node);
    return uvec4(load_word(leaf_words, first), load_word(leaf_words, first + 1u), load_word(leaf_words, first + 2u),
                 load_word(leaf_words, first + 3u));
}

#endif
