// SPDX-License-Identifier: GPL-2.0-or-later
// A binary tree over the lights of a frame by the surface area orientation heuristic of Conty
// Estevez and Kulla 2018, binned (Wald 2007): near lights of like orientation share a subtree.
// Knows nothing of how nodes are stored for the GPU (light_hierarchy.h) or walked.
#pragma once

#include "shared/scene_types.h"

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace vigil {

/// A light as the tree sorts it: only those that can light something are in it. Three rows of four
/// floats, which the build handles as wholes.
struct alignas(16) TreeLight {
    glm::vec3 lower;    // box around the triangle: every corner lies inside, rounding included
    float normal_error; // radians: how far single precision may see the normal elsewhere
    glm::vec3 upper;
    float unused;
    glm::vec3 normal; // unit, of the lit side
    float energy;     // light_power, in (0, 1e30]
    std::uint32_t id;
};

struct LightTreeNode {
    glm::vec3 lower, upper;     // box around the lights
    glm::vec3 normal_sum;       // of the lights' normals
    float energy;               // sum over the lights
    std::uint32_t first, count; // lights of this subtree: first .. first + count - 1
    std::uint32_t right;        // second child; the first one follows its parent. 0: a leaf
};

class LightTree {
public:
    /// Sorts the lights into a tree whose leaves hold at most `leaf_size` (at least 1). The sun is
    /// left out, and so are lights that are dark, have no area or are not finite. No path has more
    /// than 64 + 17 nodes for 100,000 lights (in general, 64 and the logarithm of their number).
    /// The same lights give the same tree. Memory is kept from call to call.
    void build(std::span<const shader::Light> lights, std::uint32_t leaf_size);

    std::span<const TreeLight> lights() const { return lights_; }
    /// Node 0 is the root; no nodes without lights. Some places between nodes may be unused.
    std::span<const LightTreeNode> nodes() const { return nodes_; }

private:
    void build_node(std::uint32_t node, std::uint32_t first, std::uint32_t count,
                    std::uint32_t depth);

    std::vector<TreeLight> lights_;
    std::vector<LightTreeNode> nodes_;
    std::uint32_t leaf_size_ = 1;
};

} // namespace vigil
