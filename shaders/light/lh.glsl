// SPDX-License-Identifier: GPL-2.0-or-later
// Technique `lh`: the Light Hierarchy. From the root of a tree over all lights, one child of each node is drawn in proportion to what its lights
// may add to the surface (shared/light_hierarchy.h); in the leaf, one light in proportion to its importance, as the other techniques weigh lights.
// Nothing learns: visibility is not known. Host side: refresh/vkpt/light/lh.cpp.
#include "light/sun_share.glsl"
#include "shared/light_hierarchy.h"

layout(set = SET_TECHNIQUE, binding = BINDING_LIGHT_NODES) uniform utextureBuffer light_nodes; // records
// Lights of leaves: leaf_size of them, NONE where there are fewer, for child c of node n from (n * 4 * groups + c) * leaf_size on.
layout(set = SET_TECHNIQUE, binding = BINDING_LEAF_LIGHTS) uniform utextureBuffer leaf_lights;
// LightHierarchyHeader, and where each light is in leaf_lights; NONE if it can light nothing: dark, or without area.
layout(set = SET_TECHNIQUE, binding = BINDING_LIGHT_PLACES) uniform utextureBuffer light_places;
// Where a node hangs, as its parent's number * 4 * groups + child; NONE: the root.
layout(set = SET_TECHNIQUE, binding = BINDING_LIGHT_PARENTS) uniform utextureBuffer light_parents;

LightHierarchyHeader load_hierarchy() {
    return LightHierarchyHeader(load_word(light_places, 0u), load_word(light_places, 1u), load_word(light_places, 2u),
                                load_word(light_places, 3u));
}

uvec4 load_light_node(uint word) { return texelFetch(light_nodes, int(word)); }

/// What drawing a child of a node depends on.
struct NodeView {
    LightNodeWeights weights;
    uint inner;       // bit i: child i is an inner node
    uint first_inner; // number of the first inner child
};

NodeView view_node(Surface surface, uint number, uint groups) {
    const uint at = number * light_node_stride(groups);
    const LightNode node = light_node(load_light_node(at));
    const uvec4 word2 = load_light_node(at + 3u);
    NodeView view;
    view.inner = node.inner;
    view.first_inner = word2.w;
    const vec4 importance0 =
        light_group_importance(node, load_light_node(at + 1u), load_light_node(at + 2u), word2, surface.origin, surface.normal);
    vec4 importance1 = vec4(0.0);
    if (groups > 1u) {
        const uvec4 word5 = load_light_node(at + 6u);
        if (word5.z != 0u) // it has children
            importance1 =
                light_group_importance(node, load_light_node(at + 4u), load_light_node(at + 5u), word5, surface.origin, surface.normal);
    }
    view.weights = light_node_weights(importance0, importance1);
    return view;
}

/// The lights of a leaf.
struct Candidates {
    uint first, end, stride;
    LtcSurface prepared;
};

uint candidate_light(Candidates candidates, uint i) { return load_word(leaf_lights, i); }
float candidate_weight(Candidates candidates, uint light) { return light_importance(candidates.prepared, light); }

#include "light/candidate_walk.glsl"

/// `edge` is the leaf's, as in light_parents.
Candidates leaf_candidates(Surface surface, uint edge, uint leaf_size) {
    return Candidates(edge * leaf_size, (edge + 1u) * leaf_size, 1u, prepare_importance(surface));
}

/// A random number is stretched after each use, until draws of this probability have used up so many of its 24 bits that a
/// child of the least share would be drawn with an error of more than 1/16.
const float REUSE_LIMIT = 1.0 / 256.0;

/// Random numbers for a walk of any length.
struct ReusedNumber {
    float u;     // uniform in [0, 1)
    float used;  // probability of all that it has drawn
    vec2 spare;  // the next ones
    uint spares; // how many of them there are
};

ReusedNumber begin_reuse(inout Random random) {
    const vec3 u = random_next3(random);
    return ReusedNumber(u.x, 1.0, u.yz, 2u);
}

/// After it has drawn something of probability `share`: `rest` is where in that interval it lay, in [0, 1).
void reuse(inout ReusedNumber number, float share, float rest, inout Random random) {
    number.u = clamp(rest, 0.0, 1.0 - 1.0 / 16777216.0);
    number.used *= share;
    if (number.used > REUSE_LIMIT) return;
    if (number.spares == 0u) {
        number = begin_reuse(random);
        return;
    }
    number = ReusedNumber(number.spare.x, 1.0, number.spare.yy, number.spares - 1u);
}

LightChoice choose_light(Surface surface, inout Random random) {
    const LightHierarchyHeader header = load_hierarchy();
    ReusedNumber random_number = begin_reuse(random);
    float probability = 1.0;
    const float of_sun = sun_share(surface, header.light_count != 0u);
    if (of_sun > 0.0) {
        if (random_number.u < of_sun) return light_choice(frame.sun_light, of_sun);
        probability = 1.0 - of_sun;
        reuse(random_number, probability, (random_number.u - of_sun) / probability, random);
    }
    if (header.light_count == 0u) return no_light();
    uint number = 0u;
    uint child;
    while (true) {
        const NodeView view = view_node(surface, number, header.groups);
        const float sum = light_node_sum(view.weights);
        if (!(sum > 0.0)) return no_light();
        const float target = random_number.u * sum;
        const LightNodeChoice drawn = light_node_choose(view.weights, target);
        const float share = drawn.weight / sum;
        probability *= share;
        reuse(random_number, share, (target - drawn.below) / drawn.weight, random);
        child = drawn.child;
        if ((view.inner >> child & 1u) == 0u) break;
        number = view.first_inner + bitCount(view.inner & ((1u << child) - 1u));
    }
    const Candidates candidates = leaf_candidates(surface, number * 4u * header.groups + child, header.leaf_size);
    const CandidateWalk walk = walk_candidates(candidates, NONE, random_number.u);
    return light_choice(walk.light, probability * walk.weight / walk.sum);
}

/// From the light's leaf to the root: the shares of all draws on the way.
float light_probability(Surface surface, uint light) {
    const LightHierarchyHeader header = load_hierarchy();
    const float of_sun = sun_share(surface, header.light_count != 0u);
    if (HAS_ENVIRONMENT && light == frame.sun_light) return of_sun;
    const uint place = load_word(light_places, 4u + light);
    if (place == NONE) return 0.0;
    const uint slots = 4u * header.groups;
    uint edge = place / header.leaf_size; // node * slots + child
    const CandidateWalk walk = walk_candidates(leaf_candidates(surface, edge, header.leaf_size), light, 0.0);
    if (!(walk.weight > 0.0)) return 0.0;
    float probability = (1.0 - of_sun) * walk.weight / walk.sum;
    while (edge != NONE) {
        const LightNodeWeights weights = view_node(surface, edge / slots, header.groups).weights;
        const float weight = light_node_weight(weights, edge % slots);
        if (!(weight > 0.0)) return 0.0;
        probability *= weight / light_node_sum(weights);
        edge = load_word(light_parents, edge / slots);
    }
    return probability;
}
