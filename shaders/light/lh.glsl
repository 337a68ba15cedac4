// SPDX-License-Identifier: GPL-2.0-or-later
// Technique `lh`: the Light Hierarchy. From the root of a tree over all lights, one child of each node is drawn in proportion to what its lights
// may add to the surface (shared/light_hierarchy.h); in the leaf, one light in proportion to its importance, as the other techniques weigh lights.
// Nothing learns: visibility is not known. Host side: refresh/vkpt/light/lh.cpp.
#include "light/importance.glsl"
#include "light/reservoir.glsl"
#include "shared/light_hierarchy.h"

layout(set = SET_TECHNIQUE, binding = 0, scalar) restrict readonly buffer LightNodeBlock { uvec4 light_nodes[]; };
// Lights of leaves: leaf_size of them, NONE where there are fewer, for child c of node n from (n * children of a node + c) * leaf_size on.
layout(set = SET_TECHNIQUE, binding = 1, scalar) restrict readonly buffer LeafLightBlock { uint leaf_lights[]; };
layout(set = SET_TECHNIQUE, binding = 2, scalar) restrict readonly buffer LightPlaceBlock {
    LightHierarchyHeader hierarchy;
    uint light_places[]; // where a light is in leaf_lights; NONE if it can light nothing: dark, or without area
};
// Where a node hangs, as its parent's number * children of a node + child; NONE: the root.
layout(set = SET_TECHNIQUE, binding = 3, scalar) restrict readonly buffer LightParentBlock { uint light_parents[]; };

uint children_of_node() { return 4u * hierarchy.groups; }

/// What drawing a child of a node depends on.
struct NodeView {
    LightNodeWeights weights;
    uint inner;       // bit i: child i is an inner node
    uint first_inner; // number of the first inner child
};

NodeView view_node(Surface surface, uint number) {
    const uint at = number * light_node_stride(hierarchy.groups);
    const LightNode node = light_node(light_nodes[at]);
    const uvec4 word2 = light_nodes[at + 3u];
    NodeView view;
    view.inner = node.inner;
    view.first_inner = word2.w;
    const vec4 importance0 = light_group_importance(node, light_nodes[at + 1u], light_nodes[at + 2u], word2,
                                                    surface.origin, surface.normal);
    vec4 importance1 = vec4(0.0);
    if (hierarchy.groups > 1u) {
        const uvec4 word5 = light_nodes[at + 6u];
        if (word5.z != 0u) // it has children
            importance1 = light_group_importance(node, light_nodes[at + 4u], light_nodes[at + 5u], word5, surface.origin,
                                                 surface.normal);
    }
    view.weights = light_node_weights(importance0, importance1);
    return view;
}

/// Walks past the lights of a leaf; `first` is the place of its first light.
struct LeafWalk {
    Reservoir reservoir;
    float sought_importance; // of the light sought; 0 if it was not met
};

LeafWalk walk_leaf(Surface surface, uint first, uint sought, float u) {
    const LtcSurface prepared = prepare_importance(surface);
    LeafWalk walk = LeafWalk(new_reservoir(u), 0.0);
    for (uint i = 0u; i < hierarchy.leaf_size; ++i) {
        const uint light = leaf_lights[first + i];
        if (light == NONE) break;
        const float importance = light_importance(prepared, light);
        reservoir_add(walk.reservoir, light, importance);
        if (light == sought) walk.sought_importance = importance;
    }
    return walk;
}

/// A random number is stretched after each use, until draws of this probability have used up so many of its 24 bits that a
/// child of the least share would be drawn with an error of more than 1/64.
const float REUSE_LIMIT = 1.0 / 64.0;

LightChoice choose_light(Surface surface, inout Random random) {
    if (hierarchy.light_count == 0u) return light_choice(NONE, 0.0);
    vec3 u = random_next3(random);
    float probability = 1.0;
    float used = 1.0; // probability of what u.x has drawn
    uint number = 0u;
    uint child;
    while (true) {
        const NodeView view = view_node(surface, number);
        const float sum = light_node_sum(view.weights);
        if (!(sum > 0.0)) return light_choice(NONE, 0.0);
        const float target = u.x * sum;
        const LightNodeChoice drawn = light_node_choose(view.weights, target);
        const float share = drawn.weight / sum;
        probability *= share;
        used *= share;
        if (used > REUSE_LIMIT) {
            u.x = clamp((target - drawn.below) / drawn.weight, 0.0, 1.0 - 1.0 / 16777216.0);
        } else {
            u = vec3(u.y, u.z, random_next(random));
            used = 1.0;
        }
        child = drawn.child;
        if ((view.inner >> child & 1u) == 0u) break;
        number = view.first_inner + bitCount(view.inner & ((1u << child) - 1u));
    }
    const uint first = (number * children_of_node() + child) * hierarchy.leaf_size;
    const Reservoir reservoir = walk_leaf(surface, first, NONE, u.x).reservoir;
    if (reservoir.chosen == NONE) return light_choice(NONE, 0.0);
    return light_choice(reservoir.chosen, probability * reservoir.chosen_importance / reservoir.sum);
}

/// From the light's leaf to the root: the shares of all draws on the way.
float light_probability(Surface surface, uint light) {
    const uint place = light_places[light];
    if (place == NONE) return 0.0;
    uint edge = place / hierarchy.leaf_size;
    const LeafWalk walk = walk_leaf(surface, edge * hierarchy.leaf_size, light, 0.0);
    if (!(walk.sought_importance > 0.0)) return 0.0;
    float probability = walk.sought_importance / walk.reservoir.sum;
    while (edge != NONE) {
        const uint number = edge / children_of_node();
        const LightNodeWeights weights = view_node(surface, number).weights;
        const float weight = light_node_weight(weights, edge % children_of_node());
        if (!(weight > 0.0)) return 0.0;
        probability *= weight / light_node_sum(weights);
        edge = light_parents[number];
    }
    return probability;
}
