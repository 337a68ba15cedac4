// SPDX-License-Identifier: GPL-2.0-or-later
// A directional quadtree (shaders/shared/cdq.h) in numbers: how deep it is, where its finest cells
// look, how dense its draws are, and how many of them a surface loses below its horizon. For
// commands and tests; needs no GPU.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace vigil::vkpt {

struct CdqReport {
    /// A leaf's square on the octahedral map.
    struct Cell {
        glm::vec3 direction{0.0f}; // of its centre, unit
        uint32_t depth = 0;
        float density = 0.0f; // of draws there, per steradian
    };
    uint32_t bits = 0;
    uint32_t deepest = 0;
    std::vector<Cell> cells;         // one per leaf; the densest first
    float below_horizon = 0.0f;      // share of draws
    float least = 0.0f, most = 0.0f; // densities at the cells' centres
};

/// `bits` is 32, 64, 96 or 128; `normal` is the surface's, unit.
CdqReport report_cdq(glm::uvec4 tree, uint32_t bits, glm::vec3 normal);

/// Pitch (down positive) and yaw (counter-clockwise from +x) of a direction, in degrees, as a
/// view's angles.
glm::vec2 pitch_and_yaw(glm::vec3 direction);

/// Lines of text, the first `most_cells` of the cells among them.
std::string cdq_text(const CdqReport& report, size_t most_cells);

} // namespace vigil::vkpt
