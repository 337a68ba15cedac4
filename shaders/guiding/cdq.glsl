// SPDX-License-Identifier: GPL-2.0-or-later
// Guider `cdq`: Compressed Directional Quadtrees (paper, section 5; shared/cdq.h), one per leaf of the octree. GUIDER_SIZE is
// their number of bits.
#ifndef VIGIL_GUIDING_CDQ_GLSL
#define VIGIL_GUIDING_CDQ_GLSL

#include "shared/cdq.h"

#define GUIDES 1

struct Guide {
    uvec4 tree;
};

Guide guide_prepare(uvec4 words) { return Guide(words); }

vec3 guide_sample(Guide guide, vec3 u) { return cdq_sample(guide.tree, GUIDER_SIZE, u); }

float guide_pdf(Guide guide, vec3 direction) { return cdq_pdf(guide.tree, GUIDER_SIZE, direction); }

/// Leaves have borders where they are some pixels wide.
bool guide_border(Guide guide, vec2 uv, float edge) {
    const float cells = float(1u << cdq_find(guide.tree, uv).depth);
    return edge >= 5.0 * cells && any(lessThan(fract(uv * cells), vec2(cells / edge)));
}

#ifdef GUIDE_LEARNS
// It adds up the squared contributions of the leaf's rays in the leaves of its directional quadtree, to those of earlier rays
// that it remembers, and lets the quadtree's leaves migrate from where they contribute least to where they contribute most
// (paper, section 5.1).

const uint MOST_LANES = 128u;

shared uint sums[CDQ_MOST_BITS];        // squared contributions by leaf, as floats' bits
shared uint first_child[CDQ_MOST_BITS]; // of inner nodes; 0: a leaf
shared float lane_leaf_sum[MOST_LANES];
shared float lane_inner_sum[MOST_LANES];
shared uint lane_leaf[MOST_LANES];
shared uint lane_inner[MOST_LANES];

float sum_of(uint node) { return uintBitsToFloat(sums[node]); }

/// What a quadtree leaf at `depth` adds to the second moment of its rays, in proportion: its sum over the density with which rays are
/// drawn there now.
float moment_of(uint node, uint depth) { return sum_of(node) / (float(1u << (2u * depth)) + settings.even_density); }

void add_sum(uint node, float value) {
    uint seen = sums[node];
    for (;;) {
        const uint before = atomicCompSwap(sums[node], seen, floatBitsToUint(uintBitsToFloat(seen) + value));
        if (before == seen) return;
        seen = before;
    }
}

/// The quadtree leaf of a cell on the grid of the smallest ones.
uint find_node(uvec2 grid) {
    uint shift = CDQ_MAX_DEPTH - 1u;
    uint node = ((grid.x >> shift) & 1u) | (((grid.y >> shift) & 1u) << 1u);
    while (first_child[node] != 0u && shift > 0u) {
        shift -= 1u;
        node = first_child[node] + (((grid.x >> shift) & 1u) | (((grid.y >> shift) & 1u) << 1u));
    }
    return node;
}

/// Adds up an octree leaf's rays, of `rays` > 0 at most `most`, evenly: lanes that found the same quadtree leaf first among themselves,
/// then in shared memory.
void accumulate(uint leaf, uint rays, uint most) {
    const uint first = old_leaves[leaf_word(LEAF_STORAGE, leaf)];
    const uint count = min(rays, most);
    for (uint i = gl_LocalInvocationID.x; i < count; i += LANES) {
        const uint ray = ray_samples[first + spread_place(i, rays, count)];
        const float contribution = ray_sample_contribution(ray);
        const uint node = find_node(ray_sample_grid(ray));
        for (;;) {
            const uint leader = subgroupBroadcastFirst(node);
            if (leader != node) continue;
            const float sum = subgroupAdd(contribution * contribution);
            if (subgroupElect()) add_sum(node, sum);
            break;
        }
    }
}

/// Looks for the leaf that contributes most and may be split, and for the inner node above leaves that contributes least.
void search(uvec4 tree, out uint leaf, out uint inner) {
    const uint lane = gl_LocalInvocationID.x;
    float most = 0.0;
    float least = 3e38;
    uint own_leaf = NONE;
    uint own_inner = NONE;
    const uvec4 starts = cdq_level_starts(tree, GUIDER_SIZE);
    for (uint node = lane; node < GUIDER_SIZE; node += LANES) {
        const uint child = first_child[node];
        if (child == 0u) {
            if (!(sum_of(node) > 0.0)) continue;
            const uint depth = cdq_depth(starts, node);
            const float moment = moment_of(node, depth);
            if (moment > most && depth < CDQ_MAX_DEPTH) {
                most = moment;
                own_leaf = node;
            }
        } else if ((first_child[child] | first_child[child + 1u] | first_child[child + 2u] | first_child[child + 3u]) == 0u) {
            float moment = 0.0;
            const uint depth = cdq_depth(starts, child);
            for (uint i = 0u; i < 4u; ++i) moment += moment_of(child + i, depth);
            if (moment < least) {
                least = moment;
                own_inner = node;
            }
        }
    }
    lane_leaf_sum[lane] = most;
    lane_leaf[lane] = own_leaf;
    lane_inner_sum[lane] = least;
    lane_inner[lane] = own_inner;
    barrier();
    for (uint other = 0u; other < LANES; ++other) {
        if (lane_leaf_sum[other] > most || (lane_leaf_sum[other] == most && lane_leaf[other] < own_leaf)) {
            most = lane_leaf_sum[other];
            own_leaf = lane_leaf[other];
        }
        if (lane_inner_sum[other] < least || (lane_inner_sum[other] == least && lane_inner[other] < own_inner)) {
            least = lane_inner_sum[other];
            own_inner = lane_inner[other];
        }
    }
    barrier();
    leaf = own_leaf;
    inner = own_inner;
    // The leaf must be worth it.
    if (leaf == NONE || inner == NONE || !(most * settings.margin > least)) leaf = NONE;
}

