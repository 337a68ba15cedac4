// SPDX-License-Identifier: GPL-2.0-or-later
// Technique `vlc`: the Visibility Light Cache (paper, section 4.2 and algorithm 1). A bucket of the surface's cache is drawn, and in it a light in
// proportion to its importance. With the probability pt_vlc_explore, or a larger one (explore_total), a second draw looks for lights that no
// sample has seen lately:
//   - pt_explore_local of these are from the light cut of the surface's PVS cluster (cut_draw.glsl). Where such draws find much that the cache lacks
//     (more lights than a leaf has samples for), or where there is no cache, more of them are made (pt_vlc_adapt, ExploreMemory);
//   - the others take any light of the level from a table weighted anew each frame (paper, section 4.3).
// What the cache has already is left out, or thrown away: no light needs the probabilities of two draws, and what the cache draws well has no noise
// of exploration. With pt_vlc_beside 0 these draws take the place of others, as in the paper, and the table draws the cache's lights, too.
// Where no caches are made (HAS_CACHES), as most light is in sight, every draw is from the cut, and nothing is learned.
// A draw from the cache walks past at most pt_vlc_bucket lights. The paper has the table alone, and names it a limitation that it knows
// nothing of the surface: a light that no sample has found yet then costs its power over a tiny probability. A cut gives it its importance here.
// Host side: refresh/vkpt/light/vlc.cpp and refresh/vkpt/guiding.
#include "guiding/octree.glsl"
#include "light/alias.glsl"
#include "light/importance.glsl"

layout(constant_id = CONSTANT_CACHES) const bool HAS_CACHES = true;

#define LEARNS_FROM_LIGHT_SAMPLES uint(HAS_CACHES)
#define STORES_LIGHT_SAMPLES uint(HAS_CACHES)
#define DRAWS_BESIDE uint(HAS_CACHES)

uint bucket_size() { return uint(frame.settings.pt_vlc_bucket); }

/// The lights that a surface's cache holds: `buckets` buckets of bucket_size() each, a power of two; a light is in that of its
/// id's remainder.
struct LightCache {
    uint first;
    uint buckets; // 0: nothing was seen here
};

LightCache find_light_cache(uint leaf) {
    const uint cache = leaf_word(LEAF_VLC, leaf);
    return LightCache(load_word(leaf_words, cache), load_word(leaf_words, cache + 1u));
}

/// Word of the probability that bucket `b`, or one before it, is drawn.
uint bucket_word(LightCache cache, uint b) { return cache.first + cache.buckets * bucket_size() + VLC_BUCKET_WORDS * b; }

float bucket_probability(LightCache cache, uint b) {
    const float before = b == 0u ? 0.0 : uintBitsToFloat(load_word(vlc_words, bucket_word(cache, b - 1u)));
    return uintBitsToFloat(load_word(vlc_words, bucket_word(cache, b))) - before;
}

/// Draws a bucket by `u`, in [0, 1): bisection.
uint draw_bucket(LightCache cache, float u) {
    uint b = 0u;
    for (uint steps = cache.buckets / 2u; steps > 0u; steps /= 2u)
        if (!(u < uintBitsToFloat(load_word(vlc_words, bucket_word(cache, b + steps - 1u))))) b += steps;
    return b;
}

/// Of a cache that has any.
uint bucket_of_light(LightCache cache, uint light) { return light & (cache.buckets - 1u); }

/// Word of its first light.
uint bucket_start(LightCache cache, uint bucket) { return cache.first + bucket * bucket_size(); }

/// Whether a light is in the cache: bisection, as the lights of a bucket lie in the order of their reversed ids.
bool is_cached(LightCache cache, uint light) {
    if (cache.buckets == 0u) return false;
    const uint sought = bitfieldReverse(light);
    uint first = bucket_start(cache, bucket_of_light(cache, light));
    for (uint count = bucket_size(); count > 1u;) {
        const uint half_count = count / 2u;
        const uint entry = load_word(vlc_words, first + half_count);
        const bool above = entry != NONE && bitfieldReverse(entry & VLC_ID_MASK) <= sought;
        first += above ? half_count : 0u;
        count = above ? count - half_count : half_count;
    }
    const uint entry = load_word(vlc_words, first);
    return entry != NONE && (entry & VLC_ID_MASK) == light;
}

/// The cache whose lights draws from cuts leave out where they weigh single lights.
LightCache left_out = LightCache(0u, 0u);

float cut_light_weight(LtcSurface surface, uint light) {
    const float importance = light_importance(surface, light);
    return importance > 0.0 && is_cached(left_out, light) ? 0.0 : importance;
}

#include "light/cut_draw.glsl"

/// Everything that the draws of a surface have in common.
struct LightSearch {
    LtcSurface prepared;
    LightCache cache;
    LightCut cut;
};

