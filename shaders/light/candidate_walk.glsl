// SPDX-License-Identifier: GPL-2.0-or-later
// A walk past candidate lights that keeps one in proportion to its weight: how the techniques choose that weigh lights one by one. A
// technique's file says what its candidates are, and includes this one after that:
//   struct Candidates          with their places: first, first + stride, first + 2 * stride ... below end; and whatever else it takes to
//   candidate_light(c, i)      the light at place i; NONE: the walk ends there
//   candidate_weight(c, light) not negative, and above 0 for a light that can shine on the surface
#ifndef VIGIL_LIGHT_CANDIDATE_WALK_GLSL
#define VIGIL_LIGHT_CANDIDATE_WALK_GLSL

#include "shared/reservoir.h"

/// What a walk kept: probability weight / sum, if the places are certain.
struct CandidateWalk {
    uint light;   // NONE: no candidate has a weight
    float weight; // its own; 0 if the walk did not meet it
    float sum;    // of all weights
};

/// Probability that a draw walks so, from one of `starts` places drawn evenly, and keeps that light.
float walk_probability(CandidateWalk walk, uint starts) { return walk.weight > 0.0 ? walk.weight / (walk.sum * float(starts)) : 0.0; }

/// Draws by `u`, in [0, 1); or keeps the light `sought`, unless that is NONE.
CandidateWalk walk_candidates(Candidates candidates, uint sought, float u) {
    Reservoir reservoir = new_reservoir(u);
    float sought_weight = 0.0;
    for (uint i = candidates.first; i < candidates.end; i += candidates.stride) {
        const uint light = candidate_light(candidates, i);
        if (light == NONE) break;
        const float weight = candidate_weight(candidates, light);
        reservoir_add(reservoir, light, weight);
        if (light == sought) sought_weight = weight;
    }
    if (sought != NONE) return CandidateWalk(sought, sought_weight, reservoir.sum);
    return CandidateWalk(reservoir.chosen, reservoir.chosen_importance, reservoir.sum);
}

#endif
