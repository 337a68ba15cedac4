// SPDX-License-Identifier: GPL-2.0-or-later
// How many samples a new leaf is to expect, from the samples of its source in the frame before: what its storage is made for.
#ifndef VIGIL_GUIDING_OCTREE_DEMAND_GLSL
#define VIGIL_GUIDING_OCTREE_DEMAND_GLSL

#include "guiding/passes.glsl"

/// One of the eight parts of a leaf that is split: surfaces cross half of them.
uint demand_of_part(uint count) { return (count + 3u) / 4u; }

/// The leaf that an old node collapses into.
uint demand_of_collapsed(uint node) {
    uint sum = 0u;
    for (uint child = 0u; child < 8u; ++child) sum += old_leaf_count(octree_leaf(node, child));
    return sum;
}

#endif
