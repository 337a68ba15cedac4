// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/guiding/octree_start.h"

#include <algorithm>
#include <array>

namespace vigil::vkpt {

namespace {

/// Fewer places tell nothing of where samples are in their leaf.
constexpr size_t fewest_places = 4;

/// Some of the places, which lie in one cell.
struct Range {
    shader::OctreeCell cell;
    size_t first, end;
};

/// Sorts a cell's places by its children; child i has those from i to i + 1.
std::array<size_t, 9> part(std::vector<glm::uvec3>& places, const Range& range) {
    std::array<size_t, 9> bounds{};
    bounds.front() = range.first;
    auto rest = places.begin() + static_cast<std::ptrdiff_t>(range.first);
    const auto end = places.begin() + static_cast<std::ptrdiff_t>(range.end);
    for (uint32_t child = 0; child < 8; ++child) {
        rest = std::partition(rest, end, [&](const glm::uvec3& grid) {
            return shader::octree_child(grid, range.cell.depth) == child;
        });
        bounds.at(child + 1) = static_cast<size_t>(rest - places.begin());
    }
    return bounds;
}

} // namespace

OctreeStart start_octree(std::span<const glm::vec3> places, const OctreeNeeds& needs) {
    std::vector<glm::uvec3> all;
    all.reserve(places.size());
    for (const glm::vec3& place : places)
        all.push_back(shader::octree_grid(place, needs.corner, needs.scale));
    const double of_each = static_cast<double>(needs.samples) / static_cast<double>(all.size());
    OctreeStart start;
    std::vector<Range> nodes{{{glm::uvec3(0), 0}, 0, all.size()}};
    for (size_t node = 0; node < nodes.size(); ++node) {
        const Range range = nodes[node];
        const std::array<size_t, 9> bounds = part(all, range);
        const auto first_inner = static_cast<uint32_t>(nodes.size());
        uint32_t leaf_mask = shader::OCTREE_ALL_LEAVES;
        for (uint32_t child = 0; child < 8; ++child) {
            const size_t there = bounds.at(child + 1) - bounds.at(child);
            const double samples = there > 0 ? of_each * static_cast<double>(there) : 0.0;
            const bool splits = samples > needs.split && there >= fewest_places &&
                                nodes.size() < needs.most_nodes &&
                                range.cell.depth + 1 < shader::OCTREE_MAX_DEPTH;
            start.leaf_counts.push_back(splits ? 0 : static_cast<uint32_t>(samples));
            if (!splits) continue;
            leaf_mask &= ~(1u << child);
            nodes.push_back({shader::octree_child_cell(range.cell, child), bounds.at(child),
                             bounds.at(child + 1)});
        }
        start.nodes.push_back(shader::octree_node(leaf_mask, first_inner));
        start.cells.push_back(shader::octree_pack_cell(range.cell));
    }
    return start;
}

} // namespace vigil::vkpt
