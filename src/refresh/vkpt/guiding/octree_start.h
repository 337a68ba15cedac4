// SPDX-License-Identifier: GPL-2.0-or-later
// The octree before its first frame: as fine as the level's surfaces and the eye's place let
// expect. From a single node it would take a frame for each level of the tree.
#pragma once

#include "shared/octree.h"

#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace vigil::vkpt {

/// What stands for a part of the level's surfaces.
struct SurfacePoint {
    glm::vec3 position; // map units
    float area;         // square map units
};

/// Some `wanted` points, and at least one for each triangle with an area, spread evenly.
std::vector<SurfacePoint> surface_points(std::span<const shader::BvhTriangle> triangles,
                                         size_t wanted);

/// A tree in the order of its nodes, breadth first; the root is node 0.
struct OctreeStart {
    std::vector<uint32_t> nodes;       // octree_node
    std::vector<glm::uvec2> cells;     // octree_pack_cell
    std::vector<uint32_t> leaf_counts; // samples expected, by leaf (octree_leaf)
};

/// What an octree is to be like.
struct OctreeNeeds {
    glm::vec3 corner{}; // of the root's cube
    float scale = 1.0f; // smallest cells per map unit
    glm::vec3 eye{};
    float samples = 0.0f; // of a frame
    uint32_t split = 1;   // leaves with more are split
    size_t most_nodes = 1;
};

/// Expects samples in proportion to area over squared distance from the eye. Without points the
/// root has eight leaves.
OctreeStart start_octree(std::span<const SurfacePoint> points, const OctreeNeeds& needs);

} // namespace vigil::vkpt
