// SPDX-License-Identifier: GPL-2.0-or-later
// A set of light ids in shared memory (paper, section 4.1): a hash table whose buckets hold the ids with equal remainder. Ids are ordered
// by their bits from the lowest on, that is by their reversal, the key: for any power of two, ids with equal remainder
// then follow each other, so joining buckets is joining neighbours, and stays sorted. Work groups fill the
// table together; the result does not depend on the order in which they do: a full bucket keeps its smallest keys.
#ifndef VIGIL_GUIDING_LIGHT_TABLE_GLSL
#define VIGIL_GUIDING_LIGHT_TABLE_GLSL

#include "guiding/passes.glsl"

// The host makes a work group one subgroup, if that has VLC_LEAST_LANES: barriers are cheap then, and most tables small.
layout(local_size_x_id = CONSTANT_GROUP_SIZE) in;
const uint LANES = gl_WorkGroupSize.x;

shared uint table[VLC_TABLE_SIZE];         // keys, bucket after bucket of settings.bucket slots; NONE: free
shared uint sizes[VLC_TABLE_MOST_BUCKETS]; // ids per bucket

/// Largest power of two that is at most `value`, which is at least 1.
uint power_of_two_below(uint value) { return 1u << uint(findMSB(value)); }

/// Number of buckets that a table can have.
uint table_most_buckets() { return power_of_two_below(min(VLC_TABLE_MOST_BUCKETS, VLC_TABLE_SIZE / settings.bucket)); }

/// Number of buckets for a set made from `count` ids: half as much room again as they need, at least, as buckets do not
/// fill evenly.
uint table_bucket_count(uint count) {
    const uint wanted = max((3u * count + 2u * settings.bucket - 1u) / (2u * settings.bucket), 1u);
    const uint most = table_most_buckets();
    return wanted >= most ? most : 1u << uint(findMSB(2u * wanted - 1u));
}

/// Empties the first `buckets` buckets. The caller puts barriers before and after.
void table_clear(uint buckets) {
    for (uint slot = gl_LocalInvocationID.x; slot < buckets * settings.bucket; slot += LANES) table[slot] = NONE;
    for (uint bucket = gl_LocalInvocationID.x; bucket < buckets; bucket += LANES) sizes[bucket] = 0u;
}

// A key also carries its light's age, in the lowest bits, which the reversed id leaves free.
const uint KEY_AGE_MASK = (1u << (32u - VLC_AGE_SHIFT)) - 1u;

uint key_of(uint id, uint age) { return bitfieldReverse(id) | age; }
uint id_of(uint key) { return bitfieldReverse(key & ~KEY_AGE_MASK); }
/// As a cache stores it.
uint entry_of(uint key) { return id_of(key) | ((key & KEY_AGE_MASK) << VLC_AGE_SHIFT); }
/// Whether two keys stand for the same light.
bool same_light(uint a, uint b) { return ((a ^ b) & ~KEY_AGE_MASK) == 0u; }

/// First bits of a key: the bucket that it belongs to if there are `buckets`.
uint bucket_of(uint key, uint buckets) { return (key >> 1u) >> (31 - findMSB(buckets)); }

/// Adds a light; one that is there already gets the lower of both ages. Each slot keeps the smallest key that reaches it and
/// hands on the others: after all insertions slot k holds the k-th smallest key of its bucket.
void table_insert(uint buckets, uint id, uint age) {
    uint key = key_of(id, age);
    const uint bucket = bucket_of(key, buckets);
    const uint first = bucket * settings.bucket;
    const uint end = first + settings.bucket;
    for (uint slot = first; slot < end; ++slot) {
        uint seen = table[slot];
        if (seen <= key && same_light(seen, key)) return;
        if (seen > key) {
            seen = atomicMin(table[slot], key);
            if (seen == NONE) {
                atomicAdd(sizes[bucket], 1u);
                return;
            }
            if (same_light(seen, key)) return;
            key = max(key, seen);
        }
    }
    atomicAdd(work.lights_left_out, 1u);
}

#endif
