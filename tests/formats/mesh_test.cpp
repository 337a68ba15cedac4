// SPDX-License-Identifier: GPL-2.0-or-later
// Binary glTF: axes, transforms, quantisation and materials arrive as documented; files that point
// outside themselves, loop or ask for the unsupported are refused.
#include "fault.h"
#include "formats/mesh.h"
#include "small_models.h"

#include <glm/geometric.hpp>

namespace vigil {
namespace {

Mesh parse(const Bytes& bytes) {
    return parse_glb("x.glb", bytes);
}

/// triangle_glb() with the first `from` in its JSON replaced by `to`.
Bytes edited(std::string_view from, std::string_view to) {
    const Bytes file = triangle_glb();
    uint32_t json_size = 0;
    std::memcpy(&json_size, file.data() + 12, 4);
    std::string json(file.begin() + 20, file.begin() + 20 + json_size);
    const size_t at = json.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    json.replace(at, from.size(), to);
    return write_glb(json, Bytes(file.begin() + 28 + json_size, file.end()));
}

glm::vec3 geometric_normal(const MeshPrimitive& p) {
    const glm::vec3 a = p.positions[p.indices[0]];
    return glm::normalize(glm::cross(p.positions[p.indices[1]] - a, p.positions[p.indices[2]] - a));
}

TEST(Mesh, DeepJsonIsRefused) {
    const auto nested = [](size_t depth) {
        return write_glb(R"({"extras":)" + std::string(depth, '[') + std::string(depth, ']') + "}",
                         {});
    };
    expect_fault("x.glb", "holds no triangles", [&] { parse_glb("x.glb", nested(60)); });
    expect_fault("x.glb", "nested more than 64 deep", [&] { parse_glb("x.glb", nested(100'000)); });
}

TEST(Mesh, YUpBecomesZUp) {
    const Mesh mesh = parse(triangle_glb());
    ASSERT_EQ(mesh.primitives.size(), 1u);
    const MeshPrimitive& p = mesh.primitives[0];
    EXPECT_EQ(p.positions[1], glm::vec3(1, 0, 0));
    EXPECT_EQ(p.positions[2], glm::vec3(0, 0, 1)) << "up is z";
    EXPECT_EQ(p.normals[0], glm::vec3(0, -1, 0));
    EXPECT_EQ(geometric_normal(p), p.normals[0]) << "the winding survives";
    EXPECT_EQ(p.uvs[2], glm::vec2(0, 1));
    EXPECT_EQ(p.indices, (std::vector<uint32_t>{0, 1, 2}));
}

TEST(Mesh, NodesMoveTurnAndScale) {
    // Scale, then a quarter turn about y (x to -z), then translation.
    const Mesh mesh = parse(triangle_glb(R"("translation":[10,20,30],"scale":[2,3,4],)"
                                         R"("rotation":[0,0.70710678,0,0.70710678],)"));
    const MeshPrimitive& p = mesh.primitives[0];
    const auto near = [](const glm::vec3& a, const glm::vec3& b) {
        EXPECT_LT(glm::length(a - b), 1e-4f);
    };
    near(p.positions[0], {10, -30, 20});
    near(p.positions[1], {10, -28, 20});
    near(p.positions[2], {10, -30, 23});
    near(p.normals[0], {1, 0, 0});
    near(geometric_normal(p), p.normals[0]);
}

TEST(Mesh, NormalsStayPerpendicularUnderShear) {
    const Mesh mesh = parse(triangle_glb(R"("matrix":[1,0,2,0, 0,1,0,0, 0,0,5,0, 0,0,0,1],)"));
    const MeshPrimitive& p = mesh.primitives[0];
    EXPECT_LT(glm::length(geometric_normal(p) - p.normals[0]), 1e-5f);
}

TEST(Mesh, MirroredNodesKeepTheirOutside) {
    // A mirror that leaves the normal's direction alone must leave the front side alone, too.
    const Mesh mesh = parse(triangle_glb(R"("scale":[-1,1,1],)"));
    const MeshPrimitive& p = mesh.primitives[0];
    EXPECT_EQ(p.normals[0], glm::vec3(0, -1, 0));
    EXPECT_LT(glm::length(geometric_normal(p) - p.normals[0]), 1e-6f);
}

TEST(Mesh, MaterialsArrive) {
    const Mesh mesh = parse(triangle_glb(
        "", R"({"name":"lamp","doubleSided":true,"emissiveFactor":[1,0.5,0],)"
            R"("pbrMetallicRoughness":{"baseColorFactor":[0.1,0.2,0.3,1],"roughnessFactor":0.4,)"
            R"("metallicFactor":0},"extensions":)"
            R"({"KHR_materials_emissive_strength":{"emissiveStrength":20}}})"));
    const MeshMaterial& m = mesh.materials.at(mesh.primitives[0].material);
    EXPECT_EQ(m.name, "lamp");
    EXPECT_TRUE(m.double_sided);
    EXPECT_EQ(m.base_color, glm::vec4(0.1f, 0.2f, 0.3f, 1.0f));
    EXPECT_EQ(m.roughness, 0.4f);
    EXPECT_EQ(m.metallic, 0.0f);
    EXPECT_EQ(m.emissive, glm::vec3(20, 10, 0));
}

TEST(Mesh, PrimitivesWithoutMaterialGetTheDefault) {
    const Mesh mesh = parse(edited(R"(,"material":0)", ""));
    ASSERT_EQ(mesh.materials.size(), 2u);
    EXPECT_EQ(mesh.primitives[0].material, 1u);
    EXPECT_EQ(mesh.materials[1].base_color, glm::vec4(1));
}

TEST(Mesh, ScenesAndIndicesAreOptional) {
    EXPECT_EQ(parse(edited(R"("scene":0,"scenes":[{"nodes":[0]}],)", "")).primitives.size(), 1u);
    const Mesh mesh = parse(edited(R"("indices":3,)", ""));
    EXPECT_EQ(mesh.primitives[0].indices, (std::vector<uint32_t>{0, 1, 2}));
}

TEST(Mesh, QuantizedPositionsAreUnderstood) {
    Bytes binary;
    append_list<int16_t>(binary, {0, 0, 0, 0, 32767, 0, 0, 0, 0, 16384, -32768, 0});
    append_list<int8_t>(binary, {0, 0, 127, 0, 0, 0, 127, 0, 0, 0, 127, 0});
    const std::string json =
        R"({"extensionsRequired":["KHR_mesh_quantization"],)"
        R"("nodes":[{"mesh":0,"scale":[64,64,64]}],)"
        R"("meshes":[{"primitives":[{"attributes":{"POSITION":0,"NORMAL":1}}]}],)"
        R"("buffers":[{"byteLength":36}],"bufferViews":[)"
        R"({"buffer":0,"byteLength":24,"byteStride":8},)"
        R"({"buffer":0,"byteOffset":24,"byteLength":12,"byteStride":4}],"accessors":[)"
        R"({"bufferView":0,"componentType":5122,"normalized":true,"count":3,"type":"VEC3"},)"
        R"({"bufferView":1,"componentType":5120,"normalized":true,"count":3,"type":"VEC3"}]})";
    const Mesh mesh = parse(write_glb(json, binary));
    const MeshPrimitive& p = mesh.primitives[0];
    EXPECT_EQ(p.positions[1], glm::vec3(64, 0, 0));
    EXPECT_EQ(p.positions[2].y, 64.0f) << "the lowest value means -1";
    EXPECT_NEAR(p.positions[2].z, 32.0f, 0.01f);
    EXPECT_EQ(p.normals[1], glm::vec3(0, -1, 0));
}

TEST(Mesh, DamageIsNamed) {
    const auto refuse = [](std::string_view part, std::string_view from, std::string_view to) {
        expect_fault("x.glb", part, [&] { parse(edited(from, to)); });
    };
    refuse("not valid JSON", "{\"asset\"", "{\"asset");
    refuse("meshes: entry 1 of 1 is used", R"("mesh":0)", R"("mesh":1)");
    refuse("names a node that does not exist", R"("nodes":[0])", R"("nodes":[1])");
    refuse("\"mesh\" is not a whole number", R"("mesh":0)", R"("mesh":-1)");
    refuse("accessors: entry 9 of 4", R"("POSITION":0)", R"("POSITION":9)");
    refuse("\"POSITION\" is missing", R"("POSITION":0)", R"("COLOR_0":0)");
    refuse("3 elements at byte 0 do not fit into 35", R"("byteLength":36)", R"("byteLength":35)");
    refuse("4 elements at byte 0 do not fit", R"("count":3)", R"("count":4)");
    refuse("more than 33554432 vertices", R"("count":3)", R"("count":18446744073709551615)");
    refuse("accessor 0 is empty", R"("count":3)", R"("count":0)");
    refuse("does not fit into 104 bytes", R"("byteOffset":72)", R"("byteOffset":99999)");
    refuse("not of type VEC3", R"("VEC3")", R"("VEC2")");
    refuse("component type 5130", "5126", "5130");
    refuse("indices of component type 5122", "5123", "5122");
    refuse("material 1 of 1 is used", R"("material":0)", R"("material":1)");
    refuse("primitive mode 5", R"("indices":3)", R"("indices":3,"mode":5)");
    refuse("outside the binary chunk", R"("buffers":[{)", R"("buffers":[{"uri":"a.bin",)");
    refuse("sparse", R"("count":3)", R"("count":3,"sparse":{})");
    refuse("KHR_draco_mesh_compression, which is not supported", R"("scene":0)",
           R"("scene":0,"extensionsRequired":["KHR_draco_mesh_compression"])");
    refuse("node 0 is reached twice", R"("mesh":0})", R"("mesh":0,"children":[0]})");
    refuse("a vertex lies at", R"("mesh":0})", R"("mesh":0,"translation":[9e8,0,0]})");
    refuse("\"translation\" is not an array of 3", R"("mesh":0})",
           R"("mesh":0,"translation":[1]})");
    refuse("no triangles", R"("mesh":0})", "\"name\":\"empty\"}");
}

TEST(Mesh, LoopsWithoutSceneHoldNothing) {
    const Bytes file = write_glb(R"({"nodes":[{"children":[1]},{"children":[0]}]})", {});
    expect_fault("x.glb", "no triangles", [&] { parse(file); });
}

TEST(Mesh, IndicesAndFloatsInTheBinaryAreChecked) {
    Bytes file = triangle_glb();
    const size_t binary = file.size() - 104;
    patch<uint16_t>(file, binary + 98, 3);
    expect_fault("x.glb", "index 3 of 3 vertices", [&] { parse(file); });
    patch(file, binary, std::numeric_limits<float>::quiet_NaN());
    expect_fault("x.glb", "accessor 0: element 0 is nan", [&] { parse(file); });
}

TEST(Mesh, InstancesCountAgainstTheLimit) {
    // 100,000 nodes times 1,000 vertices from a few hundred kilobytes of text.
    std::string nodes, roots;
    for (int i = 0; i < 100000; ++i) {
        nodes += i ? ",{\"mesh\":0}" : "{\"mesh\":0}";
        roots += (i ? "," : "") + std::to_string(i);
    }
    const std::string json =
        "{\"scenes\":[{\"nodes\":[" + roots + "]}],\"nodes\":[" + nodes +
        R"(],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],)"
        R"("buffers":[{"byteLength":108000}],"bufferViews":[{"buffer":0,"byteLength":108000}],)"
        R"("accessors":[{"bufferView":0,"componentType":5126,"count":9000,"type":"VEC3"}]})";
    expect_fault("x.glb", "more than 33554432 vertices",
                 [&] { parse(write_glb(json, Bytes(108000, 0))); });
}

TEST(Mesh, CutFilesAreRefused) {
    const Bytes file = triangle_glb();
    for (size_t size = 0; size < file.size(); ++size)
        expect_fault("x.glb", "", [&] { parse(Bytes(file.begin(), file.begin() + size)); });
}

} // namespace
} // namespace vigil
