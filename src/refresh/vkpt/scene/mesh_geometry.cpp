// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/scene/mesh_geometry.h"

namespace vigil::vkpt {

namespace {

/// `frame` modulo the number of frames, also for negative numbers.
size_t wrap_frame(int frame, size_t count) {
    const int rest = frame % static_cast<int>(count);
    return static_cast<size_t>(rest < 0 ? rest + static_cast<int>(count) : rest);
}

} // namespace

ModelGeometry mesh_geometry(const Mesh& mesh, MaterialSet& materials) {
    std::vector<uint32_t> indices;
    for (const MeshMaterial& material : mesh.materials)
        indices.push_back(materials.mesh_material(material));
    ModelGeometry geometry;
    for (const MeshPrimitive& part : mesh.primitives) {
        const glm::vec3 radiance = mesh.materials[part.material].emissive;
        for (size_t i = 0; i + 2 < part.indices.size(); i += 3) {
            const uint32_t a = part.indices[i], b = part.indices[i + 1], c = part.indices[i + 2];
            const glm::vec3& v0 = part.positions[a];
            const glm::vec3& v1 = part.positions[b];
            const glm::vec3& v2 = part.positions[c];
            if (glm::cross(v1 - v0, v2 - v0) == glm::vec3(0.0f)) continue;
            shader::Primitive primitive{};
            if (!part.uvs.empty()) {
                primitive.uv0 = part.uvs[a];
                primitive.uv1 = part.uvs[b];
                primitive.uv2 = part.uvs[c];
            }
            primitive.material = indices[part.material];
            primitive.cluster = shader::NONE;
            primitive.light = shader::NONE;
            if (radiance != glm::vec3(0.0f)) {
                primitive.light = static_cast<uint32_t>(geometry.lights.size());
                geometry.lights.push_back({v0, v1, v2, radiance, 1.0f, 0});
            }
            geometry.triangles.push_back({v0, v1, v2, 255});
            geometry.primitives.push_back(primitive);
        }
    }
    return geometry;
}

ModelGeometry md2_geometry(const Md2& md2, int frame, int old_frame, float backlerp,
                           uint32_t material) {
    const std::vector<glm::vec3>& now = md2.frames[wrap_frame(frame, md2.frames.size())].positions;
    const std::vector<glm::vec3>& before =
        md2.frames[wrap_frame(old_frame, md2.frames.size())].positions;
    const auto position = [&](uint32_t index) {
        return glm::mix(now[index], before[index], backlerp);
    };
    ModelGeometry geometry;
    for (size_t i = 0; i + 2 < md2.indices.size(); i += 3) {
        const uint32_t a = md2.indices[i], b = md2.indices[i + 1], c = md2.indices[i + 2];
        shader::Primitive primitive{};
        primitive.uv0 = md2.uvs[a];
        primitive.uv1 = md2.uvs[b];
        primitive.uv2 = md2.uvs[c];
        primitive.material = material;
        primitive.light = shader::NONE;
        primitive.cluster = shader::NONE;
        // Degenerate triangles stay: every pose of a model has the same number.
        geometry.triangles.push_back({position(a), position(b), position(c), 255});
        geometry.primitives.push_back(primitive);
    }
    return geometry;
}

} // namespace vigil::vkpt
