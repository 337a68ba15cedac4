// SPDX-License-Identifier: GPL-2.0-or-later
// Particles as triangles that face the camera.
#pragma once

#include "refresh/refresh.h"
#include "refresh/vkpt/scene/material_set.h"
#include "refresh/vkpt/scene/model_geometry.h"

namespace vigil::vkpt {

/// A triangle for each of the frame's particles, and degenerate ones up to `capacity` (at least as
/// many), which no ray hits. In world space.
ModelGeometry particle_geometry(const refresh::Frame& frame, size_t capacity,
                                MaterialSet& materials);

} // namespace vigil::vkpt
