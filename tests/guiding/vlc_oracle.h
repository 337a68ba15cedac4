// SPDX-License-Identifier: GPL-2.0-or-later
// The construction of Visibility Light Caches as the paper describes it (section 4.1 and the bucket
// merging of 4.2), for tests: sets of light ids. Where the passes must drop lights (a full table, a
// full buffer), this drops those that the passes promise to drop, the largest ids of a bucket. It
// knows nothing of work groups and shared memory.
#pragma once

#include "octree_oracle.h"

#include <span>

namespace vigil::test {

/// The order of light ids in caches: the lowest bit in which two differ decides. Sets of ids that
/// leave the same remainder for a power of two are intervals of this order.
struct LowBitsFirst {
    bool operator()(uint32_t a, uint32_t b) const;
};
using Lights = std::set<uint32_t, LowBitsFirst>;

/// Frames since a light was seen.
using Ages = std::map<uint32_t, uint32_t, LowBitsFirst>;

/// Lights of one cache: bucket b holds those whose id leaves the remainder b.
using Buckets = std::vector<Lights>;

struct CacheLimits {
    uint32_t bucket;       // most lights in a bucket
    uint32_t small_bucket; // the same where there would be fewer buckets than in the frame before
    uint32_t merge_faces;  // bit i: take over lights of the neighbour beyond face i
    uint32_t vlc_capacity; // light ids that fit in all caches
    bool weigh = false;    // buckets are drawn by what draws brought
    uint32_t persist = 0;  // frames that lights stay after they were seen; 0: as in the paper
    bool appeared = false; // a light appeared in the frame: draws from lists do not count
};

/// What draws were worth (guiding_types.h, ExploreMemory).
struct Explored {
    double listed = 0.0, found = 0.0, cached = 0.0, share = 0.0;
};

/// How a bucket of a cache is drawn (guiding_types.h, VLC_BUCKET_WORDS), and what that follows
/// from.
struct BucketDraw {
    double until = 1.0;             // probability of it and of those before it
    double draws = 0.0, root = 0.0; // remembered; root mean square of what they brought
};
using BucketDraws = std::vector<BucketDraw>;

/// What is known of a leaf before its cache is made.
struct LeafSamples {
    std::span<const uint32_t> kept; // as stored (LIGHT_SAMPLE_*)
    uint32_t count = 0;             // samples, stored or not
    uint32_t previous_buckets = 0;  // of the leaf's cache in the frame before
    Ages previous;                  // the lights in it
    bool inherited = false;         // it was made for a larger leaf
    Explored explored{};
    BucketDraws drawn{}; // of the cache before
};

struct Cache {
    Lights own;      // different lights that the leaf's samples saw
    Buckets buckets; // own and neighbours' lights; none if there are no lights
    Ages ages;       // of the lights in buckets
    Explored explored{};
    BucketDraws drawn; // of the buckets
};

struct Caches {
    ByPath<Cache> by_leaf;
    bool lights_left_out = false; // a table was full
};

/// Caches of all leaves of a tree. `samples` has an entry for every leaf.
Caches make_caches(const InnerNodes& inner, const ByPath<LeafSamples>& samples,
                   const CacheLimits& limits);

/// Places of the samples that are looked at, of `kept`: all, or `most` that are spread evenly.
std::vector<size_t> sample_places(size_t kept, size_t most);

/// Buckets of the hash table for at most `entries` light ids: one and a half times as many as hold
/// them, at least.
uint32_t table_buckets(uint32_t entries, uint32_t bucket);

} // namespace vigil::test
