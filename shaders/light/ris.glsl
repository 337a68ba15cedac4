// SPDX-License-Identifier: GPL-2.0-or-later
// Technique `ris`: resampled importance sampling (Talbot et al., "Importance Resampling for Global Illumination", 2005), the choice of
// lights that renderers make who know nothing of their level: pt_ris_candidates lights from one table over all of them, each weighted by its
// importance over its probability, and one kept in proportion. Nothing is reused between pixels or frames. The table is the one
// that `vlc` explores with, weighted anew each frame by power, change and nearness to the camera.
// Host side: refresh/vkpt/light/ris.cpp. docs/adding-a-sampler.md leads through this file.
#include "light/alias.glsl"
#include "light/importance.glsl"
#include "shared/reservoir.h"

#define PROBABILITY_IS_EXACT 0

LightChoice choose_light(Surface surface, inout Random random) {
    uvec2 bits = random_next_bits(random);
    const float u = random_next(random);
    if (alias_count == 0u) return no_light();

    // Candidates are spread evenly over the table from one random place. Each by itself has the table's probabilities, which is all that
    // an unbiased mean of them takes; together they repeat each other less than independent ones.
    const uint count = uint(frame.settings.pt_ris_candidates);
    const uint step = 0xffffffffu / count;
    const LtcSurface prepared = prepare_importance(surface);
    Reservoir reservoir = new_reservoir(u);
    for (uint i = 0u; i < count; ++i) {
        const uint light = alias_light(bits);
        bits.x += step;
        reservoir_add(reservoir, light, light_importance(prepared, light) / alias_probability(light));
    }
    if (reservoir.chosen == NONE) return no_light();

    // The mean of the candidates' weights estimates the sum of all lights' importances; 1 / probability is that over the chosen one's.
    const float importance = reservoir.chosen_importance * alias_probability(reservoir.chosen);
    return weighted_choice(reservoir.chosen, reservoir.sum / (float(count) * importance));
}

/// Of one candidate, if it may be kept.
float light_probability(Surface surface, uint light) {
    return light_importance(prepare_importance(surface), light) > 0.0 ? alias_probability(light) : 0.0;
}
