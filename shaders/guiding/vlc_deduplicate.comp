#version 460
// SPDX-License-Identifier: GPL-2.0-or-later
// Pass `vlc_deduplicate` (paper, section 4.1): one work group per old leaf with samples extracts the different lights among its visible
// ones, and writes them over the samples; and takes in how the leaf's draws fared.
#extension GL_GOOGLE_include_directive : require
#include "shared/extensions.glsl"
#include "guiding/light_table.glsl"

shared uint found;
// Of this lane's draws: how many walked lists and how many buckets, and the sums of their squared estimates.
shared vec4 draws[LANES];

void count_draw(uint light_sample) {
    const float estimate = (light_sample & LIGHT_SAMPLE_VISIBLE) != 0u ? light_sample_estimate(light_sample) : 0.0;
    const vec2 draw = vec2(1.0, estimate * estimate);
    switch (light_sample & LIGHT_SAMPLE_DRAWN) {
    case LIGHT_SAMPLE_LISTED:
        // A light that appeared was in no cache, and is in the next: it does not tell what caches lack.
        if (settings.appeared == 0u) draws[gl_LocalInvocationID.x].xy += draw;
        break;
    case LIGHT_SAMPLE_CACHED: draws[gl_LocalInvocationID.x].zw += draw; break;
    }
}

// Draws from each bucket of the leaf's cache, and their squared estimates where they saw a light: in units that make a bucket's greatest
// GREATEST_SQUARE, so that sums do not depend on the order.
shared uint bucket_draws[VLC_TABLE_MOST_BUCKETS];
shared uint bucket_squares[VLC_TABLE_MOST_BUCKETS];
shared uint bucket_greatest[VLC_TABLE_MOST_BUCKETS]; // exponent of the greatest estimate + 1; 0: none
const uint GREATEST_SQUARE = 1u << 19;

bool from_cache(uint light_sample) { return (light_sample & LIGHT_SAMPLE_DRAWN) == LIGHT_SAMPLE_CACHED; }

/// Takes in what the draws from each bucket brought. Parts of a leaf that was split share a cache, and leave it as it is.
void remember_buckets(uint leaf, uint first, uint kept, uint processed) {
    const uint cache = leaf_word(LEAF_VLC, leaf);
    const uint buckets = old_leaves[cache + 1u];
    if (settings.weigh == 0u || buckets < 2u || (old_leaves[leaf_word(LEAF_SOURCE, leaf)] & SOURCE_SPLIT) != 0u) return;
    for (uint b = gl_LocalInvocationID.x; b < buckets; b += LANES) bucket_draws[b] = bucket_squares[b] = bucket_greatest[b] = 0u;
    barrier();
    for (uint i = gl_LocalInvocationID.x; i < processed; i += LANES) {
        const uint light_sample = light_samples[first + spread_place(i, kept, processed)];
        if (!from_cache(light_sample)) continue;
        const uint b = light_sample & (buckets - 1u);
        atomicAdd(bucket_draws[b], 1u);
        if ((light_sample & LIGHT_SAMPLE_VISIBLE) != 0u) atomicMax(bucket_greatest[b], light_sample_exponent(light_sample) + 1u);
    }
    barrier();
    for (uint i = gl_LocalInvocationID.x; i < processed; i += LANES) {
        const uint light_sample = light_samples[first + spread_place(i, kept, processed)];
        if (!from_cache(light_sample) || (light_sample & LIGHT_SAMPLE_VISIBLE) == 0u) continue;
        const uint b = light_sample & (buckets - 1u);
        const uint halvings = min(2u * (bucket_greatest[b] - 1u - light_sample_exponent(light_sample)), 31u);
        atomicAdd(bucket_squares[b], GREATEST_SQUARE >> halvings);
    }
    barrier();
    const uint words = bucket_words(old_leaves[cache], buckets);
    for (uint b = gl_LocalInvocationID.x; b < buckets; b += LANES) {
        const uint word = words + VLC_BUCKET_WORDS * b;
        const float before = b == 0u ? 0.0 : uintBitsToFloat(old_caches[word - VLC_BUCKET_WORDS]);
        const float probability = max(uintBitsToFloat(old_caches[word]) - before, 0.0);
        // The unit's root: its square may be too large for a float, or too small.
        const float unit = probability * exp2(float(bucket_greatest[b]) - 65.0);
        const float drawn = float(bucket_draws[b]);
        const float root = unit * sqrt(float(bucket_squares[b]) / (float(GREATEST_SQUARE) * max(drawn, 1.0)));
        old_caches[word + 1u] = bucket_pack(bucket_update(bucket_unpack(old_caches[word + 1u]), drawn, root));
    }
}

void remember_draws(uint leaf) {
    vec4 sums = vec4(0.0);
    for (uint i = 0u; i < LANES; ++i) sums += draws[i];
    const uint memory = leaf_word(LEAF_EXPLORE, leaf);
    const uvec2 words =
        explore_pack(explore_update(explore_unpack(uvec2(old_leaves[memory], old_leaves[memory + 1u])), sums.x, sums.y, sums.z, sums.w));
    old_leaves[memory] = words.x;
    old_leaves[memory + 1u] = words.y;
}

void main() {
    const uint lane = gl_LocalInvocationID.x;
    const uint leaf = lists[deduplicate_entry(gl_WorkGroupID.x)];
    const uint storage = leaf_word(LEAF_STORAGE, leaf);
    const uint first = old_leaves[storage];
    const uint kept = min(old_leaf_count(leaf), old_leaves[storage + 1u]);
    const uint processed = min(kept, VLC_MOST_SAMPLES);
    const uint buckets = table_bucket_count(processed);

    table_clear(buckets);
    if (lane == 0u) found = 0u;
    draws[lane] = vec4(0.0);
    barrier();
    for (uint i = lane; i < processed; i += LANES) {
        const uint light_sample = light_samples[first + spread_place(i, kept, processed)];
        count_draw(light_sample);
        if ((light_sample & LIGHT_SAMPLE_VISIBLE) != 0u) table_insert(buckets, light_sample & LIGHT_SAMPLE_ID_MASK, 0u);
    }
    remember_buckets(leaf, first, kept, processed);
    barrier();
    for (uint bucket = lane; bucket < buckets; bucket += LANES) {
        const uint list = first + atomicAdd(found, sizes[bucket]);
        for (uint i = 0u; i < sizes[bucket]; ++i) light_samples[list + i] = id_of(table[bucket * settings.bucket + i]);
    }
    barrier();
    if (lane != 0u) return;
    old_leaves[leaf_word(LEAF_VISIBLE, leaf)] = found;
    remember_draws(leaf);
    atomicAdd(work.sampled_leaves, 1u);
}
