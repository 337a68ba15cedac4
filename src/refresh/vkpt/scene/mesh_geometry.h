// SPDX-License-Identifier: GPL-2.0-or-later
// Meshes (glTF) and MD2 poses as triangles with materials and lights. Shading is flat everywhere,
// see shaders/scene/surface.glsl, so normals are not kept.
#pragma once

#include "formats/md2.h"
#include "formats/mesh.h"
#include "refresh/vkpt/scene/material_set.h"
#include "refresh/vkpt/scene/model_geometry.h"

namespace vigil::vkpt {

/// All primitives of a mesh in one model. Every triangle with an emissive material becomes a light.
ModelGeometry mesh_geometry(const Mesh& mesh, MaterialSet& materials);

/// The pose mix(frame, old_frame, backlerp) of an MD2 with one material. Frame numbers wrap into
/// range.
ModelGeometry md2_geometry(const Md2& md2, int frame, int old_frame, float backlerp,
                           uint32_t material);

} // namespace vigil::vkpt
