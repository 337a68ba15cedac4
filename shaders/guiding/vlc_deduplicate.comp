#version 460
// SPDX-License-Identifier: GPL-2.0-or-later
// Pass `vlc_deduplicate` (paper, section 4.1): one work group per old leaf with samples extracts the different lights among its visible
// ones, and writes them over the samples; and takes in how the leaf's draws fared.
#extension GL_GOOGLE_include_directive : require
#include "shared/extensions.glsl"
#include "guiding/light_table.glsl"

shared uint found;
// Sums of this lane's draws.
shared float listed[LANES], known[LANES], newly_found[LANES];
shared uint drawn, seen;

void count_draw(uint light_sample) {
    const uint lane = gl_LocalInvocationID.x;
    const bool visible = (light_sample & LIGHT_SAMPLE_VISIBLE) != 0u;
    const float estimate = light_sample_estimate(light_sample);
    switch (light_sample & LIGHT_SAMPLE_DRAWN) {
    case LIGHT_SAMPLE_CACHED:
        atomicAdd(drawn, 1u);
        if (visible) atomicAdd(seen, 1u);
        break;
    case LIGHT_SAMPLE_LISTED:
        listed[lane] += 1.0;
        if (visible) newly_found[lane] += estimate * estimate;
        break;
    case LIGHT_SAMPLE_KNOWN:
        listed[lane] += 1.0;
        known[lane] += estimate;
        break;
    }
}

void remember_draws(uint leaf) {
    float sums[3] = float[](0.0, 0.0, 0.0);
    for (uint i = 0u; i < LANES; ++i) {
        sums[0] += listed[i];
        sums[1] += known[i];
        sums[2] += newly_found[i];
    }
    const uint memory = leaf_word(LEAF_EXPLORE, leaf);
    const uvec2 words = explore_pack(
        explore_update(explore_unpack(uvec2(old_leaves[memory], old_leaves[memory + 1u])), sums[0], sums[1], sums[2], drawn, seen));
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
    const uint stride = kept / max(processed, 1u);
    const uint buckets = table_bucket_count(processed);

    table_clear(buckets);
    if (lane == 0u) found = drawn = seen = 0u;
    listed[lane] = known[lane] = newly_found[lane] = 0.0;
    barrier();
    for (uint i = lane; i < processed; i += LANES) {
        const uint light_sample = light_samples[first + i * stride];
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
