// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/scene/material_set.h"

#include "common/ascii_case.h"
#include "common/error.h"
#include "common/file_system.h"
#include "common/log.h"
#include "formats/bsp_query.h"
#include "formats/texture_name.h"

#include <algorithm>
#include <string_view>

namespace vigil::vkpt {

namespace {

constexpr std::string_view material_file = "materials.json";

glm::vec3 inverse(glm::vec3 mean) {
    for (glm::length_t i = 0; i < 3; ++i)
        mean[i] = mean[i] > 1e-6f ? 1.0f / mean[i] : 0.0f;
    return mean;
}

shader::Material plain_material(const TextureSet::Entry& texture) {
    shader::Material material{};
    material.texture = texture.header;
    material.frame_count = 1;
    material.roughness = 1.0f;
    material.inverse_mean = inverse(texture.mean);
    return material;
}

} // namespace

MaterialSet::MaterialSet(const FileSystem& files, TextureSet& textures)
    : files_(files), textures_(textures) {
    if (!files.exists(material_file)) return;
    try {
        gloss_ = parse_material_table(material_file, files.read_text(material_file));
    } catch (const Error& error) {
        log_warning("{}. All surfaces are diffuse.", error.what());
    }
}

const MaterialSet::WorldMaterial& MaterialSet::world_material(const Bsp& bsp, uint32_t texinfo) {
    if (const auto known = by_texinfo_.find(texinfo); known != by_texinfo_.end())
        return known->second;
    const BspTexInfo& info = bsp.texinfos[texinfo];

    // Collect the textures of the animation: Quake II's chain of texinfos, or Quake's +0, +1 names.
    std::vector<std::string> names;
    for (const uint32_t frame : animation_chain(bsp, texinfo))
        names.push_back(bsp.texinfos[frame].texture);
    if (names.size() == 1) {
        names = animation_names(info.texture, [&](const std::string& name) {
            const std::vector<std::string> paths = texture_candidates(name);
            return std::any_of(paths.begin(), paths.end(),
                               [&](const std::string& path) { return files_.exists(path); });
        });
    }
    const TextureSet::Entry first = textures_.texture(info.texture);
    std::vector<const TextureSet::Entry*> frames;
    for (const std::string& name : names)
        frames.push_back(&textures_.texture(name));

    shader::Material material = plain_material(first);
    material.texture = textures_.consecutive(frames);
    material.frame_count = static_cast<uint32_t>(frames.size());
    if (info.flags & SURF_SKY) material.flags |= shader::MATERIAL_SKY;
    if (info.flags & SURF_WARP) material.flags |= shader::MATERIAL_WARP;
    if (info.flags & SURF_FLOWING) material.flags |= shader::MATERIAL_FLOWING;
    WorldMaterial result;
    result.uv_size = first.uv_size;
    const auto gloss = gloss_.find(ascii_lower(info.texture));
    float light = is_emissive(info) ? static_cast<float>(info.value) : 0.0f;
    if (gloss != gloss_.end() && (info.flags & (SURF_SKY | SURF_NODRAW)) == 0)
        light = gloss->second.light.value_or(light);
    if (light > 0.0f) {
        material.flags |= shader::MATERIAL_EMISSIVE;
        result.radiance = first.mean * (light * radiance_per_light_value);
    }
    if (info.flags & SURF_TRANS33) result.coverage = coverage_trans33;
    if (info.flags & SURF_TRANS66) result.coverage = coverage_trans66;
    if (gloss != gloss_.end() && gloss->second.specular > 0.0f) {
        material.flags |= shader::MATERIAL_GLOSSY;
        material.roughness = gloss->second.roughness;
        material.specular = gloss->second.specular;
    }
    result.index = add(material);
    return by_texinfo_.emplace(texinfo, result).first->second;
}

uint32_t MaterialSet::add(const shader::Material& material) {
    static_assert(sizeof(shader::Material) ==
                  8 * sizeof(uint32_t)); // no padding: bytes tell equality
    const std::string content(reinterpret_cast<const char*>(&material), sizeof(material));
    const auto next = static_cast<uint32_t>(materials_.size());
    const auto [row, added] = by_content_.emplace(content, next);
    if (added) materials_.push_back(material);
    return row->second;
}

uint32_t MaterialSet::mesh_material(const MeshMaterial& source) {
    // Dielectrics keep their base colour and glTF's 4 % reflectance where they are smooth; metals
    // reflect by their base colour's mean. Rough dielectrics (roughness 1) are plainly diffuse.
    const glm::vec3 base(source.base_color);
    const glm::vec3 diffuse = base * (1.0f - source.metallic);
    shader::Material material = plain_material(textures_.flat(diffuse));
    const float metal = (base.x + base.y + base.z) / 3.0f;
    if (source.roughness < 1.0f) {
        material.flags |= shader::MATERIAL_GLOSSY;
        material.roughness = std::clamp(source.roughness, 0.1f, 1.0f);
        material.specular = 0.04f + (metal - 0.04f) * source.metallic;
    }
    if (source.emissive != glm::vec3(0.0f)) {
        material.flags |= shader::MATERIAL_EMISSIVE;
        material.inverse_mean = glm::vec3(0.0f); // its emission has no texture
    }
    return add(material);
}

uint32_t MaterialSet::picture_material(const std::string& path) {
    return add(plain_material(textures_.picture(path)));
}

uint32_t MaterialSet::cutout_material(const std::string& path) {
    return add(plain_material(textures_.cutout(path)));
}

uint32_t MaterialSet::lamp_material() {
    MeshMaterial lamp;
    lamp.base_color = glm::vec4(glm::vec3(0.5f), 1.0f);
    lamp.metallic = 0.0f;
    lamp.emissive = glm::vec3(1.0f);
    return mesh_material(lamp);
}

uint32_t MaterialSet::black_material() {
    MeshMaterial black;
    black.base_color = glm::vec4(0.0f, 0.0f, 0.0f, 1.0f);
    black.metallic = 0.0f;
    return mesh_material(black);
}

uint32_t MaterialSet::particle_material(const glm::vec3& color) {
    shader::Material material = plain_material(textures_.flat(color));
    material.flags |= shader::MATERIAL_SHINES;
    return add(material);
}

} // namespace vigil::vkpt
