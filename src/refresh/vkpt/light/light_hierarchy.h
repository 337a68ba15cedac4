// SPDX-License-Identifier: GPL-2.0-or-later
// The Light Hierarchy as the GPU reads it (shaders/shared/light_hierarchy.h,
// shaders/light/lh.glsl): the binary tree of light_tree.h collapsed to wide nodes, each compressed
// into 64 or 128 bytes. Data only; the technique `lh` owns the buffers.
#pragma once

#include "refresh/vkpt/light/light_tree.h"
#include "shared/light_hierarchy.h"

namespace vigil {

struct LightHierarchyOptions {
    std::uint32_t width = 8;     // children of a node, 2 to 8
    std::uint32_t leaf_size = 2; // most lights in a leaf, at least 1
    bool operator==(const LightHierarchyOptions&) const = default;
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
    /// Writes the wide node `number`, which stands for the binary node queue_[number].
    void write_node(std::uint32_t number, const LightHierarchyOptions& options);

    LightTree tree_;
    std::vector<std::uint32_t> queue_; // binary node of each wide one, breadth-first
    shader::LightHierarchyHeader header_{};
    std::vector<glm::uvec4> nodes_;
    std::vector<std::uint32_t> leaf_lights_, places_, parents_;
};

} // namespace vigil