void find_children(uvec4 tree) {
    for (uint node = gl_LocalInvocationID.x; node < GUIDER_SIZE; node += LANES)
        first_child[node] = cdq_is_inner(tree, node) ? cdq_child(tree, node, 0u) : 0u;
}

/// Brings the sums to the tree after a migration: the leaf's goes to its new children in equal parts.
void move_sums(uvec4 tree, uint inner, uint leaf) {
    const uint removed = first_child[inner];
    const float inner_sum = sum_of(removed) + sum_of(removed + 1u) + sum_of(removed + 2u) + sum_of(removed + 3u);
    const uint inserted = cdq_child(tree, leaf > removed ? leaf - 4u : leaf, 0u);
    const float part = 0.25 * sum_of(leaf);
    // A lane has GUIDER_SIZE / LANES nodes, and work groups have 4 lanes at least.
    float moved[32];
    uint count = 0u;
    for (uint node = gl_LocalInvocationID.x; node < GUIDER_SIZE; node += LANES) {
        float value = part;
        if (node < inserted || node >= inserted + 4u) {
            uint old = node >= inserted + 4u ? node - 4u : node;
            old += old >= removed ? 4u : 0u;
            value = old == inner ? inner_sum : sum_of(old);
        }
        moved[count++] = value;
    }
    barrier();
    count = 0u;
    for (uint node = gl_LocalInvocationID.x; node < GUIDER_SIZE; node += LANES) sums[node] = floatBitsToUint(moved[count++]);
}

/// Lets the quadtree of an octree leaf with `own_rays` > 0 follow them. Of very many rays it takes some, evenly.
void guide_learn(uint octree_leaf_index, uint own_rays) {
    const uint lane = gl_LocalInvocationID.x;
    const uint words = leaf_word(LEAF_GUIDE, octree_leaf_index);
    uvec4 tree = uvec4(old_leaves[words], old_leaves[words + 1u], old_leaves[words + 2u], old_leaves[words + 3u]);

    // The few rays of one leaf and frame say too little about a hundred directions. Those of its neighbours count as well, one face after
    // the other until there are enough, and those of earlier frames, the less the more new ones there are.
    uint rays = own_rays;
    uint faces = 0u;
    for (; faces < 6u && rays < settings.memory_rays; ++faces) {
        const uint neighbour = old_leaves[leaf_word(LEAF_NEIGHBOURS, octree_leaf_index) + faces];
        if (neighbour != NONE) rays += stored_rays(neighbour);
    }
    const float kept = guide_kept(settings, rays);
    const uint memory = leaf_word(guide_memory(CDQ_SUM_WORDS), octree_leaf_index);
    for (uint node = lane; node < GUIDER_SIZE; node += LANES)
        sums[node] = kept > 0.0 ? floatBitsToUint(kept * unpack_sum(old_leaves[memory + node / 2u], node & 1u)) : 0u;
    find_children(tree);
    barrier();
    accumulate(octree_leaf_index, own_rays, CDQ_MOST_RAYS);
    for (uint face = 0u; face < faces; ++face) {
        const uint neighbour = old_leaves[leaf_word(LEAF_NEIGHBOURS, octree_leaf_index) + face];
        const uint more = neighbour == NONE ? 0u : stored_rays(neighbour);
        if (more > 0u) accumulate(neighbour, more, CDQ_MOST_NEIGHBOUR_RAYS);
    }
    barrier();
    uint migrated = 0u;
    for (; migrated < settings.migrations; ++migrated) {
        uint leaf;
        uint inner;
        search(tree, leaf, inner);
        if (leaf == NONE) break;
        const uvec4 after = cdq_migrate(tree, inner, leaf);
        if (migrated + 1u < settings.migrations || settings.memory_words > 0u) {
            move_sums(after, inner, leaf);
            barrier();
            find_children(after);
            barrier();
        }
        tree = after;
    }
    for (uint word = lane; word < min(settings.memory_words, GUIDER_SIZE / 2u); word += LANES)
        old_leaves[memory + word] = pack_sums(min(sum_of(2u * word), 1e37), min(sum_of(2u * word + 1u), 1e37));
    if (lane == 0u && migrated > 0u) {
        for (uint word = 0u; word < 4u; ++word) old_leaves[words + word] = tree[word];
        atomicAdd(work.cdq_migrations, migrated);
    }
}
#endif

#endif
