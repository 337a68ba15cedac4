#version 460
// SPDX-License-Identifier: GPL-2.0-or-later
// Pass `vlc_merge` (paper, sections 4.1 and 4.2): one work group per old leaf joins its lights with those of its neighbours and makes the
// Visibility Light Cache of them: as few buckets as can hold them, lights ascending in each.
#extension GL_GOOGLE_include_directive : require
#include "shared/extensions.glsl"
#include "guiding/light_table.glsl"

shared uint sizes[VLC_TABLE_MOST_BUCKETS]; // lights per bucket of the table; then per bucket of the cache
shared uint fits;
shared uint cache_first;
shared uint lights;

/// Lights that are in leaf's list and, with merging, in its neighbours' lists: list 0 is its own.
uint listed_leaf(uint leaf, uint list) {
    if (list == 0u) return leaf;
    return settings.merge != 0u ? old_leaves[leaf_word(LEAF_NEIGHBOURS, 6u, leaf) + list - 1u] : NONE;
}

/// Length of a leaf's list of visible lights; only leaves with samples have one.
uint list_length(uint leaf) {
    if (leaf == NONE || old_leaf_count(leaf) == 0u) return 0u;
    return old_leaves[leaf_word(LEAF_VISIBLE, 1u, leaf)];
}

/// Joins buckets i and i + half while none gets more lights than it may hold; returns their number.
uint merge_buckets(uint buckets, uint buckets_before) {
    const uint lane = gl_LocalInvocationID.x;
    while (buckets > 1u) {
        const uint half_count = buckets / 2u;
        const uint limit = half_count < buckets_before ? settings.small_bucket : settings.bucket;
        if (lane == 0u) fits = 1u;
        barrier();
        for (uint i = lane; i < half_count; i += LANES)
            if (sizes[i] + sizes[i + half_count] > limit) fits = 0u;
        barrier();
        const bool merge = fits != 0u;
        barrier();
        if (!merge) break;
        for (uint i = lane; i < half_count; i += LANES) sizes[i] += sizes[i + half_count];
        barrier();
        buckets = half_count;
    }
    return buckets;
}

/// How many lights of the same cache bucket have smaller ids than the one at table bucket `home`.
uint rank_of(uint id, uint home, uint buckets, uint table_buckets) {
    uint rank = 0u;
    for (uint bucket = home & (buckets - 1u); bucket < table_buckets; bucket += buckets) {
        const uint first = bucket * settings.bucket;
        for (uint i = 0u; i < settings.bucket && table[first + i] < id; ++i) ++rank;
    }
    return rank;
}

void main() {
    const uint lane = gl_LocalInvocationID.x;
    const uint leaf = leaf_lists[leaf_capacity() + gl_WorkGroupID.x];
    const uint cache = leaf_word(LEAF_VLC, 2u, leaf);

    // Join the lists. Every leaf may fill an equal part of the buffer: it never runs out.
    uint total = 0u;
    for (uint list = 0u; list < 7u; ++list) total += list_length(listed_leaf(leaf, list));
    const uint quota = header.vlc_capacity / (settings.bucket * (7u * old_node_count + 1u));
    const uint table_buckets = min(table_bucket_count(total), power_of_two_below(max(quota, 1u)));
    table_clear(table_buckets);
    if (lane == 0u) lights = 0u;
    barrier();
    for (uint list = 0u; list < 7u; ++list) {
        const uint source = listed_leaf(leaf, list);
        const uint length = list_length(source);
        if (length == 0u) continue;
        const uint first = old_leaves[leaf_word(LEAF_STORAGE, 2u, source)];
        for (uint i = lane; i < length; i += LANES) table_insert(table_buckets, light_samples[first + i]);
    }
    barrier();

    // Join buckets.
    for (uint i = lane; i < table_buckets; i += LANES) {
        sizes[i] = table_bucket_size(i);
        if (sizes[i] > 0u) atomicAdd(lights, sizes[i]);
    }
    const uint buckets_before = old_leaves[cache + 1u];
    barrier();
    if (lights == 0u) {
        if (lane == 0u) old_leaves[cache + 1u] = 0u;
        return;
    }
    const uint buckets = merge_buckets(table_buckets, buckets_before);

    // Write the cache.
    if (lane == 0u) {
        cache_first = atomicAdd(work.vlc_used, buckets * settings.bucket);
        old_leaves[cache] = cache_first;
        old_leaves[cache + 1u] = buckets;
        atomicAdd(work.cached_leaves, 1u);
        atomicAdd(work.cached_lights, lights);
        atomicAdd(work.cached_buckets, buckets);
        atomicMax(work.most_lights, lights);
    }
    barrier();
    for (uint slot = lane; slot < table_buckets * settings.bucket; slot += LANES) {
        const uint id = table[slot];
        if (id == NONE) continue;
        const uint home = slot / settings.bucket;
        const uint rank = rank_of(id, home, buckets, table_buckets);
        vlc_lights[cache_first + (home & (buckets - 1u)) * settings.bucket + rank] = id;
    }
    for (uint slot = lane; slot < buckets * settings.bucket; slot += LANES)
        if (slot % settings.bucket >= sizes[slot / settings.bucket]) vlc_lights[cache_first + slot] = NONE;
}
