// SPDX-License-Identifier: GPL-2.0-or-later
// The Light Hierarchy as the GPU reads it (shaders/shared/light_hierarchy.h,
// shaders/light/lh.glsl): the binary tree of light_tree.h collapsed to wide nodes, each compressed
// into 64 or 128 bytes. Data only; the technique `lh` owns the buffers.
#pragma once

#include "refresh/vkpt/light/light_tree.h"
#include "shared/light_hierarchy.h"

#include <array>

namespace vigil {

struct LightHierarchyOptions {
    std::uint32_t width = 8;     // children of a node, 2 to 8
    std::uint32_t leaf_size = 2; // most lights in a leaf, at least 1
    bool operator==(const LightHierarchyOptions&) const = default;
};

inline constexpr std::uint32_t WIDEST_LIGHT_NODE = 8;

/// How the subtree of a binary node becomes wide nodes so that a draw visits the fewest (the
/// dynamic programme of Ylitie et al. 2017): a node is taken to be visited in proportion to its
/// energy.
struct WideLightPlan {
    /// Least sum of the energies of all nodes visited, if the subtree is shown as at most i + 1
    /// nodes side by side, and how many of them the left child gets; 0: one less does as well.
    std::array<float, WIDEST_LIGHT_NODE> cost;
    std::array<std::uint8_t, WIDEST_LIGHT_NODE> left;
    std::uint8_t left_child; // of its own children, how many are the left child's
};

class LightHierarchy {
public:
    /// Builds the hierarchy over the lights that can light anything; their index is their id.
    /// Memory is kept from call to call.
    void build(std::span<const shader::Light> lights, const LightHierarchyOptions& options);

    const shader::LightHierarchyHeader& header() const { return header_; }
    /// light_node_stride(header().groups) words for each node; node 0 is the root.
    std::span<const glm::uvec4> nodes() const { return nodes_; }
    /// Child c of node n, if it is a leaf, holds its lights from
    /// (n * 4 * groups + c) * leaf_size on: leaf_size ids, the last ones shader::NONE.
    std::span<const std::uint32_t> leaf_lights() const { return leaf_lights_; }
    /// By light id: index into leaf_lights; shader::NONE for lights that light nothing.
    std::span<const std::uint32_t> places() const { return places_; }
    /// By node: parent * 4 * groups + child; shader::NONE for the root.
    std::span<const std::uint32_t> parents() const { return parents_; }

private:
    /// Plans the subtree of a binary node.
    void plan_node(std::uint32_t number, std::uint32_t width);
    /// Writes the wide node `number`, which stands for the binary node queue_[number].
    void write_node(std::uint32_t number, const LightHierarchyOptions& options);

    LightTree tree_;
    std::vector<WideLightPlan> plans_; // by binary node
    std::vector<std::uint32_t> queue_; // binary node of each wide one, breadth-first
    shader::LightHierarchyHeader header_{};
    std::vector<glm::uvec4> nodes_;
    std::vector<std::uint32_t> leaf_lights_, places_, parents_;
};

} // namespace vigil
