// SPDX-License-Identifier: GPL-2.0-or-later
// Technique `sll`: the Static Light Lists of Quake II RTX. The lights that may be seen from the surface's PVS cluster are walked
// with a stride that leaves at most pt_sll_max of them, from a uniformly drawn start; one is chosen in proportion to its weight. That is
// the importance of the paper (section 7), or solid angle times luminance as in the lists as they shipped (pt_sll_mass); and, where shadow
// rays are counted (pt_sll_stats), the less the more of them were stopped on their way to it. A walk and the probability of
// its light read the same numbers, which no frame changes while it reads them: the choice is unbiased, whatever they are.
// Host side: refresh/vkpt/light/sll.cpp.
#include "light/importance.glsl"
#include "light/light_list.glsl"
#include "shared/reservoir.h"
#include "light/shadow_statistics.glsl"

#define LEARNS_FROM_LIGHT_SAMPLES 1

// Choices of pt_sll_mass, in their order.
const int SLL_MASS_LTC = 0;
const int SLL_MASS_SOLID_ANGLE = 1;

/// What the weights of all lights of a list have in common.
struct ListWeights {
    LtcSurface prepared;
    uint list;
    uint direction; // dominant_direction of the surface
};

ListWeights prepare_weights(Surface surface, LightList list) {
    ListWeights weights;
    if (frame.settings.pt_sll_mass == SLL_MASS_LTC) {
        weights.prepared = prepare_importance(surface);
    } else {
        weights.prepared.position = surface.origin;
        weights.prepared.normal = surface.normal;
    }
    weights.list = list.number;
    weights.direction = dominant_direction(surface.normal);
    return weights;
}

uint slot_of_light(ListWeights weights, uint light) {
    return shadow_slot(weights.list, light, weights.direction, shadow_slots);
}

/// Above 0 for every light that can shine on the surface.
float light_weight(ListWeights weights, uint light) {
    float weight;
    if (frame.settings.pt_sll_mass == SLL_MASS_LTC) weight = light_importance(weights.prepared, light);
    else weight = solid_angle_importance(weights.prepared.position, weights.prepared.normal, light);
    if (frame.settings.pt_sll_stats != 0 && weight > 0.0) weight *= unshadowed_share(slot_of_light(weights, light));
    return weight;
}

LightChoice choose_light(Surface surface, inout Random random) {
    const LightList list = find_light_list(surface);
    const vec3 u = random_next3(random);
    if (list.count == 0u) return no_light();
    const uint stride = list_stride(list, uint(frame.settings.pt_sll_max));
    const uint start = min(uint(u.x * float(stride)), stride - 1u);
    const ListWeights weights = prepare_weights(surface, list);
    Reservoir reservoir = new_reservoir(u.y);
    for (uint i = start; i < list.count; i += stride) {
        const uint light = light_of_list(list, i);
        reservoir_add(reservoir, light, light_weight(weights, light));
    }
    if (reservoir.chosen == NONE) return no_light();
    LightChoice choice = light_choice(reservoir.chosen, reservoir.chosen_importance / (reservoir.sum * float(stride)));
    if (frame.settings.pt_sll_stats != 0) choice.memory.x = slot_of_light(weights, choice.light);
    return choice;
}

void learn_light(LightChoice choice, uint outcome) {
    if (frame.settings.pt_sll_stats != 0 && outcome != LIGHT_UNTRIED) count_shadow_ray(choice.memory.x, outcome == LIGHT_SHADOWED);
}

float light_probability(Surface surface, uint light) {
    const LightList list = find_light_list(surface);
    const uint place = place_in_list(list, light);
    if (place == NONE) return 0.0;
    // The one start whose walk meets the light.
    const uint stride = list_stride(list, uint(frame.settings.pt_sll_max));
    const ListWeights weights = prepare_weights(surface, list);
    float sum = 0.0;
    for (uint i = place % stride; i < list.count; i += stride)
        sum += light_weight(weights, light_of_list(list, i));
    return sum > 0.0 ? light_weight(weights, light) / (sum * float(stride)) : 0.0;
}
