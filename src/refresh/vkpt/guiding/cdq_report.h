// SPDX-License-Identifier: GPL-2.0-or-later
// A directional quadtree (shaders/shared/cdq.h) in numbers: how deep it is, where its finest cells
// look, how dense its draws are, and how many of them a surface loses below its horizon. Needs no
// GPU.
#pragma once

#include "refresh/reports.h"

namespace vigil::vkpt {

/// `bits` is 32, 64, 96 or 128; `normal` is the surface's, unit.
refresh::QuadtreeReport report_cdq(glm::uvec4 tree, uint32_t bits, glm::vec3 normal);

} // namespace vigil::vkpt
