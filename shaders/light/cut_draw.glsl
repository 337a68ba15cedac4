// SPDX-License-Identifier: GPL-2.0-or-later
// A draw from a light cut (cut_lists.glsl). All entries are weighed and one is drawn; in a group, one light by the weights of its halves. Groups
// that are near are opened before, and their lights weighed one by one: the cut of a cluster becomes one of the surface.
#ifndef VIGIL_LIGHT_CUT_DRAW_GLSL
#define VIGIL_LIGHT_CUT_DRAW_GLSL

#include "light/cut_lists.glsl"
#include "light/importance.glsl"
#include "shared/reservoir.h"

/// A light and the probability of its draw.
struct CutDraw {
    uint light;        // NONE: none was drawn
    float probability; // 0: none, or the sought light is not in the cut or weighs nothing
};

/// What was chosen, or what has the sought light.
struct CutChoice {
    Reservoir entries; // lights and groups
    uint holder;
    float holder_weight;
};

void weigh_entry(inout CutChoice choice, uint entry, float weight, bool holds) {
    reservoir_add(choice.entries, entry, weight);
    if (!holds) return;
    choice.holder = entry;
    choice.holder_weight = weight;
}

/// Weighs a group, or what stands for it where it is near. `opened`: groups and lights weighed so far in place of others.
void weigh_group(inout CutChoice choice, inout uint opened, uint number, LtcSurface surface, uint sought, uint place) {
    uint end = NONE;
    do {
        const CutGroup group = load_group(number);
        if (end == NONE) end = group.next;
        const CutWeight weight = cut_weight(group, surface, HAS_GLOSS);
        const bool parts = group.count > CUT_LEAF;
        const bool opens = weight.importance > 0.0 && weight.width > CUT_NEAR + CUT_HARDER * float(opened);
        if (!opens) {
            weigh_entry(choice, CUT_GROUP | number, min(weight.importance, LIGHT_IMPORTANCE_MOST),
                        place - group.first < group.count); // NONE is in none
        } else {
            opened += parts ? 2u : group.count;
            for (uint i = group.first; !parts && i < group.first + group.count; ++i) {
                const uint light = load_word(cut_order, i);
                weigh_entry(choice, light, light_importance(surface, light), light == sought);
            }
        }
        number = opens && parts ? number + 1u : group.next;
    } while (number != end);
}

/// Draws a light by `u`, in [0, 1); or finds the probability of `sought`, unless that is NONE.
CutDraw draw_from_cut(LightCut cut, LtcSurface surface, uint sought, vec3 u) {
    const CutDraw nothing = CutDraw(sought, 0.0);
    const uint place = sought == NONE ? NONE : place_in_cut(cut, sought);
    if (sought != NONE && place == NONE) return nothing;
    CutChoice choice = CutChoice(new_reservoir(u.x), NONE, 0.0);
    uint opened = 0u;
    for (uint i = 0u; i < cut_size(cut); ++i) {
        const uint entry = load_word(cut_entries, i < cut.still.y ? cut.still.x + i : cut.moving.x + (i - cut.still.y));
        if ((entry & CUT_GROUP) != 0u) weigh_group(choice, opened, entry & ~CUT_GROUP, surface, sought, place);
        else weigh_entry(choice, entry, light_importance(surface, entry), entry == sought);
    }
    const uint chosen = sought == NONE ? choice.entries.chosen : choice.holder;
    const float weight = sought == NONE ? choice.entries.chosen_importance : choice.holder_weight;
    if (chosen == NONE || !(weight > 0.0)) return nothing;
    float probability = weight / choice.entries.sum;
    if ((chosen & CUT_GROUP) == 0u) return CutDraw(chosen, probability);

    uint number = chosen & ~CUT_GROUP;
    CutGroup group = load_group(number);
    Reservoir halves = new_reservoir(u.y);
    while (group.count > CUT_WALK) {
        const CutGroup left = load_group(number + 1u), right = load_group(left.next);
        const float a = min(cut_weight(left, surface, HAS_GLOSS).importance, LIGHT_IMPORTANCE_MOST);
        const float b = min(cut_weight(right, surface, HAS_GLOSS).importance, LIGHT_IMPORTANCE_MOST);
        if (!(a + b > 0.0)) return nothing;
        reservoir_again(halves);
        reservoir_add(halves, number + 1u, a);
        reservoir_add(halves, left.next, b);
        const bool in_left = sought == NONE ? halves.chosen == number + 1u : place - left.first < left.count;
        probability *= (in_left ? a : b) / (a + b);
        number = in_left ? number + 1u : left.next;
        group = left;
        if (!in_left) group = right;
    }
    Reservoir lights = new_reservoir(u.z);
    float its_weight = 0.0;
    for (uint i = group.first; i < group.first + group.count; ++i) {
        const uint light = load_word(cut_order, i);
        const float importance = light_importance(surface, light);
        reservoir_add(lights, light, importance);
        if (light == sought) its_weight = importance;
    }
    if (sought == NONE) its_weight = lights.chosen_importance;
    if (!(its_weight > 0.0)) return nothing;
    return CutDraw(sought == NONE ? lights.chosen : sought, probability * (its_weight / lights.sum));
}

#endif
