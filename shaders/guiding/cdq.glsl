// SPDX-License-Identifier: GPL-2.0-or-later
// Guider `cdq`: Compressed Directional Quadtrees (paper, section 5; shared/cdq.h), one per node of the octree. GUIDER_SIZE is
// their number of bits.
#ifndef VIGIL_GUIDING_CDQ_GLSL
#define VIGIL_GUIDING_CDQ_GLSL

#include "shared/cdq.h"

#define GUIDES 1

struct Guide {
    uvec4 tree;
};

Guide guide_prepare(uvec4 words) { return Guide(words); }

vec3 guide_sample(Guide guide, vec3 u, out float pdf) { return cdq_sample(guide.tree, GUIDER_SIZE, u, pdf); }

float guide_pdf(Guide guide, vec3 direction) { return cdq_pdf(guide.tree, GUIDER_SIZE, direction); }

/// Leaves have borders where they are some pixels wide.
bool guide_border(Guide guide, vec2 uv, float edge) {
    const float cells = float(1u << cdq_find(guide.tree, uv).depth);
    return edge >= 5.0 * cells && any(lessThan(fract(uv * cells), vec2(cells / edge)));
}

#ifdef GUIDE_LEARNS
// It adds up the squared contributions of a node's rays in the leaves of its directional quadtree, to those of earlier rays
// that it remembers, and lets the quadtree's leaves migrate from where they contribute least to where they contribute most
// (paper, section 5.1). The field is unfolded for that: a node is known by its slot, at first its bit. Four children are a group of slots,
// which a migration hands on.

const float NO_MOMENT = 3e38;

shared uint sums[CDQ_MOST_BITS];        // squared contributions by leaf, as floats' bits
shared float moments[CDQ_MOST_BITS];    // of leaves, and of inner nodes above four of them; NO_MOMENT of others
shared uint first_child[CDQ_MOST_BITS]; // of inner nodes; 0: a leaf
shared uint group_parent[CDQ_MOST_BITS / 4u];
shared uint group_keys[CDQ_MOST_BITS / 4u];  // level and path from the root (group_key): in their order groups stand in the field
shared uint group_slots[CDQ_MOST_BITS / 4u]; // first slot of a group, by its place in the field
shared uvec4 field;
shared uint most_moment; // of all invocations' leaves, as a float's bits: those of positive floats are in their order
shared uint least_moment;
shared uint most_leaf;
shared uint least_inner;

float even_density; // of the rays that the BRDF draws, where the quadtree's is 4^depth

/// The key of children at a level (1: of the root), whose parents' numbers 0 to 3 make the path, the last in its lowest bits.
const uint KEY_PATH_BITS = 2u * CDQ_MAX_DEPTH;
uint group_key(uint depth, uint path) { return (depth << KEY_PATH_BITS) | path; }

/// Level of a slot's node.
uint depth_of(uint slot) { return group_keys[slot / 4u] >> KEY_PATH_BITS; }

/// Key of a node's children.
uint key_below(uint slot) {
    const uint path = group_keys[slot / 4u] & ((1u << KEY_PATH_BITS) - 1u);
    return group_key(depth_of(slot) + 1u, (path << 2u) | (slot & 3u));
}

float sum_of(uint slot) { return uintBitsToFloat(sums[slot]); }

/// What a quadtree leaf adds to the second moment of its rays, in proportion: its sum over the density with which rays are drawn there
/// now.
float leaf_moment(uint slot) { return sum_of(slot) / (float(1u << (2u * depth_of(slot))) + even_density); }

float inner_moment(uint slot) {
    const uint child = first_child[slot];
    if ((first_child[child] | first_child[child + 1u] | first_child[child + 2u] | first_child[child + 3u]) != 0u) return NO_MOMENT;
    return moments[child] + moments[child + 1u] + moments[child + 2u] + moments[child + 3u];
}

