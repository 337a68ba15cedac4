// SPDX-License-Identifier: GPL-2.0-or-later
// The same surfaces in more triangles: how rays' cost grows with the size of a level
// (`run bench scale`).
#pragma once

#include "refresh/vkpt/scene/model_geometry.h"

namespace vigil::vkpt {

/// Cuts every triangle that is no light into four between the middles of its edges, `times` times
/// over. Lights stay as they are: their number is another matter.
void subdivide(ModelGeometry& geometry, int times);

} // namespace vigil::vkpt
