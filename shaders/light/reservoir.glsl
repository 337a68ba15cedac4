// SPDX-License-Identifier: GPL-2.0-or-later
// One candidate chosen in proportion to its importance while walking past many (a weighted reservoir of one): each replaces the choice
// with probability importance / sum so far, and the random number is stretched again after each use.
// Candidates that were drawn themselves come with their importance over the probability of that.
#ifndef VIGIL_LIGHT_RESERVOIR_GLSL
#define VIGIL_LIGHT_RESERVOIR_GLSL

struct Reservoir {
    float sum;               // of importances
    uint chosen;             // number of a candidate, say a light; NONE if all importances were 0
    float chosen_importance;
    float u;                 // random, in [0, 1)
};

Reservoir new_reservoir(float u) { return Reservoir(0.0, NONE, 0.0, u); }

void reservoir_add(inout Reservoir reservoir, uint candidate, float importance) {
    if (!(importance > 0.0)) return;
    reservoir.sum += importance;
    const float share = importance / reservoir.sum;
    if (reservoir.u < share) {
        reservoir.chosen = candidate;
        reservoir.chosen_importance = importance;
        reservoir.u /= share;
    } else {
        reservoir.u = (reservoir.u - share) / (1.0 - share);
    }
}

#endif
