// SPDX-License-Identifier: GPL-2.0-or-later
// Technique `ris`: resampled importance sampling (Talbot et al., "Importance Resampling for Global Illumination", 2005), the choice of
// lights that renderers make who know nothing of their level: pt_ris_candidates lights from one table over all of them, each weighted by its
// importance over its probability, and one kept in proportion. Nothing is reused between pixels or frames. The table is the one
// that `vlc` explores with, weighted anew each frame by power, change and nearness to the camera.
// Host side: refresh/vkpt/light/ris.cpp. docs/research/adding-a-sampler.md leads through this file.
#include "light/alias.glsl"
#include "light/importance.glsl"

#define PROBABILITY_IS_EXACT 0

/// Candidates are spread evenly over the table from one random place. Each by itself has the table's probabilities, which is all that
/// an unbiased mean of them takes; together they repeat each other less than independent ones.
struct Candidates {
    uint first, end, stride;
    LtcSurface prepared;
    uvec2 bits; // of the first
    uint step;  // from one to the next
};

uint candidate_light(Candidates candidates, uint i) {
    return alias_light(uvec2(candidates.bits.x + i * candidates.step, candidates.bits.y));
}

float candidate_weight(Candidates candidates, uint light) {
    return light_importance(candidates.prepared, light) / alias_probability(light);
}

#include "light/candidate_walk.glsl"

LightChoice choose_light(Surface surface, inout Random random) {
    const uvec2 bits = random_next_bits(random);
    const float u = random_next(random);
    if (alias_count() == 0u) return no_light();
    const uint count = uint(frame.settings.pt_ris_candidates);
    const Candidates candidates = Candidates(0u, count, 1u, prepare_importance(surface), bits, 0xffffffffu / count);
    const CandidateWalk walk = walk_candidates(candidates, NONE, u);
    if (walk.light == NONE) return no_light();
    // The mean of the candidates' weights estimates the sum of all lights' importances; 1 / probability is that over the chosen one's.
    const float importance = walk.weight * alias_probability(walk.light);
    return weighted_choice(walk.light, walk.sum / (float(count) * importance));
}

/// Of one candidate, if it may be kept.
float light_probability(Surface surface, uint light) {
    return light_importance(prepare_importance(surface), light) > 0.0 ? alias_probability(light) : 0.0;
}
