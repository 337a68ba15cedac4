// SPDX-License-Identifier: GPL-2.0-or-later
// Meshes (glTF) and MD2 poses as triangles with materials and lights. Shading is flat everywhere,
// see shaders/scene/surface.glsl, so normals are not kept.
#pragma once

#include "formats/md2.h"
#include "formats/mesh.h"
#include "formats/sp2.h"
#include "refresh/vkpt/scene/material_set.h"
#include "refresh/vkpt/scene/model_geometry.h"

namespace vigil::vkpt {

/// All primitives of a mesh in one model. Every triangle with an emissive material becomes a light.
ModelGeometry mesh_geometry(const Mesh& mesh, MaterialSet& materials);

/// A pose of an MD2: mix(frame, old_frame, backlerp), each vertex `swell` units out along its
/// normal.
struct Md2Pose {
    int frame = 0, old_frame = 0; // wrap into range
    float backlerp = 0.0f;
    float swell = 0.0f;
    uint32_t material = 0;
    bool operator==(const Md2Pose&) const = default;
};
ModelGeometry md2_geometry(const Md2& md2, const Md2Pose& pose);

/// A sprite's quad: seen along +x from its front, y to the left, z up.
ModelGeometry sprite_geometry(const Sp2Frame& frame, uint32_t material);

/// `number` modulo the number of frames, also for negative ones.
size_t wrap_frame(int number, size_t count);

} // namespace vigil::vkpt