LightSearch prepare_search(Surface surface, uint leaf) {
    LightSearch search;
    search.prepared = prepare_importance(surface);
    search.cache = find_light_cache(leaf);
    search.cut = find_cut(surface);
    return search;
}

/// How many draws of each kind are made on average.
struct Shares {
    float cache;
    float cut;
    float table;
};

/// Of `total` draws outside of the cache.
Shares explore_shares(LightSearch search, float total) {
    const float local = alias_count() == 0u ? 1.0 : frame.settings.pt_explore_local;
    if (cut_size(search.cut) == 0u || local == 0.0) return Shares(0.0, 0.0, total);
    const float table = min(frame.settings.pt_vlc_explore, total) * (1.0 - local);
    return Shares(0.0, total - table, table);
}

bool draws_beside() { return frame.settings.pt_vlc_beside != 0; }

/// Root of the time of a frame over that of draws beside the cache's in all its pixels.
const float BESIDE_FACTOR = 1.5;
/// Draws per surface where there is no cache, as lately no draw found a light.
const float DARK_TOTAL = 0.25;
/// Draws per surface beside a cache of which nothing else is known yet. Twice as many hardly learn sooner (docs/research/history.md).
const float UNKNOWN_TOTAL = 0.5;

/// Draws outside of the cache. Those made in place of others get the share a that ExploreMemory stores. Beside others, draws from cuts in a part b
/// of the pixels bring the second moment M / b and take the time b x, where all else has K and takes t; the product of the sums is least for
/// b = sqrt(M / K) sqrt(t / x), of which the first factor is a / (1 - a). What no draw has met yet is not in M, so pt_vlc_explore is the least.
/// Until M is known, half of all draws are made, and all where there is no cache. All are made in the frame in which a light appears: no cache can
/// have it.
float explore_total(LightSearch search, uint leaf) {
    const float explore = frame.settings.pt_vlc_explore;
    const bool none = search.cache.buckets == 0u;
    if (frame.settings.pt_vlc_adapt == 0 || explore == 0.0) return none ? 1.0 : explore;
    const uint words = leaf_word(LEAF_EXPLORE, leaf);
    const ExploreMemory memory = explore_unpack(uvec2(load_word(leaf_words, words), load_word(leaf_words, words + 1u)));
    if (!draws_beside()) return none ? 1.0 : max(explore, memory.share);
    if (guiding.explores != 0u) return 1.0;
    const float known = min(memory.listed / EXPLORE_DRAWS, 1.0); // how well M is
    const float wanted = BESIDE_FACTOR * memory.share / (1.0 - memory.share);
    return max(max(explore, min(wanted, 1.0)), none ? mix(1.0, DARK_TOTAL, known) : UNKNOWN_TOTAL * (1.0 - known));
}

/// Shares of a surface's first draw, or of one beside it that is made with the probability `beside` > 0. Where nothing is drawn from the cache,
/// its lights must not be left to it: then it counts as empty.
Shares draw_shares(inout LightSearch search, uint leaf, float beside) {
    if (beside > 0.0) return explore_shares(search, beside);
    if (draws_beside()) return Shares(1.0, 0.0, 0.0);
    const float total = explore_total(search, leaf);
    Shares shares = explore_shares(search, total);
    shares.cache = 1.0 - total;
    if (!(shares.cache > 0.0)) search.cache.buckets = 0u;
    return shares;
}

/// Lights to walk past: a bucket of a cache.
struct Candidates {
    uint first, end, stride; // in vlc_words
    LtcSurface prepared;
};

uint candidate_light(Candidates candidates, uint i) {
    const uint entry = load_word(vlc_words, i);
    return entry == NONE ? NONE : entry & VLC_ID_MASK;
}

float candidate_weight(Candidates candidates, uint light) { return light_importance(candidates.prepared, light); }

#include "light/candidate_walk.glsl"

Candidates bucket_candidates(LightSearch search, uint bucket) {
    const uint first = bucket_start(search.cache, bucket);
    return Candidates(first, first + bucket_size(), 1u, search.prepared);
}

/// Draws a light by `u`, in [0, 1), or finds the probability of one that the cache lacks.
CutDraw draw_uncached(LightSearch search, uint sought, vec3 u) {
    left_out = search.cache;
    return draw_from_cut(search.cut, search.prepared, sought, u);
}

/// Probability of a light of the cache, after the walk past its bucket.
float cached_probability(LightSearch search, Shares shares, uint bucket, CandidateWalk walk) {
    return walk.weight > 0.0 ? shares.cache * bucket_probability(search.cache, bucket) * walk.weight / walk.sum : 0.0;
}

