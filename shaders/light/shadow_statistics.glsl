// SPDX-License-Identifier: GPL-2.0-or-later
// The table of shadow statistics (shared/shadow_statistics.h) on the GPU. Techniques read losses and count rays in set SET_TECHNIQUE;
// the pass that makes losses of counts has a set of its own. Host side: refresh/vkpt/light/shadow_statistics.cpp.
#ifndef VIGIL_LIGHT_SHADOW_STATISTICS_GLSL
#define VIGIL_LIGHT_SHADOW_STATISTICS_GLSL

#include "shared/bindings.h"
#include "shared/shadow_statistics.h"

#ifndef SET_SHADOW_STATISTICS
#define SET_SHADOW_STATISTICS SET_TECHNIQUE
#endif

layout(set = SET_SHADOW_STATISTICS, binding = BINDING_SHADOW_STATISTICS, scalar) restrict buffer ShadowStatisticsBlock {
    uint shadow_slots;   // a power of two
    uint shadow_words[]; // SHADOW_SLOT_WORDS for each; losses are floats
};

/// Share of its weight that the slot's light keeps, at least 1 - SHADOW_MOST_LOSS.
float unshadowed_share(uint slot) { return 1.0 - uintBitsToFloat(shadow_words[shadow_loss_word(slot)]); }

void count_shadow_ray(uint slot, bool shadowed) { atomicAdd(shadow_words[shadow_count_word(slot, shadow_slots, shadowed)], SHADOW_RAY); }

#endif
