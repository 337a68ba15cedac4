// SPDX-License-Identifier: GPL-2.0-or-later
// Technique `sll`: the Static Light Lists of Quake II RTX. The lights that may be seen from the surface's PVS cluster are walked
// with a stride that leaves at most pt_sll_max of them, from a uniformly drawn start; one is chosen in proportion to its weight. That is
// the importance of the paper (section 7), or solid angle times luminance as in the lists as they shipped (pt_sll_mass); and, where shadow
// rays are counted (pt_sll_stats), the less the more of them were stopped on their way to it. A walk and the probability of
// its light read the same numbers, which no frame changes while it reads them: the choice is unbiased, whatever they are.
// The sun is drawn beside the walk (light/sun_share.glsl): one light that outshines all others must not depend on a stride.
// Host side: refresh/vkpt/light/sll.cpp.
#include "light/sun_share.glsl"
#include "light/light_list.glsl"
#include "light/shadow_statistics.glsl"

#define LEARNS_FROM_LIGHT_SAMPLES 1

// Choices of pt_sll_mass, in their order.
const int SLL_MASS_LTC = 0;
const int SLL_MASS_SOLID_ANGLE = 1;

/// Lights of a list.
struct Candidates {
    uint first, end, stride;
    LightList list;
    LtcSurface prepared;
    uint direction; // dominant_direction of the surface
};

uint slot_of_light(Candidates candidates, uint light) {
    return shadow_slot(candidates.list.number, light, candidates.direction, shadow_slots);
}

uint candidate_light(Candidates candidates, uint i) { return light_of_list(candidates.list, i); }

float candidate_weight(Candidates candidates, uint light) {
    float weight;
    if (frame.settings.pt_sll_mass == SLL_MASS_LTC) weight = light_importance(candidates.prepared, light);
    else weight = solid_angle_importance(candidates.prepared.position, candidates.prepared.normal, light);
    if (frame.settings.pt_sll_stats != 0 && weight > 0.0) weight *= unshadowed_share(slot_of_light(candidates, light));
    return weight;
}

#include "light/candidate_walk.glsl"

/// From the list's first light on.
Candidates prepare_candidates(Surface surface, LightList list) {
    Candidates candidates;
    candidates.first = 0u;
    candidates.end = list.count;
    candidates.stride = list_stride(list, uint(frame.settings.pt_sll_max));
    candidates.list = list;
    if (frame.settings.pt_sll_mass == SLL_MASS_LTC) {
        candidates.prepared = prepare_importance(surface);
    } else {
        candidates.prepared.position = surface.origin;
        candidates.prepared.normal = surface.normal;
    }
    candidates.direction = dominant_direction(surface.normal);
    return candidates;
}

/// What the draws of a surface have in common.
struct ListDraw {
    LightList list; // without the sun
    float of_sun;   // part of the draws that are of the sun
};

ListDraw prepare_draw(Surface surface) {
    ListDraw draw = ListDraw(find_light_list(surface), 0.0);
    if (take_sun(draw.list)) draw.of_sun = sun_share(surface, draw.list.count != 0u);
    return draw;
}

LightChoice choose_light(Surface surface, inout Random random) {
    const ListDraw draw = prepare_draw(surface);
    const vec3 u = random_next3(random);
    LightChoice choice;
    if (u.z < draw.of_sun) {
        choice = light_choice(frame.sun_light, draw.of_sun);
        if (frame.settings.pt_sll_stats != 0)
            choice.memory.x = shadow_slot(draw.list.number, choice.light, dominant_direction(surface.normal), shadow_slots);
        return choice;
    }
    if (draw.list.count == 0u) return no_light();
    Candidates candidates = prepare_candidates(surface, draw.list);
    candidates.first = draw_index(u.x, candidates.stride);
    const CandidateWalk walk = walk_candidates(candidates, NONE, u.y);
    choice = light_choice(walk.light, (1.0 - draw.of_sun) * walk_probability(walk, candidates.stride));
    if (frame.settings.pt_sll_stats != 0) choice.memory.x = slot_of_light(candidates, choice.light);
    return choice;
}

void learn_light(LightChoice choice, uint outcome) {
    if (frame.settings.pt_sll_stats != 0 && outcome != LIGHT_UNTRIED) count_shadow_ray(choice.memory.x, outcome == LIGHT_SHADOWED);
}

float light_probability(Surface surface, uint light) {
    const ListDraw draw = prepare_draw(surface);
    if (HAS_ENVIRONMENT && light == frame.sun_light) return draw.of_sun;
    const uint place = place_in_list(draw.list, light);
    if (place == NONE) return 0.0;
    Candidates candidates = prepare_candidates(surface, draw.list);
    candidates.first = place % candidates.stride; // the one start whose walk meets the light
    return (1.0 - draw.of_sun) * walk_probability(walk_candidates(candidates, light, 0.0), candidates.stride);
}
