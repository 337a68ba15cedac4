// SPDX-License-Identifier: GPL-2.0-or-later
// A scene as glTF 2.0 for other path tracers: geometry, materials, emitted radiance with units,
// sun, sky and camera (docs/internals/export.md). Everything here is plain data in Vigil's
// conventions (z up, linear colours), so that it is filled and tested without a GPU. It exports one
// moment: no animation, no light styles beyond their value now.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

namespace vigil::vkpt {

/// A picture in linear RGB, rows from the top. Written as 8-bit sRGB; values are clamped to 0..1.
struct ExportTexture {
    std::string name; // becomes the file's name; any characters
    uint32_t width = 0;
    uint32_t height = 0;
    std::vector<glm::vec3> texels;
};

/// One look. Faces that emit different radiance need a material each.
struct ExportMaterial {
    std::string name;
    glm::vec3 color{1.0f};                          // linear, 0..1; multiplies the texture
    std::optional<uint32_t> texture = std::nullopt; // into ExportScene::textures; repeats
    float specular = 0.0f;    // GGX reflectance at normal incidence, 0..1; 0: Lambertian
    float roughness = 1.0f;   // 0..1; GGX alpha = roughness^2
    glm::vec3 radiance{0.0f}; // emitted from the front, uniform, >= 0
    float coverage = 1.0f;    // share of rays that stop here; below 1: translucent
};

/// Triangles of one material, counter-clockwise seen from the front.
struct ExportPrimitive {
    uint32_t material = 0;
    std::vector<glm::vec3> positions; // object space
    std::vector<glm::vec2> uvs;       // as many, or none; in repeats, v down
    std::vector<uint32_t> indices;    // three per triangle; none: positions in their order
};

struct ExportMesh {
    std::string name;
    std::vector<ExportPrimitive> primitives;
};

/// A placed mesh; a mesh may be placed several times.
struct ExportInstance {
    std::string name;
    uint32_t mesh = 0;
    glm::mat4x3 world_from_object{1.0f};
};

struct ExportSun {
    glm::vec3 direction{0.0f, 0.0f, 1.0f}; // unit, towards the sun
    glm::vec3 irradiance{0.0f};            // on a surface that faces it
    float angular_diameter = 0.0f;         // degrees
};

struct ExportSky {
    glm::vec3 radiance{0.0f}; // factor on the sides, or the radiance itself
    std::optional<std::array<ExportTexture, 6>> sides; // in the order of formats/sky.h
    // Triangles, three corners each, world space: where rays meet the sky, whatever lies behind.
    std::vector<glm::vec3> faces = {};
};

struct ExportCamera {
    glm::vec3 origin{0.0f};
    glm::vec3 forward{1.0f, 0.0f, 0.0f}; // these three: unit, at right angles
    glm::vec3 right{0.0f, -1.0f, 0.0f};
    glm::vec3 up{0.0f, 0.0f, 1.0f};
    float vertical_fov = 1.0f; // radians
    float aspect = 1.0f;       // width / height
};

/// Faces that show the sky are in no mesh: rays that leave the level see the sky.
struct ExportScene {
    std::string name; // the level's
    std::vector<ExportTexture> textures;
    std::vector<ExportMaterial> materials;
    std::vector<ExportMesh> meshes;
    std::vector<ExportInstance> instances;
    std::optional<ExportSun> sun;
    std::optional<ExportSky> sky;
    ExportCamera camera;
};

struct ExportSummary {
    uint64_t triangles = 0; // of all instances
    uint64_t files = 0;
    uint64_t bytes = 0;
};

/// Writes NAME.gltf (`path`), NAME.bin and NAME_textures/*.png beside it, and for a sky with
/// pictures NAME_textures/sky.exr, a panorama of its radiance. All files are complete before the
/// first takes its place. Throws Error when `path` does not end in .gltf, an index or size in
/// `scene` is wrong, a number is not finite, or the disk fails; files of an earlier export then
/// stay as they were.
ExportSummary write_gltf(const ExportScene& scene, const std::filesystem::path& path);

} // namespace vigil::vkpt
