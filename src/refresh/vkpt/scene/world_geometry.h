// SPDX-License-Identifier: GPL-2.0-or-later
// Faces of a BSP level as triangles with materials, lights and PVS clusters.
#pragma once

#include "refresh/vkpt/scene/material_set.h"
#include "refresh/vkpt/scene/model_geometry.h"

namespace vigil {
struct Level;
}

namespace vigil::vkpt {

/// Triangles of brush model `model` (0: the static world). Hidden faces (NODRAW, SKIP, HINT) are
/// left out, and so are the emissive faces' light styles other than the first that is not 0.
/// Clusters are set for the world only.
ModelGeometry brush_model_geometry(const Level& level, uint32_t model, MaterialSet& materials);

/// The world's BSP tree as the GPU walks it to find a point's cluster. Never empty.
std::vector<shader::BspTreeNode> cluster_tree(const Bsp& bsp);

} // namespace vigil::vkpt
