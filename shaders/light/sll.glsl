// SPDX-License-Identifier: GPL-2.0-or-later
// Technique `sll`: the Static Light Lists that shipped in Quake II RTX, with the importance of the paper (section
// 7). The lights that may be seen from the surface's PVS cluster are walked with a stride that leaves at most
// pt_sll_max of them, from a uniformly drawn start; one is chosen in proportion to its importance.
// Host side: refresh/vkpt/light/sll.cpp.
#include "light/importance.glsl"

// List c belongs to cluster c, and one more holds all lights, for points in no cluster: ranges (first, count) of ids. Lights
// of the static world are listed once; lights that can move are listed anew when they do.
layout(set = SET_TECHNIQUE, binding = 0, scalar) restrict readonly buffer StaticRangeBlock {
    uvec2 static_ranges[];
};
layout(set = SET_TECHNIQUE, binding = 1, scalar) restrict readonly buffer StaticIdBlock {
    uint static_ids[];
};
layout(set = SET_TECHNIQUE, binding = 2, scalar) restrict readonly buffer MovingRangeBlock {
    uvec2 moving_ranges[];
};
layout(set = SET_TECHNIQUE, binding = 3, scalar) restrict readonly buffer MovingIdBlock {
    uint moving_ids[];
};
layout(set = SET_TECHNIQUE, binding = 4, scalar) restrict readonly buffer ListCountBlock {
    uint sll_list_count; // lists, the one of all lights included
    uint sll_moving;     // 1: some moving list is not empty
};

/// The two ranges of one list, walked as if they were one.
struct LightList {
    uint static_first;
    uint static_count;
    uint moving_first;
    uint count; // of both
};

LightList find_light_list(Surface surface) {
    const uint cluster = min(surface_cluster(surface), sll_list_count - 1u); // NONE: the list of all lights
    const uvec2 range = static_ranges[cluster];
    LightList list = LightList(range.x, range.y, 0u, range.y);
    if (sll_moving != 0u) {
        const uvec2 moving = moving_ranges[cluster];
        list.moving_first = moving.x;
        list.count += moving.y;
    }
    return list;
}

uint light_of_list(LightList list, uint index) {
    return index < list.static_count ? static_ids[list.static_first + index]
                                     : moving_ids[list.moving_first + (index - list.static_count)];
}

uint list_stride(LightList list) {
    const uint most = uint(frame.cvars.pt_sll_max);
    return (list.count + most - 1u) / most;
}

LightChoice choose_light(Surface surface, inout Random random) {
    const LightList list = find_light_list(surface);
    const vec3 u = random_next3(random);
    if (list.count == 0u) return light_choice(NONE, 0.0);
    const uint stride = list_stride(list);
    const uint start = min(uint(u.x * float(stride)), stride - 1u);
    const LtcSurface prepared = prepare_importance(surface);

    // Choose while walking (weighted reservoir of one): each light replaces the choice with probability
    // weight / sum so far. One walk, and one random number that is stretched again after each use.
    float sum = 0.0;
    float chosen_weight = 0.0;
    uint chosen = NONE;
    float v = u.y;
    for (uint i = start; i < list.count; i += stride) {
        const uint light = light_of_list(list, i);
        const float weight = light_importance(prepared, light);
        if (weight > 0.0) {
            sum += weight;
            const float share = weight / sum;
            if (v < share) {
                chosen = light;
                chosen_weight = weight;
                v /= share;
            } else {
                v = (v - share) / (1.0 - share);
            }
        }
    }
    if (chosen == NONE) return light_choice(NONE, 0.0);
    return light_choice(chosen, chosen_weight / (sum * float(stride)));
}

float light_probability(Surface surface, uint light) {
    const LightList list = find_light_list(surface);
    if (list.count == 0u) return 0.0;
    // Find the light, and with it the one start whose walk meets it.
    uint place = 0u;
    while (place < list.count && light_of_list(list, place) != light) ++place;
    if (place == list.count) return 0.0;
    const uint stride = list_stride(list);
    const LtcSurface prepared = prepare_importance(surface);
    float sum = 0.0;
    for (uint i = place % stride; i < list.count; i += stride)
        sum += light_importance(prepared, light_of_list(list, i));
    return sum > 0.0 ? light_importance(prepared, light) / (sum * float(stride)) : 0.0;
}
