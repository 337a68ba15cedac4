// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/guiding/cdq_report.h"

#include "shared/cdq.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

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

CdqReport report_cdq(glm::uvec4 tree, uint32_t bits, glm::vec3 normal) {
    CdqReport report;
    report.bits = bits;
    const uint32_t leaves = shader::cdq_leaf_count(bits);
    for (uint32_t leaf = 0; leaf < leaves; ++leaf) {
        const shader::CdqCell cell = shader::cdq_cell(tree, shader::cdq_leaf(tree, bits, leaf));
        CdqReport::Cell row;
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
    report.most = report.cells.front().density;
    report.least = report.cells.back().density;
    return report;
}

glm::vec2 pitch_and_yaw(glm::vec3 direction) {
    const float level = std::hypot(direction.x, direction.y);
    return glm::degrees(
        glm::vec2(-std::atan2(direction.z, level), std::atan2(direction.y, direction.x)));
}

std::string cdq_text(const CdqReport& report, size_t most_cells) {
    std::string text =
        fmt::format("  quadtree        {} bits, {} leaves, the smallest at level {}\n", report.bits,
                    report.cells.size(), report.deepest);
    text += fmt::format("  density         {:.3g} to {:.3g} per steradian\n", report.least,
                        report.most);
    text += fmt::format("  below horizon   {:.1f} % of its draws\n", 100.0f * report.below_horizon);
    text += "  its densest leaves (yaw from +x, pitch down positive, degrees):";
    const size_t listed = std::min(report.cells.size(), most_cells);
    for (size_t i = 0; i < listed; ++i) {
        const CdqReport::Cell& cell = report.cells[i];
        const glm::vec2 angles = pitch_and_yaw(cell.direction);
        text += fmt::format("\n    yaw {:7.1f}  pitch {:6.1f}  level {:2}  {:.3g} per steradian",
                            angles.y, angles.x, cell.depth, cell.density);
    }
    if (report.cells.size() > listed)
        text += fmt::format("\n    and {} less dense ones", report.cells.size() - listed);
    return text;
}

} // namespace vigil::vkpt
