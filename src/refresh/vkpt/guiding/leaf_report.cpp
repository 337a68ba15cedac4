// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/guiding/leaf_report.h"

#include "refresh/vkpt/gpu/commands.h"
#include "shared/octree.h"

namespace vigil::vkpt {

namespace {

std::vector<uint32_t> download_words(const gpu::Device& device, const gpu::Buffer& buffer) {
    return gpu::download_now_as<uint32_t>(device, buffer, 0, buffer.bytes() / sizeof(uint32_t));
}

} // namespace

TreeCopy::TreeCopy(const gpu::Device& device, const Guiding& guiding)
    : header_(guiding.header()), guided_(guiding.guided()) {
    device.wait_idle();
    nodes_ = download_words(device, guiding.tree().nodes);
    nodes_.erase(nodes_.begin()); // their number
    leaves_ = download_words(device, guiding.tree().leaves);
    vlc_lights_ = download_words(device, guiding.vlc_lights());
}

LeafReport TreeCopy::leaf_at(glm::vec3 position, uint32_t bucket_size) const {
    LeafReport report;
    // Walk down.
    const glm::uvec3 grid = shader::octree_grid(position, header_.corner, header_.scale);
    shader::OctreeDescent descent = shader::octree_root();
    while (descent.leaf == shader::NONE) {
        report.path.push_back(shader::octree_child(grid, descent.depth));
        shader::octree_descend(descent, nodes_[descent.node], grid);
    }
    report.leaf = descent.leaf;
    const shader::OctreeCell cell = shader::octree_cell(grid, descent.depth);
    report.corner = header_.corner + glm::vec3(cell.corner) / header_.scale;
    report.size = static_cast<float>(shader::octree_cell_size(cell.depth)) / header_.scale;

    // What its arrays say.
    const uint32_t leaf = report.leaf;
    report.samples = leaf_word(shader::LEAF_COUNT, leaf);
    report.room = leaf_word(shader::LEAF_STORAGE, leaf, 1);
    report.explore_share = shader::explore_unpack({leaf_word(shader::LEAF_EXPLORE, leaf),
                                                   leaf_word(shader::LEAF_EXPLORE, leaf, 1)})
                               .share;
    if (guided_) {
        const uint32_t node = shader::octree_node_of(leaf);
        report.rays = node_word(shader::NODE_RAYS, node);
        report.ray_room = node_word(shader::NODE_RAY_STORAGE, node, 1);
        for (uint32_t word = 0; word < 4; ++word)
            report.guide[static_cast<glm::length_t>(word)] =
                node_word(shader::NODE_GUIDE, node, word);
        report.guide_share = shader::share_unpack(
            {node_word(shader::NODE_SHARE, node), node_word(shader::NODE_SHARE, node, 1)});
    }
    report.source = leaf_word(shader::LEAF_SOURCE, leaf) & ~shader::SOURCE_SPLIT;
    for (uint32_t face = 0; face < 6; ++face)
        report.neighbours[face] = leaf_word(shader::LEAF_NEIGHBOURS, leaf, face);
    const uint32_t first = leaf_word(shader::LEAF_VLC, leaf);
    report.buckets.resize(leaf_word(shader::LEAF_VLC, leaf, 1));
    for (size_t bucket = 0; bucket < report.buckets.size(); ++bucket) {
        for (uint32_t i = 0; i < bucket_size; ++i) {
            const uint32_t entry = vlc_lights_[first + bucket * bucket_size + i];
            if (entry == shader::NONE) break;
            report.buckets[bucket].push_back(entry & shader::VLC_ID_MASK);
        }
    }
    return report;
}

} // namespace vigil::vkpt
