// SPDX-License-Identifier: GPL-2.0-or-later
// A draw from a light cut (cut_lists.glsl): all entries are weighed and one is drawn; in a group, one light by its weight. Groups that are near are
// weighed light by light. A technique's file includes this one after light/candidate_walk.glsl, and has beside what that asks for
//   LtcSurface candidate_surface(Candidates c)                       what the candidates are to shine on
//   Candidates candidates_at(Candidates like, uint first, uint end)  those at such places of cut_order, else as they are

/// What a group may bring. `walks`: lights that may still be weighed for that.
float group_importance(Candidates like, CutGroup group, inout uint walks) {
    const CutWeight weight = cut_weight(group, candidate_surface(like), HAS_GLOSS);
    if (weight.importance > 0.0 && weight.width > CUT_NEAR && group.count <= min(CUT_WALK, walks)) {
        walks -= group.count;
        return walk_candidates(candidates_at(like, group.first, group.first + group.count), NONE, 0.0).sum;
    }
    return min(weight.importance, LIGHT_IMPORTANCE_MOST);
}

/// A light and the probability of its draw.
struct CutDraw {
    uint light;        // NONE: none was drawn
    float weight;      // its own
    float probability; // 0: none, or the sought light is not in the cut or weighs nothing
};

/// Draws a light by `u`, in [0, 1); or finds the probability of `sought`, unless that is NONE.
CutDraw draw_from_cut(LightCut cut, Candidates like, uint sought, vec3 u) {
    const CutDraw nothing = CutDraw(sought, 0.0, 0.0);
    const uint place = sought == NONE ? NONE : place_in_cut(cut, sought);
    if (sought != NONE && place == NONE) return nothing;
    Reservoir entries = new_reservoir(u.x);
    uint walks = CUT_WALKS;
    uint holder = NONE; // the entry with the sought light
    float holder_weight = 0.0;
    for (uint i = 0u; i < cut_size(cut); ++i) {
        const uint entry = load_word(cut_entries, i < cut.still.y ? cut.still.x + i : cut.moving.x + (i - cut.still.y));
        float weight;
        bool holds = entry == sought;
        if ((entry & CUT_GROUP) != 0u) {
            const CutGroup group = load_group(entry & ~CUT_GROUP);
            weight = group_importance(like, group, walks);
            holds = place - group.first < group.count; // NONE is in none
        } else {
            weight = candidate_weight(like, entry);
        }
        reservoir_add(entries, entry, weight);
        if (!holds || sought == NONE) continue;
        holder = entry;
        holder_weight = weight;
    }
    const uint chosen = sought == NONE ? entries.chosen : holder;
    const float weight = sought == NONE ? entries.chosen_importance : holder_weight;
    if (chosen == NONE || !(weight > 0.0)) return nothing;
    float probability = weight / entries.sum;
    if ((chosen & CUT_GROUP) == 0u) return CutDraw(chosen, weight, probability);

    CutGroup group = load_group(chosen & ~CUT_GROUP);
    while (group.count > CUT_WALK) { // one of its halves
        const CutGroup left = load_group(group.left), right = load_group(group.right);
        uint halves = 2u * CUT_WALK;
        const float a = group_importance(like, left, halves), b = group_importance(like, right, halves);
        if (!(a + b > 0.0)) return nothing;
        const float share = a / (a + b);
        const bool in_left = sought == NONE ? u.y < share : place - left.first < left.count;
        u.y = in_left ? u.y / share : (u.y - share) / (1.0 - share);
        probability *= in_left ? share : 1.0 - share;
        group = left;
        if (!in_left) group = right;
    }
    const CandidateWalk walk = walk_candidates(candidates_at(like, group.first, group.first + group.count), sought, u.z);
    return CutDraw(walk.light, walk.weight, walk.weight > 0.0 ? probability * (walk.weight / walk.sum) : 0.0);
}
