// SPDX-License-Identifier: GPL-2.0-or-later
// Technique `vlc`: the Visibility Light Cache (paper, section 4.2 and algorithm 1). A bucket of the surface's cache is drawn, and in it a light in
// proportion to its importance; a fraction pt_vlc_explore of the draws takes any light of the level instead. One walk
// through one bucket serves both: it adds up the importances, chooses, and finds the explored light's own.
// Host side: refresh/vkpt/light/vlc.cpp and refresh/vkpt/guiding.
#include "guiding/octree.glsl"
#include "light/exploration.glsl"
#include "light/importance.glsl"

#define LEARNS_FROM_LIGHT_SAMPLES 1

/// What a walk through a bucket found.
struct BucketWalk {
    float sum;    // of importances
    uint chosen;  // a light drawn in proportion to its importance; NONE if all are 0
    float chosen_importance;
    float sought_importance; // of the light sought; 0 if it is not in the bucket
};

/// Walks through the bucket of `size` lights at most that begins at `first`; `u` in [0, 1) draws. The choice is a weighted
/// reservoir of one: each light replaces the one before with probability importance / sum so far, and
/// the random number is stretched again after each use.
BucketWalk walk_bucket(LtcSurface prepared, uint first, uint size, uint sought, float u) {
    BucketWalk walk = BucketWalk(0.0, NONE, 0.0, 0.0);
    for (uint i = 0u; i < size; ++i) {
        const uint entry = vlc_lights[first + i];
        if (entry == NONE) break;
        const uint light = entry & VLC_ID_MASK;
        const float importance = light_importance(prepared, light);
        if (!(importance > 0.0)) continue;
        walk.sum += importance;
        if (light == sought) walk.sought_importance = importance;
        const float share = importance / walk.sum;
        if (u < share) {
            walk.chosen = light;
            walk.chosen_importance = importance;
            u /= share;
        } else {
            u = (u - share) / (1.0 - share);
        }
    }
    return walk;
}

/// Share of the draws that explore. Where the cache is known to have nothing, all do.
float explore_fraction(BucketWalk walk, uint buckets) {
    const bool nothing = buckets == 0u || (buckets == 1u && !(walk.sum > 0.0));
    return nothing ? 1.0 : frame.cvars.pt_vlc_explore;
}

/// Probability of a light of the walked bucket in the mixture of both techniques.
float mixture_probability(BucketWalk walk, uint buckets, Exploration exploration, uint light, float importance) {
    const float explore = explore_fraction(walk, buckets);
    float probability = explore * exploration_probability(exploration, light);
    if (importance > 0.0) probability += (1.0 - explore) * importance / (walk.sum * float(buckets));
    return probability;
}

LightChoice choose_light(Surface surface, inout Random random) {
    const SurfaceLeaves found = find_leaves(surface);
    const uint cache = leaf_word(LEAF_VLC, 2u, found.cache);
    const uint first = leaves[cache];
    const uint buckets = leaves[cache + 1u];
    const vec3 u = random_next3(random);
    const Exploration exploration = prepare_exploration(surface);
    const uint explored = explore_light(exploration, random_next(random), random_next_bits(random));

    bool explore = u.x < frame.cvars.pt_vlc_explore;
    // An explored light can only be in one bucket; otherwise any will do.
    BucketWalk walk = BucketWalk(0.0, NONE, 0.0, 0.0);
    if (buckets > 0u) {
        const uint bucket =
            explore && explored != NONE ? explored & (buckets - 1u) : min(uint(u.y * float(buckets)), buckets - 1u);
        const uint size = uint(frame.cvars.pt_vlc_bucket);
        walk = walk_bucket(prepare_importance(surface), first + bucket * size, size, explored, u.z);
    }
    explore = explore || explore_fraction(walk, buckets) == 1.0;

    LightChoice choice = light_choice(explore ? explored : walk.chosen, 0.0);
    choice.explored = explore;
    choice.memory = found.samples;
    if (choice.light == NONE) return choice;
    choice.probability = mixture_probability(walk, buckets, exploration, choice.light,
                                             explore ? walk.sought_importance : walk.chosen_importance);
    // A light of zero probability cannot be drawn, but rounding in the reservoir may come close to it.
    if (!(choice.probability > 0.0)) choice.light = NONE;
    return choice;
}

void learn_light(LightChoice choice, bool seen) {
    store_light_sample(choice.memory, choice.light == NONE ? LIGHT_SAMPLE_NONE : choice.light, seen);
}

float light_probability(Surface surface, uint light) {
    const uint cache = leaf_word(LEAF_VLC, 2u, find_leaves(surface).cache);
    const uint buckets = leaves[cache + 1u];
    BucketWalk walk = BucketWalk(0.0, NONE, 0.0, 0.0);
    if (buckets > 0u) {
        const uint size = uint(frame.cvars.pt_vlc_bucket);
        walk = walk_bucket(prepare_importance(surface), leaves[cache] + (light & (buckets - 1u)) * size, size, light, 0.0);
    }
    return mixture_probability(walk, buckets, prepare_exploration(surface), light, walk.sought_importance);
}
