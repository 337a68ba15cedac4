// SPDX-License-Identifier: GPL-2.0-or-later
// A draw from a light cut (cut_lists.glsl). All entries are weighed and one is drawn; in a group, one light by the weights of its halves. Groups
// that are near are opened before, and their lights weighed one by one: the cut of a cluster becomes one of the surface.
#ifndef VIGIL_LIGHT_CUT_DRAW_GLSL
#define VIGIL_LIGHT_CUT_DRAW_GLSL

#include "light/cut_lists.glsl"
#include "light/importance.glsl"
#include "shared/reservoir.h"

/// What was drawn, and the probability of that.
struct CutDraw {
    uint light;        // or a group. NONE: nothing was drawn
    float probability; // 0: nothing, or the sought light is not among what was weighed or weighs nothing
};

/// One of what is weighed: by chance, or because it is, or has, the sought light.
struct CutChoice {
    Reservoir chance;
    uint holder;
    float holder_weight;
};

CutChoice new_choice(Reservoir chance) { return CutChoice(chance, NONE, 0.0); }

void weigh(inout CutChoice choice, uint entry, float weight, bool holds) {
    reservoir_add(choice.chance, entry, weight);
    if (!holds) return;
    choice.holder = entry;
    choice.holder_weight = weight;
}

float group_importance(CutWeight weight) { return min(weight.importance, LIGHT_IMPORTANCE_MOST); }
bool has_place(CutGroup group, uint place) { return place - group.first < group.count; } // NONE is in none

void weigh_lights(inout CutChoice choice, CutGroup group, LtcSurface surface, uint sought) {
    for (uint i = group.first; i < group.first + group.count; ++i) {
        const uint light = load_word(cut_order, i);
        weigh(choice, light, light_importance(surface, light), light == sought);
    }
}

/// Weighs a group, or what stands for it where it is near. `opened`: groups and lights weighed so far in place of others.
void weigh_group(inout CutChoice choice, inout uint opened, uint number, LtcSurface surface, uint sought, uint place) {
    uint end = NONE;
    do {
        const CutGroup group = load_group(number);
        if (end == NONE) end = group.next;
        const CutWeight weight = cut_weight(group, surface, HAS_GLOSS);
        const bool opens = weight.importance > 0.0 && weight.width > CUT_NEAR + CUT_HARDER * float(opened);
        const bool halves = opens && group.count > CUT_LEAF;
        if (!opens) weigh(choice, CUT_GROUP | number, group_importance(weight), has_place(group, place));
        else opened += halves ? 2u : group.count;
        if (opens && !halves) weigh_lights(choice, group, surface, sought);
        number = halves ? number + 1u : group.next;
    } while (number != end);
}

CutDraw draw_of(CutChoice choice, uint sought) {
    const uint entry = sought == NONE ? choice.chance.chosen : choice.holder;
    const float weight = sought == NONE ? choice.chance.chosen_importance : choice.holder_weight;
    if (entry == NONE || !(weight > 0.0)) return CutDraw(NONE, 0.0);
    return CutDraw(entry, weight / choice.chance.sum);
}

/// Draws a light by `u`, in [0, 1); or finds the probability of `sought`, unless that is NONE.
CutDraw draw_from_cut(LightCut cut, LtcSurface surface, uint sought, vec3 u) {
    const uint place = sought == NONE ? NONE : place_in_cut(cut, sought);
    if (sought != NONE && place == NONE) return CutDraw(NONE, 0.0);
    CutChoice choice = new_choice(new_reservoir(u.x));
    uint opened = 0u;
    for (uint i = 0u; i < cut_size(cut); ++i) {
        const uint entry = load_word(cut_entries, i < cut.still.y ? cut.still.x + i : cut.moving.x + (i - cut.still.y));
        if ((entry & CUT_GROUP) != 0u) weigh_group(choice, opened, entry & ~CUT_GROUP, surface, sought, place);
        else weigh(choice, entry, light_importance(surface, entry), entry == sought);
    }
    CutDraw draw = draw_of(choice, sought);
    if (draw.light == NONE || (draw.light & CUT_GROUP) == 0u) return draw;

    float probability = draw.probability;
    uint number = draw.light & ~CUT_GROUP;
    CutGroup group = load_group(number);
    Reservoir chance = new_reservoir(u.y);
    while (group.count > CUT_WALK) {
        const CutGroup left = load_group(number + 1u), right = load_group(left.next);
        choice = new_choice(reservoir_again(chance));
        weigh(choice, number + 1u, group_importance(cut_weight(left, surface, HAS_GLOSS)), has_place(left, place));
        weigh(choice, left.next, group_importance(cut_weight(right, surface, HAS_GLOSS)), has_place(right, place));
        draw = draw_of(choice, sought);
        if (draw.light == NONE) return draw;
        probability *= draw.probability;
        chance = choice.chance;
        group = right;
        if (draw.light == number + 1u) group = left;
        number = draw.light;
    }
    choice = new_choice(new_reservoir(u.z));
    weigh_lights(choice, group, surface, sought);
    draw = draw_of(choice, sought);
    return CutDraw(draw.light, probability * draw.probability);
}

#endif
