// SPDX-License-Identifier: GPL-2.0-or-later
// Random quadtrees and ray samples for the nodes of an octree: directions all over the map and in
// its poles, corners and folds, contributions from nothing to more than can be stored, nodes
// without rays, with one, with thousands, and with more than they have room for.
#pragma once

#include "random_trees.h"

namespace vigil::test {

/// What rays bring.
enum class Brought {
    Anything, // all that can be stored, and more
    Powers,   // powers of two so near to each other that floats add their squares exactly
    Same,     // 1: leaves with as many rays are equal
};

struct RandomRays {
    Brought brought = Brought::Anything;
    uint32_t most = 500;     // rays of a node
    uint32_t migrations = 0; // of quadtrees before, at most: from the even tree to any tree
    bool remembered = false; // half of the nodes remember earlier rays
};

/// A direction's cell on the grid of the smallest squares, 0 .. 4095 each. `target` is a point of
/// the unit square that many of them are near.
glm::uvec2 random_cell(Dice& dice, glm::vec2 target);

/// A quadtree of `bits` bits after up to `migrations` random migrations.
Squares random_quadtree(Dice& dice, uint32_t bits, uint32_t migrations);

/// One that is as deep as it can be at a point of the unit square.
Squares quadtree_towards(uint32_t bits, glm::vec2 target);

/// Gives every node a quadtree of `bits` bits, most of them rays, and room for as many or for less,
/// in a buffer for `capacity` rays; fills the rest of that with garbage.
void add_random_rays(Dice& dice, const RandomRays& rays, uint32_t bits, uint32_t capacity,
                     TreeState& state);

} // namespace vigil::test
