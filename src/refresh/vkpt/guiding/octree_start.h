// SPDX-License-Identifier: GPL-2.0-or-later
// The octree before its first frame: as fine as paths traced on the host let expect
// (first_paths.h). From a single node it would take a frame for each level of the tree.
#pragma once

#include "shared/octree.h"

#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace vigil::vkpt {

/// A tree in the order of its nodes, breadth first; the root is node 0.
struct OctreeStart {
    std::vector<uint32_t> nodes;       // octree_node
    std::vector<glm::uvec2> cells;     // octree_pack_cell
    std::vector<uint32_t> leaf_counts; // samples expected, by leaf (octree_leaf)
};

/// What an octree is to be like.
struct OctreeNeeds {
    glm::vec3 corner{};   // of the root's cube
    float scale = 1.0f;   // smallest cells per map unit
    float samples = 0.0f; // of a frame
    uint32_t split = 1;   // leaves with more are split
    size_t most_nodes = 1;
};

/// Each of these places, in map units, stands for as many samples. Without any the root has eight
/// leaves.
OctreeStart start_octree(std::span<const glm::vec3> places, const OctreeNeeds& needs);

} // namespace vigil::vkpt
