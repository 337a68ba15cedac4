// SPDX-License-Identifier: GPL-2.0-or-later
#include "formats/game_palette.h"

namespace vigil {

glm::vec3 palette_color(uint8_t index) {
    // By the ramps of 8 or 16 that the game's effects use.
    if (index < 0x10) return glm::vec3(0.2f + 0.05f * static_cast<float>(index));
    if (index >= 0x60 && index < 0x80) return {0.2f, 0.4f, 0.8f};
    if (index >= 0xb0 && index < 0xc0) return {0.5f, 0.5f, 1.0f};
    if (index >= 0xd0 && index < 0xd8) return {0.1f, 1.0f, 0.1f};
    if (index >= 0xdc && index < 0xe0) return {1.0f, 0.9f, 0.1f};
    if (index >= 0xe0 && index < 0xe8) return {1.0f, 0.6f, 0.1f};
    if (index >= 0xe8 && index < 0xf0) return {0.5f, 0.0f, 0.0f};
    if (index == 0xf0 || index == 0xf2) return {1.0f, 0.05f, 0.05f};
    if (index == 0xf1 || index == 0xf3) return {0.1f, 0.1f, 1.0f};
    return glm::vec3(0.6f);
}

} // namespace vigil
