// SPDX-License-Identifier: GPL-2.0-or-later
// Quake II's sky box: six square pictures env/<sky>rt, bk, lf, ft, up, dn. This file states which
// part of the world each one covers and how it is turned; it samples nothing (the shaders do).
#pragma once

#include <fmt/format.h>
#include <glm/vec3.hpp>

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace vigil {

/// One side. With the picture's centre at (u, v) = (0.5, 0.5), u to the right and v down, the texel
/// (u, v) lies in direction forward + (2u - 1) * right - (2v - 1) * up (not normalised).
struct SkySide {
    std::string_view suffix;
    glm::vec3 forward; ///< world direction of the picture's centre
    glm::vec3 right;   ///< world direction of growing u
    glm::vec3 up;      ///< world direction of falling v
};

/// In Quake II's order rt, bk, lf, ft, up, dn. Yaw 0 (looking along +x) sees "rt"; the view turns
/// left
/// (+y) towards "bk". Looking up along yaw 0, the top edge of "up" is behind (-x); looking
/// down, the top edge of "dn" is ahead (+x). Neighbouring sides share their edge texels'
/// directions.
inline constexpr std::array<SkySide, 6> sky_sides = {{
    {"rt", {1, 0, 0}, {0, -1, 0}, {0, 0, 1}},
    {"bk", {0, 1, 0}, {1, 0, 0}, {0, 0, 1}},
    {"lf", {-1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
    {"ft", {0, -1, 0}, {-1, 0, 0}, {0, 0, 1}},
    {"up", {0, 0, 1}, {0, -1, 0}, {-1, 0, 0}},
    {"dn", {0, 0, -1}, {0, -1, 0}, {1, 0, 0}},
}};

/// Files to try for one side (0..5) of the sky named in worldspawn's "sky", best first:
/// env/<sky><suffix>.png, .jpg, .tga, .pcx.
inline std::vector<std::string> sky_candidates(std::string_view sky, size_t side) {
    std::vector<std::string> names;
    for (const char* extension : {"png", "jpg", "tga", "pcx"})
        names.push_back(fmt::format("env/{}{}.{}", sky, sky_sides.at(side).suffix, extension));
    return names;
}

} // namespace vigil
