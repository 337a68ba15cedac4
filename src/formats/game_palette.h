// SPDX-License-Identifier: GPL-2.0-or-later
// What stands for the game's palette where its file (pics/colormap.pcx) is not at hand.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

namespace vigil {

/// About the colour that the game's effects mean by this index: linear, 0..1.
glm::vec3 palette_color(uint8_t index);

} // namespace vigil
