#version 460
// SPDX-License-Identifier: GPL-2.0-or-later
// Pass `vlc_merge` (paper, sections 4.1 and 4.2): one work group per old leaf joins its lights with those of its neighbours and makes the
// Visibility Light Cache of them: as few buckets as can hold them, lights in each in the order of their keys (light_table.glsl).
#extension GL_GOOGLE_include_directive : require
#include "shared/extensions.glsl"
#include "guiding/light_table.glsl"

// The lists that are joined: the leaf's own and its neighbours'.
const uint LISTS = 7u;
shared uint list_first[LISTS];
shared uint list_length[LISTS];
shared uint samples; // in the leaf and its neighbours

shared uint too_full; // a power of two is set if there cannot be that few buckets
shared uint lights;
shared uint cache_first;
shared float bucket_draws[VLC_TABLE_MOST_BUCKETS];
shared float bucket_roots[VLC_TABLE_MOST_BUCKETS];

/// The neighbour beyond a face, if this frame takes over its lights.
uint find_neighbour(uint leaf, uint face) {
    if (((settings.merge_faces >> face) & 1u) == 0u) return NONE;
    return old_leaves[leaf_word(LEAF_NEIGHBOURS, leaf) + face];
}

/// Looks up where the lists are: the leaf's own is list 0, its neighbours' are the next six. A subgroup may have fewer
/// lanes than there are lists.
/// A leaf without samples keeps what it has: its neighbours' lights are for leaves that use them.
void find_lists(uint leaf) {
    const bool used = old_leaf_count(leaf) > 0u;
    for (uint list = gl_LocalInvocationID.x; list < LISTS; list += LANES) {
        uint owner = leaf;
        if (list > 0u) owner = find_neighbour(leaf, list - 1u);
        if (owner != NONE) atomicAdd(samples, old_leaf_count(owner));
        list_length[list] = owner == NONE || !used ? 0u : old_leaves[leaf_word(LEAF_VISIBLE, owner)];
        list_first[list] = owner == NONE ? 0u : old_leaves[leaf_word(LEAF_STORAGE, owner)];
    }
}

/// By how many frames the entries of the cache of the frame before are older now: by one, if any sample could have seen the
/// light. The lights of a leaf that was split are soon forgotten by those of its parts that do not see them.
uint ageing(bool inherited) {
    if (inherited) return (7u * settings.persist + 7u) / 8u;
    return samples > 0u ? 1u : 0u;
}

/// Adds an entry of that cache, unless it is too old.
void insert_old_entry(uint table_buckets, uint entry, uint older) {
    const uint age = (entry >> VLC_AGE_SHIFT) + older;
    if (age <= settings.persist) table_insert(table_buckets, entry & VLC_ID_MASK, age);
}

void insert_old_cache(uint table_buckets, uint first, uint buckets, uint older) {
    for (uint slot = gl_LocalInvocationID.x; slot < buckets * settings.bucket; slot += LANES) {
        const uint entry = old_caches[first + slot];
        if (entry != NONE) insert_old_entry(table_buckets, entry, older);
    }
}

/// Ids in the buckets first .. end - 1 of the table.
uint joined_size(uint first, uint end) {
    uint size = 0u;
    for (uint bucket = first; bucket < end; ++bucket) size += sizes[bucket];
    return size;
}

/// Marks in `too_full` to which numbers of buckets the table cannot be brought, as one would hold more than it may.
void try_buckets(uint table_buckets, uint buckets_before) {
    for (uint level = 0u; (2u << level) <= table_buckets; ++level) {
        const uint buckets = 1u << level;
        const uint limit = buckets < buckets_before ? settings.small_bucket : settings.bucket;
        const uint joined = table_buckets / buckets;
        for (uint i = gl_LocalInvocationID.x; i < buckets; i += LANES)
            if (joined_size(i * joined, (i + 1u) * joined) > limit) atomicOr(too_full, buckets);
    }
}

/// What is known of bucket `b` of so many, from those of the cache before: a part of one of them, or several joined.
BucketMemory inherited_memory(uint b, uint buckets, uint words_before, uint buckets_before) {
    BucketMemory memory = BucketMemory(0.0, 0.0);
    for (uint old = b & (buckets_before - 1u); old < buckets_before; old += buckets) {
        const BucketMemory part = bucket_unpack(old_caches[words_before + VLC_BUCKET_WORDS * old + 1u]);
        memory.draws += part.draws;
        memory.root += part.root;
    }
    memory.draws *= min(float(buckets) / float(buckets_before), 1.0);
    if (buckets > buckets_before) memory.root *= float(buckets_before) / float(buckets);
    return memory;
}

