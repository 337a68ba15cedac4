// SPDX-License-Identifier: GPL-2.0-or-later
// Static meshes from binary glTF 2.0 (.glb): triangles and material factors, node transforms
// applied, KHR_mesh_quantization and KHR_materials_emissive_strength understood. Textures, skins,
// animations, sparse accessors and external buffers are not read.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace vigil {

/// glTF's metallic-roughness factors, with glTF's defaults.
struct MeshMaterial {
    std::string name;
    glm::vec4 base_color{1.0f}; ///< linear, 0..1
    float roughness = 1.0f;     ///< 0..1
    float metallic = 1.0f;      ///< 0..1
    glm::vec3 emissive{0.0f};   ///< linear radiance, factor times emissive strength, >= 0
    bool double_sided = false;
};

/// Triangles that share a material. `normals` and `uvs` are empty or as long as `positions`.
struct MeshPrimitive {
    std::vector<glm::vec3> positions; ///< Vigil's space, see parse_glb
    std::vector<glm::vec3> normals;   ///< unit length
    std::vector<glm::vec2> uvs;       ///< 0..1 from the top left
    std::vector<uint32_t> indices;    ///< three per triangle, counter-clockwise seen from outside
    uint32_t material = 0;            ///< into Mesh::materials
};

struct Mesh {
    std::vector<MeshPrimitive> primitives;
    std::vector<MeshMaterial> materials; ///< at least one
};

/// Meshes with more vertices or indices than this in total are refused (a small file can instance
/// one mesh many times).
inline constexpr uint64_t mesh_max_elements = uint64_t{1} << 25;

/// Parses a .glb. glTF is y-up, Vigil is z-up: a glTF point (x, y, z) becomes (x, -z, y), and one
/// glTF unit is one map unit. The default scene is read, or all root nodes where there is none.
/// Throws Error naming the file and the fault.
Mesh parse_glb(std::string_view name, std::span<const uint8_t> bytes);

} // namespace vigil
