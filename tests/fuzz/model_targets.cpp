// SPDX-License-Identifier: GPL-2.0-or-later
// Models: whatever is accepted holds valid indices and finite numbers, as the renderer expects.
#include "formats/md2.h"
#include "formats/mesh.h"
#include "formats/sp2.h"
#include "target.h"

#include <cmath>

namespace vigil::fuzz {

namespace {

bool finite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

} // namespace

void fuzz_md2(Input bytes) {
    parse_or_refuse("x.md2", [&] {
        const Md2 model = parse_md2("x.md2", bytes);
        for (const uint32_t index : model.indices)
            require(index < model.uvs.size(), "an index is out of range");
        for (const Md2Frame& frame : model.frames) {
            require(frame.positions.size() == model.uvs.size() &&
                        frame.normals.size() == model.uvs.size(),
                    "a frame has not all vertices");
            for (std::size_t i = 0; i < frame.positions.size(); ++i)
                require(finite(frame.positions[i]) && finite(frame.normals[i]),
                        "a vertex is not finite");
        }
    });
}

void fuzz_sp2(Input bytes) {
    parse_or_refuse("x.sp2", [&] {
        const std::vector<Sp2Frame> frames = parse_sp2("x.sp2", bytes);
        require(!frames.empty(), "a sprite without a picture");
        for (const Sp2Frame& frame : frames)
            require(frame.size.x > 0 && frame.size.y > 0 && frame.picture.size() <= 64,
                    "a frame is out of range");
    });
}

void fuzz_mesh(Input bytes) {
    parse_or_refuse("x.glb", [&] {
        const Mesh mesh = parse_glb("x.glb", bytes);
        for (const MeshMaterial& material : mesh.materials)
            require(finite(material.emissive) && finite(glm::vec3(material.base_color)),
                    "a material is not finite");
        for (const MeshPrimitive& primitive : mesh.primitives) {
            const std::size_t vertices = primitive.positions.size();
            require(primitive.material < mesh.materials.size(), "a material is out of range");
            require(primitive.normals.empty() || primitive.normals.size() == vertices,
                    "normals are missing");
            require(primitive.uvs.empty() || primitive.uvs.size() == vertices,
                    "texture coordinates are missing");
            for (const glm::vec3& position : primitive.positions)
                require(finite(position), "a vertex is not finite");
            for (const glm::vec3& normal : primitive.normals)
                require(finite(normal), "a normal is not finite");
            require(primitive.indices.size() % 3 == 0, "a triangle is not whole");
            for (const uint32_t index : primitive.indices)
                require(index < vertices, "an index is out of range");
        }
    });
}

} // namespace vigil::fuzz
