// SPDX-License-Identifier: GPL-2.0-or-later
// MD2 (IDP2, version 8), Quake II's animated model: skins, triangles and one set of vertices per
// frame. Normals are computed from the triangles instead of the file's quantised normal table, and
// the OpenGL command list is ignored: it repeats the triangles.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace vigil {

/// Vertices of one pose, model space in map units, z up, facing +x.
struct Md2Frame {
    std::string name;
    std::vector<glm::vec3> positions; ///< as many as Md2::uvs
    std::vector<glm::vec3> normals;   ///< unit length, area-weighted mean of adjacent triangles
};

struct Md2 {
    uint32_t skin_width = 0, skin_height = 0; ///< texels
    std::vector<std::string> skins;           ///< file names such as models/x/skin.pcx
    std::vector<glm::vec2> uvs;               ///< per vertex, 0..1 from the skin's top left
    std::vector<uint32_t> indices; ///< three per triangle, counter-clockwise seen from outside
    std::vector<Md2Frame> frames;  ///< at least one
};

/// Throws Error naming the file and the fault.
Md2 parse_md2(std::string_view name, std::span<const uint8_t> bytes);

} // namespace vigil
