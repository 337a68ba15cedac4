// SPDX-License-Identifier: GPL-2.0-or-later
// What the guiding passes and the path tracer share: the header, the arrays of leaves, light
// samples, and the settings and statistics of a frame. Scalar layout; the same text is C++ and
// GLSL.
#ifndef VIGIL_SHARED_GUIDING_TYPES_H
#define VIGIL_SHARED_GUIDING_TYPES_H

#include "glsl.h"

SHADER_BEGIN

/// Written by the host when buffers are made or the octree starts anew.
struct GuidingHeader {
    vec3 corner;          // lowest corner of the root's cube, map units
    float scale;          // smallest cells per map unit
    uint node_capacity;   // inner nodes that a tree may have
    uint sample_capacity; // light samples that fit
    uint vlc_capacity;    // light ids that fit in all caches
};

/// Arrays by leaf, one after another in one buffer of words (structure of arrays). An array of w
/// words per leaf that begins at word LEAF_X * leaf_capacity holds its leaf's words at w * leaf + 0
/// .. w - 1.
SHADER_CONST uint LEAF_COUNT = 0u;      // 1 word: surface samples that fell into the leaf
SHADER_CONST uint LEAF_STORAGE = 1u;    // 2 words: first light sample, room for how many
SHADER_CONST uint LEAF_VLC = 3u;        // 2 words: first light id of the cache, number of buckets
SHADER_CONST uint LEAF_VISIBLE = 5u;    // 1 word: different lights among the leaf's visible samples
SHADER_CONST uint LEAF_NEIGHBOURS = 6u; // 6 words: leaf beyond the faces -x +x -y +y -z +z, or NONE
SHADER_CONST uint LEAF_SOURCE = 12u;    // 1 word: corresponding leaf of the tree before
SHADER_CONST uint LEAF_CACHED =
    13u; // 1 word: lights in the cache, and LEAF_INHERITED if they are those of a larger leaf
SHADER_CONST uint LEAF_RAYS = 14u;  // 1 word: ray samples that fell into the leaf
SHADER_CONST uint LEAF_CDQ = 15u;   // 4 words: directional quadtree (cdq.h)
SHADER_CONST uint LEAF_WORDS = 19u; // per leaf altogether

SHADER_CONST uint LEAF_INHERITED = 0x80000000u;

/// Index of a leaf's first word in the array of `width` words per leaf that begins at LEAF_`array`.
SHADER_FN uint leaf_array_word(uint array, uint width, uint leaf, uint node_capacity) {
    return array * (8u * node_capacity) + width * leaf;
}

/// A light sample: light id, and this bit if the light was seen.
SHADER_CONST uint LIGHT_SAMPLE_VISIBLE = 0x80000000u;
/// What is stored when there was no light to sample; light ids are smaller.
SHADER_CONST uint LIGHT_SAMPLE_NONE = 0x07ffffffu;

/// An entry of a cache: light id, and above it for how many frames no sample has seen the light.
SHADER_CONST uint VLC_ID_MASK = 0x07ffffffu;
SHADER_CONST uint VLC_AGE_SHIFT = 27u;
SHADER_CONST uint VLC_OLDEST = 30u; // so that no entry looks like NONE

/// A ray sample, 4 bytes: the cell of its direction on the grid of the smallest quadtree leaves,
/// and what it contributed, in quarters of a power of two from 2^-32 on. It decides where to look,
/// never how bright anything is.
SHADER_FN uint ray_sample_pack(uvec2 grid, float contribution) {
    const float steps = clamp(4.0f * log2(max(contribution, 1e-30f)) + 128.5f, 0.0f, 255.0f);
    return grid.x | (grid.y << 12u) | (uint(steps) << 24u);
}

SHADER_FN uvec2 ray_sample_grid(uint packed_sample) {
    return uvec2(packed_sample & 0xfffu, (packed_sample >> 12u) & 0xfffu);
}

SHADER_FN float ray_sample_contribution(uint packed_sample) {
    return exp2(0.25f * (float(packed_sample >> 24u) - 128.0f));
}

/// A leaf's samples beyond this many are passed over, evenly: as many as make a leaf split at 1920
/// x 1080 pixels. Also, llvmpipe silently ends all loops of an invocation after 65,535 rounds
/// together: each of the VLC_LEAST_LANES puts at most 512 of a leaf's samples, or 896 lights of it
/// and its neighbours, into buckets of at most 64 slots.
SHADER_CONST uint VLC_MOST_SAMPLES = 4096u;
/// The same for a leaf's ray samples, for the same reasons: each lane of a subgroup of four looks
/// at 1,024, and finding a quadtree's leaf takes 11 rounds at most.
SHADER_CONST uint CDQ_MOST_RAYS = 4096u;
/// Invocations of the work groups that make caches: a subgroup, but no fewer than these.
SHADER_CONST uint VLC_LEAST_LANES = 8u;
/// The hash table in shared memory: light ids, and buckets (ids with equal remainder).
SHADER_CONST uint VLC_TABLE_SIZE = 1024u;
SHADER_CONST uint VLC_TABLE_MOST_BUCKETS = 256u;
/// Largest bucket (pt_vlc_bucket).
SHADER_CONST uint VLC_LARGEST_BUCKET = 64u;

/// Push constants of all passes.
struct GuidingSettings {
    uint split;        // a leaf with more samples is split
    uint collapse;     // an inner node of eight leaves that have fewer together is collapsed
    uint bucket;       // most lights in a bucket
    uint small_bucket; // the same where buckets would get fewer than in the frame before
                       // (hysteresis)
    uint merge_faces;  // bit i: caches take over the lights of their neighbours beyond face i
                       // (LEAF_NEIGHBOURS)
    uint persist;      // frames that a light stays in a cache after it was seen, at most VLC_OLDEST
    uint migrations;   // of a directional quadtree in a frame, at most
    float margin;      // how far a migration must pay off
};

/// Counted anew each frame: the passes begin with all of it 0 (but the group counts' y and z, which
/// are 1).
struct GuidingWork {
    uvec3 deduplicate_groups; // indirect dispatches, one work group per entry of the lists below
    uvec3 merge_groups;
    uvec3 populate_groups;
    uint vlc_used;    // light ids taken from the caches' buffer
    uint sample_used; // light samples' room given to leaves
    uint demand;      // samples that the new leaves are expected to receive together
    // Statistics of the frame that was rendered last, and of the trees made from it.
    uint nodes;          // inner nodes
    uint depth;          // of the deepest leaf
    uint samples;        // surface samples
    uint dropped;        // of them: light samples without room
    uint sampled_leaves; // leaves with samples
    uint cached_leaves;  // leaves with a cache of at least one light
    uint cached_lights;  // their lights together
    uint cached_buckets;
    uint most_lights;     // in one cache
    uint lights_left_out; // found by samples, but the table was full
    uint splits;
    uint collapses;
    uint cdq_migrations;
    uint splits_refused; // the tree had no room for more nodes
};

SHADER_END
#endif
