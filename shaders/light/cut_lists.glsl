// SPDX-License-Identifier: GPL-2.0-or-later
// The light cuts of all PVS clusters: what stands for the lights that may be seen from a surface's cluster. Those of lights that stay, and
// of lights that can move. Drawn from by cut_draw.glsl; host side: refresh/vkpt/light/cluster_cuts.h.
#ifndef VIGIL_LIGHT_CUT_LISTS_GLSL
#define VIGIL_LIGHT_CUT_LISTS_GLSL

#include "scene/surface.glsl"
#include "shared/light_cut.h"

// A texel a cluster: first entry, entries, first light in order, lights; and one more for points in no cluster. Lights that can move after these.
layout(set = SET_TECHNIQUE, binding = BINDING_LIGHT_CUTS) uniform utextureBuffer light_cuts;
layout(set = SET_TECHNIQUE,
       binding = BINDING_CUT_ENTRIES) uniform utextureBuffer cut_entries; // groups (CUT_GROUP), then runs of lights (cut_run)
layout(set = SET_TECHNIQUE, binding = BINDING_CUT_ORDER) uniform utextureBuffer cut_order; // ids of the lights of all lists and runs
layout(set = SET_TECHNIQUE,
       binding = BINDING_CUT_PLACES) uniform utextureBuffer cut_places; // lists; lights that stay; by id, what all lists are sorted by
layout(set = SET_TECHNIQUE, binding = BINDING_LIGHT_NODES) uniform utextureBuffer cut_groups; // CutGroup records

/// Of one cluster.
struct LightCut {
    uvec4 still, moving; // first entry, entries, first light, lights
};

LightCut find_cut(Surface surface) {
    const int lists = int(load_word(cut_places, 0u));
    const int list = int(min(surface_cluster(surface), uint(lists) - 1u)); // NONE: that of all lights
    return LightCut(texelFetch(light_cuts, list), texelFetch(light_cuts, lists + list));
}

uint cut_size(LightCut cut) { return cut.still.y + cut.moving.y; }

/// Where a light is in cut_order; NONE if the cluster does not list it.
uint place_in_cut(LightCut cut, uint light) {
    const bool moves = light >= load_word(cut_places, 1u);
    uint first = moves ? cut.moving.z : cut.still.z;
    uint count = moves ? cut.moving.w : cut.still.w;
    const uint sought = load_word(cut_places, 2u + light);
    if (count == 0u || sought == NONE) return NONE;
    while (count > 1u) {
        const uint half_count = count / 2u;
        const bool above = load_word(cut_places, 2u + load_word(cut_order, first + half_count)) <= sought;
        first += above ? half_count : 0u;
        count = above ? count - half_count : half_count;
    }
    return load_word(cut_order, first) == light ? first : NONE;
}

CutGroup load_group(uint number) {
    const int at = int(number) * CUT_GROUP_TEXELS;
    const vec4 a = load_floats(cut_groups, at), b = load_floats(cut_groups, at + 1), c = load_floats(cut_groups, at + 2);
    const uvec4 d = texelFetch(cut_groups, at + 3);
    return CutGroup(a.xyz, a.w, b.xyz, b.w, c.xyz, c.w, d.x, d.y, d.z, 0u);
}

#endif
