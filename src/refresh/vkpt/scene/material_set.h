// SPDX-License-Identifier: GPL-2.0-or-later
// Materials: what a texinfo, a mesh material or a skin looks like to the path tracer. Gloss, and
// where it says so light, comes from materials.json of the game folder; all else from the level.
#pragma once

#include "formats/bsp.h"
#include "formats/material_table.h"
#include "formats/mesh.h"
#include "refresh/vkpt/scene/texture_set.h"

#include <map>
#include <tuple>

namespace vigil::vkpt {

/// Emitted radiance of a face is VALUE * this * its mean texel (docs/internals/units.md); the sun's
/// irradiance is _sun_light times this.
inline constexpr float radiance_per_light_value = 0.1f;

/// Coverage of SURF_TRANS33 and SURF_TRANS66 faces: the share of light that they stop.
inline constexpr uint32_t coverage_trans33 = 84;  // 0.33 * 255
inline constexpr uint32_t coverage_trans66 = 168; // 0.66 * 255

class MaterialSet {
public:
    MaterialSet(const FileSystem& files, TextureSet& textures);

    /// The material of a texinfo (animation chain included) and where its texture coordinates count
    /// from.
    struct WorldMaterial {
        uint32_t index = 0;
        glm::uvec2 uv_size{1, 1};
        glm::vec3 radiance{0.0f}; // emitted, 0 if it does not
        uint32_t coverage = 255;
    };
    const WorldMaterial& world_material(const Bsp& bsp, uint32_t texinfo);

    /// A mesh's material (flat colours); radiance is the mesh's own.
    uint32_t mesh_material(const MeshMaterial& material);
    /// A diffuse material with a picture, such as a skin.
    uint32_t picture_material(const std::string& path);
    /// The same of a picture whose alpha says how much of each texel there is (INSTANCE_CUTOUT).
    uint32_t cutout_material(const std::string& path);
    /// A black material that emits: the body of a dynamic light.
    uint32_t lamp_material();
    /// A black material: what hides a light.
    uint32_t black_material();
    /// Of a particle: it shines in this colour (linear, 0..1), and is no light.
    uint32_t particle_material(const glm::vec3& color);

    const std::vector<shader::Material>& materials() const { return materials_; }
    TextureSet& textures() { return textures_; }

private:
    /// Index of an equal material, or of this one, added.
    uint32_t add(const shader::Material& material);

    const FileSystem& files_;
    TextureSet& textures_;
    MaterialTable gloss_;
    std::vector<shader::Material> materials_;
    std::map<std::string, uint32_t> by_content_; // the bytes of a material
    std::map<uint32_t, WorldMaterial> by_texinfo_;
};

} // namespace vigil::vkpt
