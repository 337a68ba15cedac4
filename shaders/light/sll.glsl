// SPDX-License-Identifier: GPL-2.0-or-later
// Technique `sll`: the Static Light Lists that shipped in Quake II RTX, with the importance of the paper (section
// 7). The lights that may be seen from the surface's PVS cluster are walked with a stride that leaves at most
// pt_sll_max of them, from a uniformly drawn start; one is chosen in proportion to its importance.
// Host side: refresh/vkpt/light/sll.cpp.
#include "light/importance.glsl"
#include "light/light_list.glsl"
#include "light/reservoir.glsl"

LightChoice choose_light(Surface surface, inout Random random) {
    const LightList list = find_light_list(surface);
    const vec3 u = random_next3(random);
    if (list.count == 0u) return light_choice(NONE, 0.0);
    const uint stride = list_stride(list, uint(frame.cvars.pt_sll_max));
    const uint start = min(uint(u.x * float(stride)), stride - 1u);
    const LtcSurface prepared = prepare_importance(surface);
    Reservoir reservoir = new_reservoir(u.y);
    for (uint i = start; i < list.count; i += stride) {
        const uint light = light_of_list(list, i);
        reservoir_add(reservoir, light, light_importance(prepared, light));
    }
    if (reservoir.chosen == NONE) return light_choice(NONE, 0.0);
    return light_choice(reservoir.chosen, reservoir.chosen_importance / (reservoir.sum * float(stride)));
}

float light_probability(Surface surface, uint light) {
    const LightList list = find_light_list(surface);
    const uint place = place_in_list(list, light);
    if (place == NONE) return 0.0;
    // The one start whose walk meets the light.
    const uint stride = list_stride(list, uint(frame.cvars.pt_sll_max));
    const LtcSurface prepared = prepare_importance(surface);
    float sum = 0.0;
    for (uint i = place % stride; i < list.count; i += stride)
        sum += light_importance(prepared, light_of_list(list, i));
    return sum > 0.0 ? light_importance(prepared, light) / (sum * float(stride)) : 0.0;
}
