#version 460
// SPDX-License-Identifier: GPL-2.0-or-later
// Pass `vlc_deduplicate` (paper, section 4.1): one work group per old leaf with samples extracts the different lights among its visible
// ones, and writes them over the samples.
#extension GL_GOOGLE_include_directive : require
#include "shared/extensions.glsl"
#include "guiding/light_table.glsl"

shared uint found;

void main() {
    const uint lane = gl_LocalInvocationID.x;
    const uint leaf = leaf_lists[gl_WorkGroupID.x];
    const uint storage = leaf_word(LEAF_STORAGE, 2u, leaf);
    const uint first = old_leaves[storage];
    const uint kept = min(old_leaf_count(leaf), old_leaves[storage + 1u]);
    const uint processed = min(kept, VLC_MOST_SAMPLES);
    const uint stride = kept / max(processed, 1u);
    const uint buckets = table_bucket_count(processed);

    table_clear(buckets);
    if (lane == 0u) found = 0u;
    barrier();
    for (uint i = lane; i < processed; i += LANES) {
        const uint light_sample = light_samples[first + i * stride];
        if ((light_sample & LIGHT_SAMPLE_VISIBLE) != 0u) table_insert(buckets, light_sample & VLC_ID_MASK, 0u);
    }
    barrier();
    for (uint bucket = lane; bucket < buckets; bucket += LANES) {
        const uint list = first + atomicAdd(found, sizes[bucket]);
        for (uint i = 0u; i < sizes[bucket]; ++i) light_samples[list + i] = id_of(table[bucket * settings.bucket + i]);
    }
    barrier();
    if (lane != 0u) return;
    old_leaves[leaf_word(LEAF_VISIBLE, 1u, leaf)] = found;
    atomicAdd(work.sampled_leaves, 1u);
}
