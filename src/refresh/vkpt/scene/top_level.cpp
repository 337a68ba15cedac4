// SPDX-License-Identifier: GPL-2.0-or-later
// Writes the binary tree of sah_builder in depth-first order with skip links.
#include "refresh/vkpt/scene/top_level.h"

#include "refresh/vkpt/scene/sah_builder.h"

namespace vigil {

namespace {

/// World boxes grow by this share of their largest coordinate: rounding of the transform and the
/// box test.
constexpr float box_padding = 16.0f / 16777216.0f;

void write_bounds(const Bounds& bounds, shader::TopNode& node) {
    const glm::vec3 magnitude = glm::max(glm::abs(bounds.lower), glm::abs(bounds.upper));
    const float pad = box_padding * glm::max(glm::max(magnitude.x, magnitude.y), magnitude.z);
    node.lower = bounds.lower - pad;
    node.upper = bounds.upper + pad;
}

void write_subtree(const SahNode& tree, std::span<const SahItem> items,
                   std::span<const TopLevelInstance> instances,
                   std::vector<shader::TopNode>& nodes) {
    const std::size_t index = nodes.size();
    nodes.emplace_back();
    nodes[index].instance = shader::NONE;
    write_bounds(tree.bounds, nodes[index]);
    if (tree.leaf()) {
        const TopLevelInstance& source = instances[items[tree.item].index];
        nodes[index].instance = source.instance;
        nodes[index].object_from_world = source.object_from_world;
        nodes[index].root = source.bvh_root;
        nodes[index].flags = source.flags;
    } else {
        write_subtree(*tree.child[0], items, instances, nodes);
        write_subtree(*tree.child[1], items, instances, nodes);
    }
    nodes[index].skip = static_cast<std::uint32_t>(nodes.size());
}

} // namespace

Bounds transform_bounds(const Bounds& bounds, const glm::mat4x3& world_from_object) {
    Bounds result;
    if (bounds.empty()) return result;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec3 point((corner & 1) != 0 ? bounds.upper.x : bounds.lower.x,
                              (corner & 2) != 0 ? bounds.upper.y : bounds.lower.y,
                              (corner & 4) != 0 ? bounds.upper.z : bounds.lower.z);
        result.grow(world_from_object * glm::vec4(point, 1.0f));
    }
    return result;
}

std::vector<shader::TopNode> build_top_level(std::span<const TopLevelInstance> instances) {
    std::vector<SahItem> items;
    items.reserve(instances.size());
    for (std::size_t i = 0; i < instances.size(); ++i) {
        if (instances[i].object_bounds.empty()) continue;
        items.push_back(
            {transform_bounds(instances[i].object_bounds, instances[i].world_from_object),
             static_cast<std::uint32_t>(i)});
    }
    std::vector<shader::TopNode> nodes;
    if (items.empty()) {
        nodes.emplace_back();
        nodes[0].lower = glm::vec3(1.0f);
        nodes[0].upper = glm::vec3(-1.0f);
        nodes[0].instance = shader::NONE;
        nodes[0].skip = shader::TOP_END;
        return nodes;
    }
    const auto root = build_sah(items, SahOptions{.threads = false});
    nodes.reserve(2 * items.size());
    write_subtree(*root, items, instances, nodes);
    for (shader::TopNode& node : nodes) {
        if (node.skip == nodes.size()) node.skip = shader::TOP_END;
    }
    return nodes;
}

} // namespace vigil
