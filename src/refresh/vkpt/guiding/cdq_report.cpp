// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/guiding/cdq_report.h"

#include "shared/cdq.h"

#include <algorithm>

namespace vigil::vkpt {

namespace {

/// Share of a cell's area that looks below the horizon, from so many points squared.
constexpr uint32_t points_along_edge = 16;

float share_below(const shader::CdqCell& cell, glm::vec3 normal) {
    uint32_t below = 0;
    for (uint32_t y = 0; y < points_along_edge; ++y) {
        for (uint32_t x = 0; x < points_along_edge; ++x) {
            const glm::vec2 inside = (glm::vec2(x, y) + 0.5f) / float{points_along_edge};
            const glm::vec2 uv = cell.corner + cell.size * inside;
            below += glm::dot(normal, shader::octahedral_point(uv)) > 0.0f ? 0 : 1;
        }
    }
    return static_cast<float>(below) / float{points_along_edge * points_along_edge};
}

} // namespace

refresh::QuadtreeReport report_cdq(glm::uvec4 tree, uint32_t bits, glm::vec3 normal) {
    refresh::QuadtreeReport report;
    report.bits = bits;
    const uint32_t leaves = shader::cdq_leaf_count(bits);
    for (uint32_t leaf = 0; leaf < leaves; ++leaf) {
        const shader::CdqCell cell = shader::cdq_cell(tree, shader::cdq_leaf(tree, bits, leaf));
        refresh::QuadtreeReport::Cell row;
        row.direction = shader::octahedral_decode(cell.corner + 0.5f * cell.size);
        row.depth = cell.depth;
        row.density = shader::cdq_leaf_pdf(bits, cell.depth, row.direction);
        report.cells.push_back(row);
        report.deepest = std::max(report.deepest, cell.depth);
        // All leaves are drawn equally often.
        report.below_horizon += share_below(cell, normal) / static_cast<float>(leaves);
    }
    std::ranges::stable_sort(report.cells,
                             [](const auto& a, const auto& b) { return a.density > b.density; });
    return report;
}

} // namespace vigil::vkpt
