// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/export/export_source.h"

#include "formats/sky.h"
#include "level/level.h"
#include "refresh/vkpt/scene/scene.h"

#include <fmt/format.h>
#include <map>
#include <tuple>

namespace vigil::vkpt {

namespace {

/// Corners of all triangles that show the sky, where they are now.
std::vector<glm::vec3> sky_faces(const Scene& scene) {
    std::vector<glm::vec3> corners;
    for (size_t i = 0; i < scene.host_instances().size(); ++i) {
        const glm::mat4x3& place = scene.host_instances()[i].world_from_object;
        const Scene::TriangleRange range = scene.instance_triangles(i);
        for (uint32_t t = range.first; t < range.first + range.count; ++t) {
            const uint32_t material = scene.host_primitives()[t].material;
            if (!(scene.host_materials().materials()[material].flags & shader::MATERIAL_SKY))
                continue;
            const shader::BvhTriangle& triangle = scene.host_triangles()[t];
            for (const glm::vec3& corner :
                 {triangle.v0, triangle.v0 + triangle.e1, triangle.v0 + triangle.e2})
                corners.push_back(place * glm::vec4(corner, 1.0f));
        }
    }
    return corners;
}

/// Level 0 of a texture, decoded.
ExportTexture texture_of(const TextureSet& textures, uint32_t header_index, std::string name) {
    const shader::Texture& header = textures.headers()[header_index];
    ExportTexture texture;
    texture.name = std::move(name);
    texture.width = header.width;
    texture.height = header.height;
    texture.texels.reserve(size_t{header.width} * header.height);
    for (size_t i = 0; i < size_t{header.width} * header.height; ++i)
        texture.texels.push_back(decode_rgb9e5(textures.texels()[header.first_texel + i]));
    return texture;
}

class SceneReader {
public:
    explicit SceneReader(const Scene& scene) : scene_(scene) {}

    ExportScene run() {
        out_.name = scene_.level().name;
        std::map<std::tuple<uint32_t, uint32_t, uint32_t>, uint32_t>
            meshes; // by first triangle, first light and opacity
        for (size_t i = 0; i < scene_.host_instances().size(); ++i) {
            const shader::Instance& instance = scene_.host_instances()[i];
            if ((instance.flags & shader::INSTANCE_LIT) == 0) continue; // a picture, not a thing
            const uint32_t opacity = shader::bvh_opacity(instance.flags);
            const Scene::TriangleRange range = scene_.instance_triangles(i);
            const auto [row, added] =
                meshes.emplace(std::tuple(range.first, instance.first_light, opacity),
                               static_cast<uint32_t>(out_.meshes.size()));
            const std::string name = i == 0 ? "world" : fmt::format("entity {}", instance.entity);
            if (added) out_.meshes.push_back(mesh_of(name, range, instance.first_light, opacity));
            out_.instances.push_back({name, row->second, instance.world_from_object});
        }
        return std::move(out_);
    }

private:
    ExportMesh mesh_of(const std::string& name, Scene::TriangleRange range, uint32_t first_light,
                       uint32_t opacity) {
        ExportMesh mesh;
        mesh.name = name;
        std::map<uint32_t, size_t> parts; // export material -> primitive of the mesh
        for (uint32_t t = range.first; t < range.first + range.count; ++t) {
            const shader::BvhTriangle& triangle = scene_.host_triangles()[t];
            const shader::Primitive& primitive = scene_.host_primitives()[t];
            const shader::Material& material =
                scene_.host_materials().materials()[primitive.material];
            if (material.flags & shader::MATERIAL_SKY) continue; // see sky_faces
            const uint32_t coverage =
                shader::bvh_faded(triangle.flags & shader::TRIANGLE_COVERAGE_MASK, opacity);
            glm::vec3 radiance(0.0f);
            if (primitive.light != shader::NONE)
                radiance = scene_.lights().lights()[first_light + primitive.light].radiance *
                           (255.0f / static_cast<float>(std::max(coverage, 1u)));
            const uint32_t look = material_of(primitive.material, radiance, coverage);
            const auto [part, added] = parts.emplace(look, mesh.primitives.size());
            if (added) mesh.primitives.push_back({look, {}, {}, {}});
            ExportPrimitive& target = mesh.primitives[part->second];
            for (const glm::vec3& corner :
                 {triangle.v0, triangle.v0 + triangle.e1, triangle.v0 + triangle.e2})
                target.positions.push_back(corner);
            for (const glm::vec2& uv : {primitive.uv0, primitive.uv1, primitive.uv2})
                target.uvs.push_back(uv);
        }
        return mesh;
    }

    uint32_t material_of(uint32_t index, const glm::vec3& radiance, uint32_t coverage) {
        const std::tuple key(index, radiance.x, radiance.y, radiance.z, coverage);
        const auto next = static_cast<uint32_t>(out_.materials.size());
        const auto [row, added] = materials_.emplace(key, next);
        if (!added) return row->second;
        const shader::Material& source = scene_.host_materials().materials()[index];
        ExportMaterial material;
        material.name = fmt::format("material {}", next);
        material.texture = texture_index(source.texture);
        if (source.flags & shader::MATERIAL_GLOSSY) {
            material.specular = source.specular;
            material.roughness = source.roughness;
        }
        material.radiance = radiance;
        material.coverage = static_cast<float>(coverage) / 255.0f;
        out_.materials.push_back(std::move(material));
        return next;
    }

    uint32_t texture_index(uint32_t header) {
        const auto next = static_cast<uint32_t>(out_.textures.size());
        const auto [row, added] = textures_.emplace(header, next);
        if (added)
            out_.textures.push_back(
                texture_of(scene_.host_textures(), header, fmt::format("texture{}", header)));
        return row->second;
    }

    const Scene& scene_;
    ExportScene out_;
    std::map<std::tuple<uint32_t, float, float, float, uint32_t>, uint32_t> materials_;
    std::map<uint32_t, uint32_t> textures_; // header -> export texture
};

} // namespace

ExportScene export_scene_of(const Scene& scene, const shader::FrameParams& params,
                            const refresh::Settings& settings) {
    ExportScene out = SceneReader(scene).run();
    const SkyDescription& sky = scene.sky();
    const Sun sun = sky.sun(settings);
    if (scene.features().sky) {
        out.sky.emplace();
        out.sky->radiance = params.sky_radiance;
        out.sky->faces = sky_faces(scene);
        if (sky.texture) {
            out.sky->sides.emplace();
            for (uint32_t side = 0; side < sky_sides.size(); ++side)
                (*out.sky->sides)[side] = texture_of(scene.host_textures(), *sky.texture + side,
                                                     std::string(sky_sides[side].suffix));
        }
    }
    if (scene.has_sun())
        out.sun = ExportSun{sun.direction, sun.irradiance, 2.0f * glm::degrees(sun.half_angle)};
    const float tan_right = glm::length(params.camera_right);
    const float tan_up = glm::length(params.camera_up);
    out.camera.origin = params.camera_origin;
    out.camera.forward = params.camera_forward;
    out.camera.right = params.camera_right / tan_right;
    out.camera.up = params.camera_up / tan_up;
    out.camera.vertical_fov = 2.0f * std::atan(tan_up);
    out.camera.aspect = tan_right / tan_up;
    return out;
}

} // namespace vigil::vkpt
