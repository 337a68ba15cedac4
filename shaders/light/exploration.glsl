// SPDX-License-Identifier: GPL-2.0-or-later
// Looking for lights that no sample has seen lately (paper, section 4.3), in constant time whatever the number of lights: a mixture of two
// alias tables. One holds all lights of the level, weighted anew each frame; one belongs to the surface's PVS cluster and
// holds the static lights that may be seen from there, by power over squared distance. The paper has the first alone, and
// names it a limitation that it knows nothing of the surface.
#ifndef VIGIL_LIGHT_EXPLORATION_GLSL
#define VIGIL_LIGHT_EXPLORATION_GLSL

#include "light/alias.glsl"

// List c belongs to cluster c, and one more, empty, to points in no cluster: (first, count) of ids and entries. Ids ascend.
layout(set = SET_TECHNIQUE, binding = 1, scalar) restrict readonly buffer LocalRangeBlock {
    uint local_list_count;
    uint local_unused;
    uvec2 local_ranges[];
};
layout(set = SET_TECHNIQUE, binding = 2, scalar) restrict readonly buffer LocalIdBlock { uint local_ids[]; };
layout(set = SET_TECHNIQUE, binding = 3, scalar) restrict readonly buffer LocalAliasBlock { AliasEntry local_entries[]; };

/// The tables that a surface explores with.
struct Exploration {
    uvec2 list;  // range of its cluster's lights
    float local; // share of the draws from there
};

Exploration prepare_exploration(Surface surface) {
    Exploration exploration;
    exploration.list = uvec2(0u);
    if (frame.cvars.pt_explore_local > 0.0)
        exploration.list = local_ranges[min(surface_cluster(surface), local_list_count - 1u)];
    exploration.local = exploration.list.y > 0u ? frame.cvars.pt_explore_local : 0.0;
    if (alias_count == 0u) exploration.local = exploration.list.y > 0u ? 1.0 : 0.0;
    return exploration;
}

/// Draws a light; `u` in [0, 1) takes the table. NONE if no light shines.
uint explore_light(Exploration exploration, float u, uvec2 bits) {
    if (!(u < exploration.local)) return alias_light(bits);
    const AliasSlot slot = alias_slot(bits, exploration.list.y);
    return local_ids[exploration.list.x + alias_choose(local_entries[exploration.list.x + slot.column], slot)];
}

/// Probability with which explore_light draws this one.
float exploration_probability(Exploration exploration, uint light) {
    float probability = (1.0 - exploration.local) * alias_probability(light);
    if (!(exploration.local > 0.0)) return probability;
    // Find the light in its cluster's list.
    uint first = exploration.list.x;
    uint count = exploration.list.y;
    while (count > 1u) {
        const uint half_count = count / 2u;
        const bool above = local_ids[first + half_count] <= light;
        first += above ? half_count : 0u;
        count = above ? count - half_count : half_count;
    }
    if (local_ids[first] == light) probability += exploration.local * local_entries[first].pdf;
    return probability;
}

#endif
