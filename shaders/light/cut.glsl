// SPDX-License-Identifier: GPL-2.0-or-later
// Technique `cut`: light cuts by cluster. Each PVS cluster has at most pt_cut_size entries for all lights which may be seen from there:
// single lights nearby, groups of lights farther off. Nothing learns. The sun is drawn beside them (light/sun_share.glsl).
// Host side: refresh/vkpt/light/cut.cpp.
#include "light/sun_share.glsl"
#include "light/importance.glsl"

/// All lights may be drawn.
float cut_light_weight(LtcSurface surface, uint light) { return light_importance(surface, light); }

#include "light/cut_draw.glsl"

/// What the draws of a surface have in common.
struct CutSearch {
    LightCut cut; // without the sun
    float of_sun; // part of the draws that are of the sun
    LtcSurface prepared;
};

CutSearch prepare_search(Surface surface) {
    CutSearch search = CutSearch(find_cut(surface), 0.0, prepare_importance(surface));
    if (!HAS_ENVIRONMENT || search.cut.still.y == 0u) return search;
    const uint last = load_word(cut_entries, search.cut.still.x + search.cut.still.y - 1u);
    if ((last & CUT_GROUP) != 0u || load_word(cut_order, cut_run_first(last)) != frame.sun_light) return search;
    search.cut.still.y -= 1u;
    search.of_sun = sun_share(surface, cut_size(search.cut) != 0u);
    return search;
}

LightChoice choose_light(Surface surface, inout Random random) {
    const CutSearch search = prepare_search(surface);
    vec3 u = random_next3(random);
    if (u.x < search.of_sun) return light_choice(frame.sun_light, search.of_sun);
    u.x = (u.x - search.of_sun) / (1.0 - search.of_sun);
    const CutDraw draw = draw_from_cut(search.cut, search.prepared, NONE, u);
    if (!(draw.probability > 0.0)) return no_light();
    return light_choice(draw.light, (1.0 - search.of_sun) * draw.probability);
}

float light_probability(Surface surface, uint light) {
    const CutSearch search = prepare_search(surface);
    if (HAS_ENVIRONMENT && light == frame.sun_light) return search.of_sun;
    return (1.0 - search.of_sun) * draw_from_cut(search.cut, search.prepared, light, vec3(0.0)).probability;
}