void unfold(uvec4 tree) {
    for (uint node = gl_LocalInvocationID.x; node < GUIDER_SIZE; node += LANES) {
        const uint child = cdq_is_inner(tree, node) ? cdq_child(tree, node, 0u) : 0u;
        first_child[node] = child;
        if (child != 0u) group_parent[child / 4u] = node;
    }
    if (gl_LocalInvocationID.x == 0u) group_parent[0] = NONE;
    barrier();
    for (uint group = gl_LocalInvocationID.x; group < GUIDER_SIZE / 4u; group += LANES) {
        uint depth = 1u;
        uint path = 0u;
        for (uint parent = group_parent[group]; parent != NONE; parent = group_parent[parent / 4u]) {
            path |= (parent & 3u) << (2u * (depth - 1u));
            depth += 1u;
        }
        group_keys[group] = group_key(depth, path);
        group_slots[group] = 4u * group;
    }
}

/// The slot of a bit.
uint slot_of(uint node) { return group_slots[node / 4u] + (node & 3u); }

/// Makes the field again, with the slots of its bits.
void fold() {
    if (gl_LocalInvocationID.x == 0u) field = uvec4(0u);
    barrier();
    for (uint group = gl_LocalInvocationID.x; group < GUIDER_SIZE / 4u; group += LANES) {
        const uint key = group_keys[group];
        uint place = 0u;
        for (uint other = 0u; other < GUIDER_SIZE / 4u; ++other) place += group_keys[other] < key ? 1u : 0u;
        group_slots[place] = 4u * group;
        uint inner = 0u;
        for (uint child = 0u; child < 4u; ++child) inner |= first_child[4u * group + child] != 0u ? 1u << child : 0u;
        atomicOr(field[place / 8u], inner << (4u * (place % 8u)));
    }
    barrier();
}

void add_sum(uint slot, float value) {
    uint seen = sums[slot];
    for (;;) {
        const uint before = atomicCompSwap(sums[slot], seen, floatBitsToUint(uintBitsToFloat(seen) + value));
        if (before == seen) return;
        seen = before;
    }
}

/// The quadtree leaf of a cell on the grid of the smallest ones.
uint find_slot(uvec2 grid) {
    uint shift = CDQ_MAX_DEPTH - 1u;
    uint slot = ((grid.x >> shift) & 1u) | (((grid.y >> shift) & 1u) << 1u);
    while (first_child[slot] != 0u && shift > 0u) {
        shift -= 1u;
        slot = first_child[slot] + (((grid.x >> shift) & 1u) | (((grid.y >> shift) & 1u) << 1u));
    }
    return slot;
}

void accumulate(NodeRays rays) {
    for (uint i = gl_LocalInvocationID.x; i < rays.count; i += LANES) {
        const uint ray = ray_samples[ray_word(rays, i)];
        const float contribution = ray_sample_contribution(ray);
        if (contribution > 0.0) add_sum(find_slot(ray_sample_grid(ray)), contribution * contribution);
    }
}

/// Looks for the leaf that contributes most and may be split, and for the inner node above leaves that contributes least. Of equal ones
/// the lowest slot counts. Returns whether the leaf is worth it.
bool search(out uint leaf, out uint inner) {
    float most = 0.0;
    float least = NO_MOMENT;
    leaf = NONE;
    inner = NONE;
    for (uint slot = gl_LocalInvocationID.x; slot < GUIDER_SIZE; slot += LANES) {
        const float moment = moments[slot];
        if (first_child[slot] != 0u) {
            if (moment < least) {
                least = moment;
                inner = slot;
            }
        } else if (moment > most && depth_of(slot) < CDQ_MAX_DEPTH) {
            most = moment;
            leaf = slot;
        }
    }
    if (gl_LocalInvocationID.x == 0u) {
        most_moment = 0u;
        least_moment = floatBitsToUint(NO_MOMENT);
        most_leaf = NONE;
        least_inner = NONE;
    }
    barrier();
    atomicMax(most_moment, floatBitsToUint(most));
    atomicMin(least_moment, floatBitsToUint(least));
    barrier();
    if (most == uintBitsToFloat(most_moment)) atomicMin(most_leaf, leaf);
    if (least == uintBitsToFloat(least_moment)) atomicMin(least_inner, inner);
    barrier();
    leaf = most_leaf;
    inner = least_inner;
    return leaf != NONE && inner != NONE && uintBitsToFloat(most_moment) * settings.margin > uintBitsToFloat(least_moment);
}

