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
    case LIGHT_SAMPLE_LISTED: draws[gl_LocalInvocationID.x].xy += draw; break;
    case LIGHT_SAMPLE_CACHED: draws[gl_LocalInvocationID.x].zw += draw; break;
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
    const uint leaf = leaf_lists[gl_WorkGroupID.x];
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
