// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/guiding/octree_start.h"

#include "shared/random.h"
#include "shared/sampling.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace vigil::vkpt {

namespace {

/// Nearer surfaces count as if they were so far away: there are few, and the eye moves.
constexpr float least_distance = 32.0f;

struct Expected {
    glm::uvec3 grid;
    float samples;
};

/// Some of the points, which lie in one cell.
struct Range {
    shader::OctreeCell cell;
    size_t first, end;
};

std::vector<Expected> expect(std::span<const SurfacePoint> points, const OctreeNeeds& needs) {
    std::vector<Expected> all;
    all.reserve(points.size());
    double sum = 0.0;
    for (const SurfacePoint& point : points) {
        const glm::vec3 to_eye = needs.eye - point.position;
        const float squared = std::max(least_distance * least_distance, glm::dot(to_eye, to_eye));
        all.push_back(
            {shader::octree_grid(point.position, needs.corner, needs.scale), point.area / squared});
        sum += static_cast<double>(all.back().samples);
    }
    const auto factor = static_cast<float>(sum > 0.0 ? needs.samples / sum : 0.0);
    for (Expected& one : all)
        one.samples *= factor;
    return all;
}

/// Sorts a cell's points by its children; child i has those from i to i + 1.
std::array<size_t, 9> part(std::vector<Expected>& points, const Range& range) {
    std::array<size_t, 9> bounds{};
    bounds.front() = range.first;
    auto rest = points.begin() + static_cast<std::ptrdiff_t>(range.first);
    const auto end = points.begin() + static_cast<std::ptrdiff_t>(range.end);
    for (uint32_t child = 0; child < 8; ++child) {
        rest = std::partition(rest, end, [&](const Expected& one) {
            return shader::octree_child(one.grid, range.cell.depth) == child;
        });
        bounds.at(child + 1) = static_cast<size_t>(rest - points.begin());
    }
    return bounds;
}

} // namespace

std::vector<SurfacePoint> surface_points(std::span<const shader::BvhTriangle> triangles,
                                         size_t wanted) {
    const auto area_of = [](const shader::BvhTriangle& triangle) {
        const float area = 0.5f * glm::length(glm::cross(triangle.e1, triangle.e2));
        return std::isfinite(area) ? area : 0.0f;
    };
    double all = 0.0;
    for (const shader::BvhTriangle& triangle : triangles)
        all += static_cast<double>(area_of(triangle));
    std::vector<SurfacePoint> points;
    for (const shader::BvhTriangle& triangle : triangles) {
        const float area = area_of(triangle);
        if (!(area > 0.0f)) continue;
        const double share = static_cast<double>(area) / all * static_cast<double>(wanted);
        const auto count = static_cast<uint32_t>(std::max(share, 1.0));
        for (uint32_t i = 0; i < count; ++i) {
            const glm::uvec2 words = (i + 1) * glm::uvec2(shader::R2_STEPS);
            const glm::vec2 at = shader::sample_triangle(glm::vec2(words) / 4294967296.0f);
            points.push_back({triangle.v0 + at.x * triangle.e1 + at.y * triangle.e2,
                              area / static_cast<float>(count)});
        }
    }
    return points;
}

OctreeStart start_octree(std::span<const SurfacePoint> points, const OctreeNeeds& needs) {
    std::vector<Expected> all = expect(points, needs);
    OctreeStart start;
    std::vector<Range> nodes{{{glm::uvec3(0), 0}, 0, all.size()}};
    for (size_t node = 0; node < nodes.size(); ++node) {
        const Range range = nodes[node];
        const std::array<size_t, 9> bounds = part(all, range);
        const auto first_inner = static_cast<uint32_t>(nodes.size());
        uint32_t leaf_mask = shader::OCTREE_ALL_LEAVES;
        for (uint32_t child = 0; child < 8; ++child) {
            double samples = 0.0;
            for (size_t i = bounds.at(child); i < bounds.at(child + 1); ++i)
                samples += static_cast<double>(all[i].samples);
            const bool splits = samples > needs.split && nodes.size() < needs.most_nodes &&
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