/// Writes the words of the cache's buckets, after all that the leaf is known to have learned.
void write_bucket_words(uint words, uint buckets, uint words_before, uint buckets_before) {
    const bool knows = settings.weigh != 0u && buckets > 1u && buckets_before > 0u;
    for (uint b = gl_LocalInvocationID.x; b < buckets; b += LANES) {
        BucketMemory memory = BucketMemory(0.0, 0.0);
        if (knows) memory = inherited_memory(b, buckets, words_before, buckets_before);
        bucket_draws[b] = memory.draws;
        bucket_roots[b] = memory.root;
        vlc_lights[words + VLC_BUCKET_WORDS * b + 1u] = bucket_pack(memory);
    }
    barrier();
    if (gl_LocalInvocationID.x != 0u) return;
    float draws = 0.0;
    float weighed = 0.0;
    for (uint b = 0u; b < buckets; ++b) {
        draws += bucket_draws[b];
        weighed += bucket_draws[b] * bucket_roots[b];
    }
    const float typical = draws > 0.0 ? weighed / draws : 0.0;
    float sum = 0.0;
    for (uint b = 0u; b < buckets; ++b) {
        bucket_roots[b] = (bucket_draws[b] * bucket_roots[b] + BUCKET_DOUBT * typical) / (bucket_draws[b] + BUCKET_DOUBT);
        sum += bucket_roots[b];
    }
    const float even = sum > 0.0 ? BUCKET_EVEN : 1.0;
    float before = 0.0;
    for (uint b = 0u; b < buckets; ++b) {
        before += even / float(buckets);
        if (sum > 0.0) before += (1.0 - even) * (bucket_roots[b] / sum);
        vlc_lights[words + VLC_BUCKET_WORDS * b] = floatBitsToUint(b + 1u == buckets ? 1.0 : min(before, 1.0));
    }
}

void main() {
    const uint lane = gl_LocalInvocationID.x;
    const uint leaf = lists[merge_entry(gl_WorkGroupID.x)];
    const uint cache = leaf_word(LEAF_VLC, leaf);
    const uint buckets_before = old_leaves[cache + 1u];
    const uint lights_before = settings.persist > 0u ? old_leaves[leaf_word(LEAF_CACHED, leaf)] : 0u;
    const uint first_before = old_leaves[cache];
    if (lane == 0u) {
        samples = 0u;
        lights = 0u;
        too_full = 0u;
    }
    barrier();
    find_lists(leaf);
    barrier();

    // Join the lists. Every leaf that makes a cache may fill an equal part of the largest buffer that there may be. Lights seen last frame
    // come first: older ones are kept only where there is room for all.
    uint total = 0u;
    for (uint list = 0u; list < LISTS; ++list) total += list_length[list];
    const uint quota = header.vlc_most / (vlc_cache_words(1u, settings.bucket) * work.merge_groups.x);
    const uint most_buckets = min(table_most_buckets(), power_of_two_below(max(quota, 1u)));
    const bool keep = 3u * (total + lights_before) <= 2u * most_buckets * settings.bucket;
    const uint table_buckets = min(table_bucket_count(keep ? total + lights_before : total), most_buckets);
    table_clear(table_buckets);
    barrier();
    for (uint list = 0u; list < LISTS; ++list) {
        const uint age = list == 0u ? 0u : settings.persist - min(settings.persist, VLC_BORROWED);
        for (uint i = lane; i < list_length[list]; i += LANES) table_insert(table_buckets, light_samples[list_first[list] + i], age);
    }
    if (keep && lights_before > 0u)
        insert_old_cache(table_buckets, first_before, buckets_before,
                         ageing((old_leaves[leaf_word(LEAF_SOURCE, leaf)] & SOURCE_SPLIT) != 0u));
    barrier();

    // Join buckets, halving their number while the lights fit.
    for (uint i = lane; i < table_buckets; i += LANES)
        if (sizes[i] > 0u) atomicAdd(lights, sizes[i]);
    try_buckets(table_buckets, buckets_before);
    barrier();
    uint buckets = lights > 0u ? table_buckets : 0u;
    while (buckets > 1u && (too_full & (buckets / 2u)) == 0u) buckets /= 2u;

    // Write the cache, if there is room. If not, there is none until the host has made more.
    const uint words = vlc_cache_words(buckets, settings.bucket);
    if (lane == 0u) {
        cache_first = atomicAdd(work.vlc_used, words);
        const bool fits = cache_first + words <= header.vlc_capacity;
        const uint made = fits ? buckets : 0u;
        const uint held = fits ? lights : 0u;
        old_leaves[cache] = cache_first;
        old_leaves[cache + 1u] = made;
        old_leaves[leaf_word(LEAF_CACHED, leaf)] = held;
        if (made > 0u) atomicAdd(work.cached_leaves, 1u);
        if (made < buckets) atomicAdd(work.caches_refused, 1u);
        atomicAdd(work.cached_lights, held);
        atomicAdd(work.cached_buckets, made);
        atomicMax(work.most_lights, held);
    }
    barrier();
    if (buckets == 0u || cache_first + words > header.vlc_capacity) return;
    for (uint slot = lane; slot < buckets * settings.bucket; slot += LANES) vlc_lights[cache_first + slot] = NONE;
    memoryBarrierBuffer();
    barrier();
    write_bucket_words(bucket_words(cache_first, buckets), buckets, bucket_words(first_before, buckets_before), buckets_before);
    const uint joined = table_buckets / buckets;
    for (uint i = lane; i < table_buckets; i += LANES) {
        // This part of a bucket comes after the parts before it. Buckets lie by remainder, which is the reversed key.
        const uint part = i & (joined - 1u);
        const uint remainder = (bitfieldReverse(i / joined) >> 1u) >> (31 - findMSB(buckets));
        const uint bucket_first = cache_first + remainder * settings.bucket;
        const uint before = joined_size(i - part, i);
        for (uint k = 0u; k < sizes[i]; ++k) vlc_lights[bucket_first + before + k] = entry_of(table[i * settings.bucket + k]);
    }
}
