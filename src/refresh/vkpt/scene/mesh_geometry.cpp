// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/scene/mesh_geometry.h"

namespace vigil::vkpt {

size_t wrap_frame(int number, size_t count) {
    const int rest = number % static_cast<int>(count);
    return static_cast<size_t>(rest < 0 ? rest + static_cast<int>(count) : rest);
}

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
            shader::Primitive& primitive = geometry.add({v0, v1, v2, 255}, indices[part.material]);
            if (!part.uvs.empty()) {
                primitive.uv0 = part.uvs[a];
                primitive.uv1 = part.uvs[b];
                primitive.uv2 = part.uvs[c];
            }
            if (radiance != glm::vec3(0.0f)) geometry.shine(radiance);
        }
    }
    return geometry;
}

ModelGeometry md2_geometry(const Md2& md2, const Md2Pose& pose) {
    const Md2Frame& now = md2.frames[wrap_frame(pose.frame, md2.frames.size())];
    const Md2Frame& before = md2.frames[wrap_frame(pose.old_frame, md2.frames.size())];
    const auto position = [&](uint32_t index) {
        glm::vec3 place = glm::mix(now.positions[index], before.positions[index], pose.backlerp);
        if (pose.swell != 0.0f)
            place +=
                pose.swell * glm::mix(now.normals[index], before.normals[index], pose.backlerp);
        return place;
    };
    ModelGeometry geometry;
    for (size_t i = 0; i + 2 < md2.indices.size(); i += 3) {
        const uint32_t a = md2.indices[i], b = md2.indices[i + 1], c = md2.indices[i + 2];
        // Degenerate triangles stay: every pose of a model has the same number.
        shader::Primitive& primitive =
            geometry.add({position(a), position(b), position(c), 255}, pose.material);
        primitive.uv0 = md2.uvs[a];
        primitive.uv1 = md2.uvs[b];
        primitive.uv2 = md2.uvs[c];
    }
    return geometry;
}

ModelGeometry sprite_geometry(const Sp2Frame& frame, uint32_t material) {
    const glm::vec2 low(-frame.origin), high = low + glm::vec2(frame.size); // to the right, up
    const auto corner = [](float right, float up) { return glm::vec3(0.0f, -right, up); };
    ModelGeometry geometry;
    for (const bool upper : {false, true}) {
        // From the lower left to the upper right by way of the other corners.
        const glm::vec2 uv0(0.0f, 1.0f);
        const glm::vec2 uv1 = upper ? glm::vec2(1.0f, 0.0f) : glm::vec2(1.0f, 1.0f);
        const glm::vec2 uv2 = upper ? glm::vec2(0.0f, 0.0f) : glm::vec2(1.0f, 0.0f);
        const auto place = [&](const glm::vec2& uv) {
            return corner(uv.x == 0.0f ? low.x : high.x, uv.y == 0.0f ? high.y : low.y);
        };
        shader::Primitive& primitive =
            geometry.add({place(uv0), place(uv1), place(uv2), 255}, material);
        primitive.uv0 = uv0;
        primitive.uv1 = uv1;
        primitive.uv2 = uv2;
    }
    return geometry;
}

} // namespace vigil::vkpt