/// The group below `inner` goes to `leaf`, whose sum goes to its new children in equal parts. For one invocation.
void migrate(uint inner, uint leaf) {
    const uint group = first_child[inner];
    sums[inner] = floatBitsToUint(sum_of(group) + sum_of(group + 1u) + sum_of(group + 2u) + sum_of(group + 3u));
    first_child[inner] = 0u;
    moments[inner] = leaf_moment(inner);
    first_child[leaf] = group;
    group_parent[group / 4u] = leaf;
    group_keys[group / 4u] = key_below(leaf);
    for (uint slot = group; slot < group + 4u; ++slot) {
        sums[slot] = floatBitsToUint(0.25 * sum_of(leaf));
        moments[slot] = leaf_moment(slot);
    }
    moments[leaf] = inner_moment(leaf);
    const uint above_inner = group_parent[inner / 4u];
    if (above_inner != NONE) moments[above_inner] = inner_moment(above_inner);
    const uint above_leaf = group_parent[leaf / 4u];
    if (above_leaf != NONE) moments[above_leaf] = NO_MOMENT;
}

/// Lets the quadtree of an octree node follow the rays of its leaves, and earlier ones, the less the more new ones there are.
void guide_learn(uint octree_node_index, uint rays) {
    const uint lane = gl_LocalInvocationID.x;
    const uint words = node_word(NODE_GUIDE, octree_node_index);
    even_density = cdq_even_density(GUIDER_SIZE, 1.0 - guided_share(octree_node_index));
    const float kept = guide_kept(settings, rays);
    const uint memory = node_word(guide_memory(CDQ_SUM_WORDS), octree_node_index);
    for (uint node = lane; node < GUIDER_SIZE; node += LANES)
        sums[node] = kept > 0.0 ? floatBitsToUint(kept * unpack_sum(old_leaves[memory + node / 2u], node & 1u)) : 0u;
    unfold(uvec4(old_leaves[words], old_leaves[words + 1u], old_leaves[words + 2u], old_leaves[words + 3u]));
    barrier();
    accumulate(rays_of(octree_node_index, rays));
    barrier();
    for (uint slot = lane; slot < GUIDER_SIZE; slot += LANES)
        if (first_child[slot] == 0u) moments[slot] = leaf_moment(slot);
    barrier();
    for (uint slot = lane; slot < GUIDER_SIZE; slot += LANES)
        if (first_child[slot] != 0u) moments[slot] = inner_moment(slot);
    barrier();
    uint migrated = 0u;
    uint leaf;
    uint inner;
    while (migrated < settings.migrations && search(leaf, inner)) {
        ++migrated;
        barrier();
        if (lane == 0u) migrate(inner, leaf);
        barrier();
    }
    if (migrated > 0u) {
        fold();
        if (lane == 0u) {
            for (uint word = 0u; word < 4u; ++word) old_leaves[words + word] = field[word];
            atomicAdd(work.cdq_migrations, migrated);
        }
    }
    for (uint word = lane; word < min(settings.memory_words, GUIDER_SIZE / 2u); word += LANES)
        old_leaves[memory + word] = pack_sums(min(sum_of(slot_of(2u * word)), 1e37), min(sum_of(slot_of(2u * word + 1u)), 1e37));
}
#endif

#endif
