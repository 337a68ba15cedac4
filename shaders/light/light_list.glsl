// SPDX-License-Identifier: GPL-2.0-or-later
// The lights that may be seen from a surface's PVS cluster, and the strided walk through them of the paper's section 7: at most
// `most` of them from a drawn start, one chosen in proportion to its importance. `sll` draws so.
// Host side: refresh/vkpt/light/cluster_lists.cpp.
#ifndef VIGIL_LIGHT_LIGHT_LIST_GLSL
#define VIGIL_LIGHT_LIGHT_LIST_GLSL

#include "scene/surface.glsl"

// List c belongs to cluster c, and one more holds all lights, for points in no cluster: ranges (first, count) of ids. Lights
// of the static world are listed once; lights that can move, whose ids are larger, are listed anew when they do. Ids ascend.
layout(set = SET_TECHNIQUE, binding = BINDING_STATIC_RANGES) uniform utextureBuffer static_ranges;
layout(set = SET_TECHNIQUE, binding = BINDING_STATIC_IDS) uniform utextureBuffer static_ids;
layout(set = SET_TECHNIQUE, binding = BINDING_MOVING_RANGES) uniform utextureBuffer moving_ranges;
layout(set = SET_TECHNIQUE, binding = BINDING_MOVING_IDS) uniform utextureBuffer moving_ids;
layout(set = SET_TECHNIQUE, binding = BINDING_LIST_COUNTS, scalar) restrict readonly buffer ListCountBlock {
    uint list_count;  // lists, the one of all lights included
    uint list_moving; // 1: some moving list is not empty
};

/// The two ranges of one list, walked as if they were one.
struct LightList {
    uint number; // of the list: its cluster, or that after the last one
    uint static_first;
    uint static_count;
    uint moving_first;
    uint count; // of both
};

uvec2 load_range(utextureBuffer ranges, uint list) { return uvec2(load_word(ranges, 2u * list), load_word(ranges, 2u * list + 1u)); }

LightList find_light_list(Surface surface) {
    const uint cluster = min(surface_cluster(surface), list_count - 1u); // NONE: the list of all lights
    const uvec2 range = load_range(static_ranges, cluster);
    LightList list = LightList(cluster, range.x, range.y, 0u, range.y);
    if (list_moving != 0u) {
        const uvec2 moving = load_range(moving_ranges, cluster);
        list.moving_first = moving.x;
        list.count += moving.y;
    }
    return list;
}

uint light_of_list(LightList list, uint index) {
    return index < list.static_count ? load_word(static_ids, list.static_first + index)
                                     : load_word(moving_ids, list.moving_first + (index - list.static_count));
}

/// Takes the sun out of a list that holds it, as the last one of those that do not move. False if it does not.
bool take_sun(inout LightList list) {
    if (!HAS_ENVIRONMENT || list.static_count == 0u) return false;
    if (load_word(static_ids, list.static_first + list.static_count - 1u) != frame.sun_light) return false;
    list.static_count -= 1u;
    list.count -= 1u;
    return true;
}

/// Index of a light in a list, found by bisection; NONE if it is not there.
uint place_in_list(LightList list, uint light) {
    uint first = 0u;
    uint count = list.count;
    while (count > 1u) {
        const uint half_count = count / 2u;
        const bool above = light_of_list(list, first + half_count) <= light;
        first += above ? half_count : 0u;
        count = above ? count - half_count : half_count;
    }
    return count == 1u && light_of_list(list, first) == light ? first : NONE;
}

/// Walks of at most `most` lights, one by one from start 0 .. stride - 1, meet each light of a list once.
uint list_stride(LightList list, uint most) { return (list.count + most - 1u) / most; }

#endif