/// Where there are no caches: a draw by `u`, in [0, 1), or the probability of `sought`, unless that is NONE.
CutDraw draw_without_caches(Surface surface, uint sought, vec3 u) {
    return draw_from_cut(find_cut(surface), prepare_importance(surface), sought, u);
}

LightChoice draw_light(Surface surface, float beside, inout Random random) {
    if (!HAS_CACHES) {
        const CutDraw draw = draw_without_caches(surface, NONE, random_next3(random));
        if (draw.probability > 0.0) return light_choice(draw.light, draw.probability);
        return no_light();
    }
    const SurfaceLeaves found = find_leaves(surface.position, previous_position(surface));
    LightSearch search = prepare_search(surface, found.cache);
    const Shares shares = draw_shares(search, found.cache, beside);
    const vec3 u = random_next3(random);
    const uvec2 bits = random_next_bits(random);

    const float kind = beside > 0.0 ? u.x * beside : u.x - shares.cache; // below 0: the cache
    const bool from_cache = kind < 0.0;
    const bool from_cut = !from_cache && kind < shares.cut;
    const uint tabled = from_cache || from_cut ? NONE : alias_light(bits);
    const bool cached = from_cache || (tabled != NONE && is_cached(search.cache, tabled));
    uint bucket = 0u;
    uint light = tabled;
    float probability = 0.0, estimate = 0.0;
    if (cached) {
        if (search.cache.buckets > 0u) {
            bucket = from_cache ? draw_bucket(search.cache, u.y) : bucket_of_light(search.cache, tabled);
            const CandidateWalk walk = walk_candidates(bucket_candidates(search, bucket), tabled, u.z);
            light = walk.light;
            probability = cached_probability(search, shares, bucket, walk);
            estimate = walk.sum / bucket_probability(search.cache, bucket);
        }
    } else if (shares.cut > 0.0) {
        const CutDraw draw = draw_uncached(search, tabled, random_next3(random));
        if (from_cut) light = draw.light;
        probability = shares.cut * draw.probability;
        if (draw.probability > 0.0) estimate = draw.weight / draw.probability;
    }
    if (light != NONE) probability += shares.table * alias_probability(light);

    LightChoice choice = weighted_choice(light, 0.0);
    choice.explored = !from_cache;
    choice.memory = uvec2(found.samples, from_cut ? LIGHT_SAMPLE_LISTED : LIGHT_SAMPLE_TABLED);
    if (from_cache && search.cache.buckets > 0u) choice.memory.y = LIGHT_SAMPLE_CACHED;
    if (from_cache && draws_beside()) {
        choice.beside = explore_total(search, found.cache);
        choice.least = frame.settings.pt_vlc_explore;
    }
    // Nothing is learned from a draw of no cache. The surface counts by the one beside it.
    if (from_cache && search.cache.buckets == 0u && choice.beside >= 1.0) choice.memory.x = NONE;
    choice.memory.y |= light_sample_pack_estimate(finite_or_zero(estimate));
    if (choice.light == NONE) {
        // What is not seen says by its last bits which bucket it was drawn from.
        choice.memory.y |= from_cache ? bucket : LIGHT_SAMPLE_NONE;
        return choice;
    }
    choice.memory.y |= min(choice.light, LIGHT_SAMPLE_NONE); // one of too many to remember
    // A light of zero probability cannot be drawn, but rounding in the reservoir may come close to it. Beside the cache none of its lights is drawn:
    // cuts leave them out, and what the table draws of them is thrown away.
    if (probability > 0.0 && !(beside > 0.0 && cached)) choice.weight = 1.0 / probability;
    else choice.light = NONE;
    return choice;
}

void learn_light(LightChoice choice, uint outcome) {
    if (choice.memory.x == NONE) return;
    store_light_sample(choice.memory.x, choice.memory.y | (outcome == LIGHT_SEEN ? LIGHT_SAMPLE_VISIBLE : 0u));
}

float light_probability(Surface surface, uint light) {
    if (!HAS_CACHES) return draw_without_caches(surface, light, vec3(0.0)).probability;
    const uint leaf = find_leaves(surface.position, previous_position(surface)).cache;
    LightSearch search = prepare_search(surface, leaf);
    const float beside = draws_beside() && !is_cached(search.cache, light) ? explore_total(search, leaf) : 0.0;
    const Shares shares = draw_shares(search, leaf, beside);
    const float tabled = shares.table * alias_probability(light);
    if (is_cached(search.cache, light)) {
        const uint bucket = bucket_of_light(search.cache, light);
        return tabled + cached_probability(search, shares, bucket, walk_candidates(bucket_candidates(search, bucket), light, 0.0));
    }
    return tabled + (shares.cut > 0.0 ? shares.cut * draw_uncached(search, light, vec3(0.0)).probability : 0.0);
}
