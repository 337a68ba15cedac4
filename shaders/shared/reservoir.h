// SPDX-License-Identifier: GPL-2.0-or-later
// One candidate chosen in proportion to its importance while walking past many (a weighted
// reservoir of one): each replaces the choice with probability importance / sum so far, and the
// random number is stretched again after each use. Candidates that were drawn themselves come with
// their importance over the probability of that.
#ifndef VIGIL_SHARED_RESERVOIR_H
#define VIGIL_SHARED_RESERVOIR_H

#include "glsl.h"
#include "random.h"
#include "scene_types.h"

SHADER_BEGIN

/// One number of 24 bits decides a walk. Each decision uses some of them up; a number of which this
/// part or less is left is replaced by another that is made of the first. So the probability of a
/// candidate is off by at most 2^-13 in walks of 32, and by some 2^-24 in those of a few; one whose
/// probability is less than that is drawn never, or with 2^-24 (tests/numerics/reservoir_test.cpp
/// goes through all numbers).
SHADER_CONST float RESERVOIR_USED_UP = 1.0f / 4096.0f;

struct Reservoir {
    float sum;               // of importances
    uint chosen;             // number of a candidate, say a light; NONE if all importances were 0
    float chosen_importance; // above 0 if there is a choice
    float u;                 // random, in [0, 1]
    float left;              // of u's bits: the probability of all that it has decided
    uint seed;               // of the numbers that come after u
};

SHADER_FN Reservoir new_reservoir(float u) {
    Reservoir reservoir;
    reservoir.sum = 0.0f;
    reservoir.chosen = NONE;
    reservoir.chosen_importance = 0.0f;
    reservoir.u = u;
    reservoir.left = 1.0f;
    reservoir.seed = floatBitsToUint(u);
    return reservoir;
}

/// An empty reservoir with what is left of another's random number.
SHADER_FN Reservoir reservoir_again(Reservoir reservoir) {
    reservoir.sum = 0.0f;
    reservoir.chosen = NONE;
    reservoir.chosen_importance = 0.0f;
    reservoir.u = min(reservoir.u, 0.99999994f); // the first one that is added must not miss it
    return reservoir;
}

SHADER_FN void reservoir_add(INOUT(Reservoir) reservoir, uint candidate, float importance) {
    if (!(importance > 0.0f)) return;
    if (reservoir.left <= RESERVOIR_USED_UP) {
        reservoir.u = unit_float(hash_pcg3d(uvec3(reservoir.seed, candidate, 0u)).x);
        reservoir.left = 1.0f;
    }
    reservoir.sum += importance;
    const float share = importance / reservoir.sum;
    if (reservoir.u < share) {
        reservoir.chosen = candidate;
        reservoir.chosen_importance = importance;
        reservoir.u /= share;
        reservoir.left *= share;
    } else {
        reservoir.u = (reservoir.u - share) / (1.0f - share);
        reservoir.left *= 1.0f - share;
    }
}

SHADER_END
#endif
