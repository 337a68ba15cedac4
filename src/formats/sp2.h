// SPDX-License-Identifier: GPL-2.0-or-later
// SP2 (IDS2, version 2), Quake II's sprite: pictures that face the camera, one for each frame.
#pragma once

#include <glm/vec2.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace vigil {

struct Sp2Frame {
    glm::ivec2 size{0};   ///< map units, 1 to 65,536
    glm::ivec2 origin{0}; ///< the entity's place in it, from the lower left; at most 65,536 away
    std::string picture;  ///< file name such as sprites/s_explod_0.pcx
};

/// At least one frame. Throws Error naming the file and the fault.
std::vector<Sp2Frame> parse_sp2(std::string_view name, std::span<const uint8_t> bytes);

} // namespace vigil
