// SPDX-License-Identifier: GPL-2.0-or-later
// How much of the light in their clusters' lists surfaces see. Where that is most of it,
// remembering what was seen gains little.
#pragma once

#include "refresh/vkpt/light/light_lists.h"

#include "shared/scene_types.h"

#include <span>

namespace vigil {

/// Part of the draws from lists that find their light in sight, in [0, 1]: a light is drawn in
/// proportion to what it would bring. Mean of 4,096 places spread over the faces of the static
/// world, without those that see no light; each is asked about at most 64 lights of its list. Only
/// the world's brushes are in the way. `lights` are those of the lists by id, without the sun. 1
/// where no place sees light.
double part_in_sight(const Bsp& bsp, const LightLists& lists,
                     std::span<const shader::Light> lights);

} // namespace vigil
