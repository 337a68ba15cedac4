// SPDX-License-Identifier: GPL-2.0-or-later
// A set of light ids in shared memory (paper, section 4.1): a hash table of buckets, where a bucket holds the ids with equal remainder,
// ascending. Work groups fill it together; the result does not depend on the order in which they do: a full bucket
// keeps its smallest ids.
#ifndef VIGIL_GUIDING_LIGHT_TABLE_GLSL
#define VIGIL_GUIDING_LIGHT_TABLE_GLSL

#include "guiding/passes.glsl"

const uint LANES = 64u;
layout(local_size_x = LANES) in;

shared uint table[VLC_TABLE_SIZE]; // bucket after bucket of settings.bucket slots; NONE: free

/// Largest power of two that is at most `value`, which is at least 1.
uint power_of_two_below(uint value) { return 1u << uint(findMSB(value)); }

/// Number of buckets for a set made from `count` ids: four times the room that they need at most.
uint table_bucket_count(uint count) {
    const uint wanted = max((4u * count + settings.bucket - 1u) / settings.bucket, 1u);
    const uint most = power_of_two_below(min(VLC_TABLE_MOST_BUCKETS, VLC_TABLE_SIZE / settings.bucket));
    return wanted >= most ? most : 1u << uint(findMSB(2u * wanted - 1u));
}

/// Empties the first `buckets` buckets. The caller puts barriers before and after.
void table_clear(uint buckets) {
    for (uint slot = gl_LocalInvocationID.x; slot < buckets * settings.bucket; slot += LANES) table[slot] = NONE;
}

/// Adds an id, unless it is there. Each slot keeps the smallest id that reaches it and hands on the others: after all
/// insertions slot k holds the k-th smallest id of its bucket.
void table_insert(uint buckets, uint id) {
    const uint first = (id & (buckets - 1u)) * settings.bucket;
    const uint end = first + settings.bucket;
    for (uint slot = first; slot < end; ++slot) {
        uint seen = table[slot];
        if (seen == id) return;
        if (seen > id) {
            seen = atomicMin(table[slot], id);
            if (seen == id || seen == NONE) return;
            id = max(id, seen);
        }
    }
    atomicAdd(work.lights_left_out, 1u);
}

/// Number of ids in a bucket.
uint table_bucket_size(uint bucket) {
    const uint first = bucket * settings.bucket;
    uint size = 0u;
    while (size < settings.bucket && table[first + size] != NONE) ++size;
    return size;
}

#endif
