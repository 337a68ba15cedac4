// SPDX-License-Identifier: GPL-2.0-or-later
// How much of the light in their clusters' lists surfaces see. Where that is nearly all of it, to
// remember what was seen is of no use.
#pragma once

#include "refresh/vkpt/light/light_lists.h"

#include "shared/scene_types.h"

#include <span>

namespace vigil {

/// Part of the draws from lists that find their light in sight, in [0, 1]: a light is drawn in
/// proportion to what it would bring, and a draw counts by what its place receives. Asked at 4,096
/// places spread over the faces of the static world, each of at most 64 lights of its list. Only
/// the world's brushes are in the way. `lights` are those of the lists by id, lamps all of them. 1
/// where no place receives light.
double part_in_sight(const Bsp& bsp, const LightLists& lists,
                     std::span<const shader::Light> lights);

} // namespace vigil
