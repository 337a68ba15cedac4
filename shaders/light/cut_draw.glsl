// SPDX-License-Identifier: GPL-2.0-or-later
// A draw from a light cut (cut_lists.glsl). All entries are weighed and one is drawn; in a group, one light by the weights of its halves. Groups
// that are near are opened before, and their lights weighed one by one: the cut of a cluster becomes one of the surface.
// A technique's file says what a single light weighs, and includes this one after that:
//   cut_light_weight(surface, light)  not negative, and above 0 for a light that can shine on the surface and may be drawn
#ifndef VIGIL_LIGHT_CUT_DRAW_GLSL
#define VIGIL_LIGHT_CUT_DRAW_GLSL

#include "light/cut_lists.glsl"
#include "light/importance.glsl"
#include "shared/reservoir.h"

/// What was drawn, and the probability of that.
struct CutDraw {
    uint light;        // or a group. NONE: nothing was drawn
    float probability; // 0: nothing, or the sought light is not among what was weighed or weighs nothing
    float weight;      // its own
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
        weigh(choice, light, cut_light_weight(surface, light), light == sought);
    }
}

/// Runs of lights that are left to be weighed one by one (cut_run). They wait until the groups are weighed: in one loop for both, each invocation
/// of a subgroup would wait whenever another has lights.
const uint CUT_LISTED = 32u;
uint cut_listed[CUT_LISTED];

void weigh_listed(inout CutChoice choice, uint listed, LtcSurface surface, uint sought) {
    uint at = 0u, within = 0u;
    while (at < listed) {
        const uint run = cut_listed[at];
        const uint light = load_word(cut_order, cut_run_first(run) + within);
        weigh(choice, light, cut_light_weight(surface, light), light == sought);
        within += 1u;
        if (within < cut_run_count(run)) continue;
        at += 1u;
        within = 0u;
    }
}

uint cut_entry(LightCut cut, uint i) {
    return load_word(cut_entries, i < cut.still.y ? cut.still.x + i : cut.moving.x + (i - cut.still.y));
}

/// Weighs the entries of a cut, or what stands for those that are near. One loop goes through the groups of all entries, so that invocations
/// with few of them near are not kept waiting at each.
void weigh_cut(inout CutChoice choice, LightCut cut, LtcSurface surface, uint sought, uint place) {
    uint entries = 0u;              // begun
    uint number = NONE, end = NONE; // group, and that after the entry
    uint opened = 0u;               // groups and lights weighed in place of others
    bool all = false;
    while (!all) {
        uint listed = 0u;
        while (listed < CUT_LISTED) {
            if (number == end) {
                all = entries == cut_size(cut);
                if (all) break;
                const uint entry = cut_entry(cut, entries++);
                if ((entry & CUT_GROUP) == 0u) {
                    cut_listed[listed++] = entry;
                    continue;
                }
                number = entry & ~CUT_GROUP;
                end = NONE;
            }
            const CutGroup group = load_group(number);
            if (end == NONE) end = group.next;
            const CutWeight weight = cut_weight(group, surface, HAS_GLOSS);
            const bool opens = weight.importance > 0.0 && weight.width > CUT_NEAR + CUT_HARDER * float(opened);
            const bool halves = opens && group.count > CUT_LEAF;
            if (!opens) weigh(choice, CUT_GROUP | number, group_importance(weight), has_place(group, place));
            else opened += halves ? 2u : group.count;
            if (opens && !halves) cut_listed[listed++] = cut_run(group.first, group.count);
            number = halves ? number + 1u : group.next;
        }
        weigh_listed(choice, listed, surface, sought);
    }
}

CutDraw draw_of(CutChoice choice, uint sought) {
    const uint entry = sought == NONE ? choice.chance.chosen : choice.holder;
    const float weight = sought == NONE ? choice.chance.chosen_importance : choice.holder_weight;
    if (entry == NONE || !(weight > 0.0)) return CutDraw(NONE, 0.0, 0.0);
    return CutDraw(entry, weight / choice.chance.sum, weight);
}

/// Draws a light by `u`, in [0, 1); or finds the probability of `sought`, unless that is NONE.
CutDraw draw_from_cut(LightCut cut, LtcSurface surface, uint sought, vec3 u) {
    const uint place = sought == NONE ? NONE : place_in_cut(cut, sought);
    const bool sun = HAS_ENVIRONMENT && sought == frame.sun_light; // an entry of its own, in no list
    if (sought != NONE && place == NONE && !sun) return CutDraw(NONE, 0.0, 0.0);
    CutChoice choice = new_choice(new_reservoir(u.x));
    weigh_cut(choice, cut, surface, sought, place);
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
    return CutDraw(draw.light, probability * draw.probability, draw.weight);
}

#endif
