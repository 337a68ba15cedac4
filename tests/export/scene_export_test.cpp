// SPDX-License-Identifier: GPL-2.0-or-later
// Exported scenes are read back with a reader that shares no code with the writer (tinygltf), or as
// JSON where extensions matter: geometry, bounds, places, emission, camera, sun, sky, and what is
// left on the disk after a failure.
#include "refresh/vkpt/export/scene_export.h"

#include "common/error.h"
#include "export_folder.h"

#include <csignal>
#include <fstream>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <gtest/gtest.h>
#include <limits>
#include <nlohmann/json.hpp>
#include <sys/resource.h>
#include <tiny_gltf.h>

namespace vigil::vkpt {
namespace {

using Json = nlohmann::json;

/// A textured floor, a lamp placed twice, a translucent pane; sun, flat sky.
ExportScene small_scene() {
    ExportScene scene;
    scene.name = "test level";
    scene.textures.push_back({"e1u1/+0Floor*", 2, 1, {{1.0f, 0.0f, 0.0f}, {0.0f, 0.2140f, 0.0f}}});
    scene.textures.push_back({"never used", 1, 1, {glm::vec3(0.5f)}});
    ExportMaterial floor{.name = "floor", .texture = 0};
    ExportMaterial lamp{.name = "lamp", .color = glm::vec3(0.5f), .radiance = {30.0f, 15.0f, 7.5f}};
    ExportMaterial pane{.name = "pane",
                        .specular = 0.04f,
                        .roughness = 0.25f,
                        .radiance = {0.5f, 0.25f, 0.0f},
                        .coverage = 0.33f};
    scene.materials = {floor, lamp, pane};

    ExportPrimitive quad;
    quad.positions = {{-64, -32, 1}, {64, -32, 1}, {64, 32, 1}, {-64, 32, 1}};
    quad.uvs = {{0, 0}, {2, 0}, {2, 1}, {0, 1}};
    quad.indices = {0, 1, 2, 0, 2, 3};
    ExportPrimitive triangle;
    triangle.material = 2;
    triangle.positions = {{0, 0, 8}, {4, 0, 8}, {0, 4, 9}};
    ExportPrimitive bulb;
    bulb.material = 1;
    bulb.positions = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}};
    scene.meshes = {{"world", {quad, triangle}}, {"lamp", {bulb}}, {"nothing", {}}};
    const glm::mat4x3 place(glm::vec3(0, 1, 0), glm::vec3(-1, 0, 0), glm::vec3(0, 0, 1),
                            glm::vec3(10, 20, 30));
    scene.instances = {{"world", 0}, {"lamp 1", 1, place}, {"lamp 2", 1}, {"nothing", 2}};
    scene.sun = ExportSun{glm::normalize(glm::vec3(1, 2, 3)), {4.0f, 2.0f, 1.0f}, 0.5f};
    scene.sky = ExportSky{{0.1f, 0.2f, 0.3f}, {}};
    scene.camera.origin = {1, 2, 3};
    scene.camera.forward = {0, 1, 0};
    scene.camera.right = {1, 0, 0};
    scene.camera.vertical_fov = 1.25f;
    scene.camera.aspect = 16.0f / 9.0f;
    return scene;
}

Json read_json(const std::filesystem::path& path) {
    return Json::parse(std::ifstream(path));
}

tinygltf::Model read_model(const std::filesystem::path& path) {
    tinygltf::TinyGLTF reader;
    tinygltf::Model model;
    std::string errors, warnings;
    EXPECT_TRUE(reader.LoadASCIIFromFile(&model, &errors, &warnings, path.string())) << errors;
    EXPECT_EQ(errors, "");
    EXPECT_EQ(warnings, "");
    return model;
}

/// The values of an accessor, through bufferView and stride, bounds checked.
template <typename T> std::vector<T> values_of(const tinygltf::Model& model, int index) {
    const tinygltf::Accessor& accessor = model.accessors.at(static_cast<size_t>(index));
    const tinygltf::BufferView& view =
        model.bufferViews.at(static_cast<size_t>(accessor.bufferView));
    const std::vector<unsigned char>& bytes =
        model.buffers.at(static_cast<size_t>(view.buffer)).data;
    const auto stride = static_cast<size_t>(accessor.ByteStride(view));
    std::vector<T> values(accessor.count);
    EXPECT_LE(accessor.byteOffset + (accessor.count - 1) * stride + sizeof(T), view.byteLength);
    EXPECT_LE(view.byteOffset + view.byteLength, bytes.size());
    EXPECT_EQ((view.byteOffset + accessor.byteOffset) % 4, 0u);
    for (size_t i = 0; i < values.size(); ++i)
        std::memcpy(&values[i], &bytes.at(view.byteOffset + accessor.byteOffset + i * stride),
                    sizeof(T));
    return values;
}

/// Vigil's z up to glTF's y up, as the root node says it.
glm::vec3 to_gltf(const tinygltf::Model& model, glm::vec3 vigil) {
    const size_t root = static_cast<size_t>(model.scenes.at(0).nodes.at(0));
    const std::vector<double>& q = model.nodes.at(root).rotation;
    return glm::vec3(glm::dquat(q.at(3), q.at(0), q.at(1), q.at(2)) * glm::dvec3(vigil));
}

const tinygltf::Node& node_named(const tinygltf::Model& model, const std::string& name) {
    for (const tinygltf::Node& node : model.nodes)
        if (node.name == name) return node;
    throw std::runtime_error("no node " + name);
}

glm::mat4 matrix_of(const tinygltf::Node& node) {
    if (node.matrix.empty()) return glm::mat4(1.0f);
    return glm::mat4(glm::make_mat4(node.matrix.data()));
}

TEST(SceneExport, GeometryComesBackAsItWas) {
    const ExportFolder folder;
    const ExportScene scene = small_scene();
    const ExportSummary summary = write_gltf(scene, folder / "room.gltf");
    EXPECT_EQ(summary.triangles, 2u + 1u + 1u + 1u);
    EXPECT_EQ(summary.files, 3u); // document, buffer, the one texture in use
    const tinygltf::Model model = read_model(folder / "room.gltf");

    ASSERT_EQ(model.meshes.size(), 2u); // empty meshes do not exist in glTF
    const tinygltf::Mesh& world = model.meshes[0];
    ASSERT_EQ(world.primitives.size(), 2u);
    for (size_t i = 0; i < 2; ++i) {
        const ExportPrimitive& source = scene.meshes[0].primitives[i];
        const tinygltf::Primitive& primitive = world.primitives[i];
        const int positions = primitive.attributes.at("POSITION");
        EXPECT_EQ(values_of<glm::vec3>(model, positions), source.positions);
        EXPECT_EQ(primitive.material, static_cast<int>(source.material));
        // The bounds are exact, as the specification wants.
        glm::vec3 lower(1e30f), upper(-1e30f);
        for (const glm::vec3& position : source.positions) {
            lower = glm::min(lower, position);
            upper = glm::max(upper, position);
        }
        const tinygltf::Accessor& accessor = model.accessors[static_cast<size_t>(positions)];
        for (glm::length_t axis = 0; axis < 3; ++axis) {
            EXPECT_EQ(accessor.minValues.at(axis), double{lower[axis]});
            EXPECT_EQ(accessor.maxValues.at(axis), double{upper[axis]});
        }
    }
    EXPECT_EQ(values_of<glm::vec2>(model, world.primitives[0].attributes.at("TEXCOORD_0")),
              scene.meshes[0].primitives[0].uvs);
    EXPECT_EQ(values_of<uint32_t>(model, world.primitives[0].indices),
              scene.meshes[0].primitives[0].indices);
    EXPECT_EQ(values_of<uint32_t>(model, world.primitives[1].indices),
              (std::vector<uint32_t>{0, 1, 2}));
    EXPECT_EQ(world.primitives[1].attributes.count("TEXCOORD_0"), 0u);
}

TEST(SceneExport, UpIsUpAndPlacesStay) {
    const ExportFolder folder;
    const ExportScene scene = small_scene();
    write_gltf(scene, folder / "room.gltf");
    const tinygltf::Model model = read_model(folder / "room.gltf");
    EXPECT_LT(glm::distance(to_gltf(model, {0, 0, 1}), glm::vec3(0, 1, 0)), 1e-6f);
    EXPECT_LT(glm::distance(to_gltf(model, {1, 2, 3}), glm::vec3(1, 3, -2)), 1e-6f);
    const glm::vec4 corner = matrix_of(node_named(model, "lamp 1")) * glm::vec4(1, 0, 0, 1);
    EXPECT_EQ(corner, glm::vec4(10, 21, 30, 1));
    EXPECT_EQ(node_named(model, "lamp 1").mesh, node_named(model, "lamp 2").mesh);
}

TEST(SceneExport, RadianceIsFactorTimesStrength) {
    const ExportFolder folder;
    const ExportScene scene = small_scene();
    write_gltf(scene, folder / "room.gltf");
    const Json json = read_json(folder / "room.gltf");
    for (size_t i = 0; i < scene.materials.size(); ++i) {
        const Json& material = json["materials"][i];
        const Json extensions = material.value("extensions", Json::object());
        const float strength =
            extensions.contains("KHR_materials_emissive_strength")
                ? extensions["KHR_materials_emissive_strength"]["emissiveStrength"].get<float>()
                : 1.0f;
        const auto factor = material.value("emissiveFactor", std::vector<float>{0.0f, 0.0f, 0.0f});
        for (size_t c = 0; c < 3; ++c) {
            EXPECT_LE(factor[c], 1.0f);
            EXPECT_NEAR(factor[c] * strength, scene.materials[i].radiance[glm::length_t(c)], 1e-5f);
        }
    }
    // Used extensions are declared, others are not.
    EXPECT_EQ(json["extensionsUsed"],
              Json({"KHR_lights_punctual", "KHR_materials_emissive_strength", "KHR_materials_ior",
                    "KHR_materials_specular"}));
}

TEST(SceneExport, MaterialsKeepTheirLook) {
    const ExportFolder folder;
    write_gltf(small_scene(), folder / "room.gltf");
    const Json json = read_json(folder / "room.gltf");
    const Json& floor = json["materials"][0];
    EXPECT_EQ(floor["extensions"]["KHR_materials_specular"]["specularFactor"], 0);
    EXPECT_EQ(floor["pbrMetallicRoughness"]["metallicFactor"], 0);
    EXPECT_FALSE(floor.contains("alphaMode"));
    const Json& pane = json["materials"][2];
    EXPECT_EQ(pane["alphaMode"], "BLEND");
    EXPECT_FLOAT_EQ(pane["pbrMetallicRoughness"]["baseColorFactor"][3], 0.33f);
    EXPECT_FLOAT_EQ(pane["pbrMetallicRoughness"]["roughnessFactor"], 0.25f);
    EXPECT_NEAR(pane["extensions"]["KHR_materials_ior"]["ior"].get<float>(), 1.5f, 1e-5f);

    // The texture: decoded by tinygltf's reader, sRGB bytes.
    const tinygltf::Model model = read_model(folder / "room.gltf");
    ASSERT_EQ(model.images.size(), 1u);
    EXPECT_EQ(model.images[0].uri, "room_textures/e1u1__0floor_.png");
    EXPECT_EQ(model.images[0].width, 2);
    const std::vector<unsigned char>& pixels = model.images[0].image;
    const auto at = [&](size_t pixel, size_t channel) {
        return int{pixels.at(pixel * static_cast<size_t>(model.images[0].component) + channel)};
    };
    EXPECT_EQ(at(0, 0), 255);
    EXPECT_EQ(at(0, 1), 0);
    EXPECT_EQ(at(1, 1), 127); // 0.2140 linear
}

TEST(SceneExport, CameraSeesTheSame) {
    const ExportFolder folder;
    write_gltf(small_scene(), folder / "room.gltf");
    const tinygltf::Model model = read_model(folder / "room.gltf");
    ASSERT_EQ(model.cameras.size(), 1u);
    const tinygltf::PerspectiveCamera& camera = model.cameras[0].perspective;
    EXPECT_FLOAT_EQ(static_cast<float>(camera.yfov), 1.25f);
    EXPECT_FLOAT_EQ(static_cast<float>(camera.aspectRatio), 16.0f / 9.0f);
    EXPECT_GT(camera.znear, 0.0);
    const glm::mat4 place = matrix_of(node_named(model, "view"));
    EXPECT_FLOAT_EQ(glm::determinant(place), 1.0f); // a rotation: right-handed
    EXPECT_EQ(place * glm::vec4(0, 0, 0, 1), glm::vec4(1, 2, 3, 1));
    EXPECT_EQ(place * glm::vec4(0, 0, -1, 0), glm::vec4(0, 1, 0, 0)); // forward
    EXPECT_EQ(place * glm::vec4(1, 0, 0, 0), glm::vec4(1, 0, 0, 0));  // right
    EXPECT_EQ(place * glm::vec4(0, 1, 0, 0), glm::vec4(0, 0, 1, 0));  // up
}

TEST(SceneExport, SunShinesFromItsDirection) {
    const ExportFolder folder;
    const ExportScene scene = small_scene();
    write_gltf(scene, folder / "room.gltf");
    const glm::mat4 place = matrix_of(node_named(read_model(folder / "room.gltf"), "sun"));
    EXPECT_NEAR(glm::determinant(place), 1.0f, 1e-5f);
    EXPECT_LT(glm::distance(glm::vec3(place * glm::vec4(0, 0, -1, 0)), -scene.sun->direction),
              1e-6f);
    const Json json = read_json(folder / "room.gltf");
    const Json& light = json["extensions"]["KHR_lights_punctual"]["lights"][0];
    EXPECT_EQ(light["type"], "directional");
    EXPECT_FLOAT_EQ(light["intensity"], 4.0f);
    EXPECT_FLOAT_EQ(light["color"][2], 0.25f);
    EXPECT_FLOAT_EQ(light["extras"]["angular_diameter_degrees"], 0.5f);
    EXPECT_FLOAT_EQ(json["scenes"][0]["extras"]["vigil_sky"]["radiance"][2], 0.3f);
}

TEST(SceneExport, SunMayBeAPoint) {
    const ExportFolder folder;
    ExportScene scene = small_scene();
    scene.sun->angular_diameter = 0.0f;
    write_gltf(scene, folder / "room.gltf");
    const Json light =
        read_json(folder / "room.gltf")["extensions"]["KHR_lights_punctual"]["lights"][0];
    EXPECT_EQ(light["extras"]["angular_diameter_degrees"], 0.0f);
    EXPECT_FLOAT_EQ(light["intensity"], 4.0f); // irradiance: the same for every angle
}

TEST(SceneExport, SkyFacesArePlacedByNoNode) {
    const ExportFolder folder;
    ExportScene scene = small_scene();
    scene.sky->faces = {{0, 0, 8}, {0, 4, 8}, {4, 0, 8}};
    write_gltf(scene, folder / "room.gltf");
    const Json json = read_json(folder / "room.gltf");
    const size_t faces = json["scenes"][0]["extras"]["vigil_sky"]["faces"];
    EXPECT_EQ(json["meshes"][faces]["name"], "sky faces");
    for (const Json& node : json["nodes"])
        EXPECT_TRUE(!node.contains("mesh") || node["mesh"] != faces);
    const tinygltf::Model model = read_model(folder / "room.gltf");
    const tinygltf::Primitive& primitive = model.meshes[faces].primitives.at(0);
    EXPECT_EQ(primitive.material, -1);
    const tinygltf::Accessor& corners = model.accessors[primitive.attributes.at("POSITION")];
    EXPECT_EQ(corners.count, 3u);
    EXPECT_EQ(corners.minValues, (std::vector<double>{0, 0, 8}));
    EXPECT_EQ(corners.maxValues, (std::vector<double>{4, 4, 8}));
}

TEST(SceneExport, EmptySceneIsValid) {
    const ExportFolder folder;
    write_gltf({}, folder / "empty.gltf");
    const Json json = read_json(folder / "empty.gltf");
    for (const auto& [key, value] : json.items())
        EXPECT_FALSE(value.is_array() && value.empty()) << key;
    EXPECT_FALSE(json.contains("buffers"));
    EXPECT_EQ(read_model(folder / "empty.gltf").nodes.size(), 2u); // root and camera
}

TEST(SceneExport, NamesNeedNotBeFileNames) {
    const ExportFolder folder;
    ExportScene scene = small_scene();
    scene.name = "\xff\xfe"; // not UTF-8
    scene.textures[0].name = "../../evil";
    scene.textures[1].name = "..//..//EVIL";
    scene.materials[1].texture = 1;
    scene.materials[2].texture = 0;
    write_gltf(scene, folder / "a b#%.gltf");
    const tinygltf::Model model = read_model(folder / "a b#%.gltf");
    ASSERT_EQ(model.images.size(), 2u);
    for (const tinygltf::Image& image : model.images)
        EXPECT_GT(image.width, 0) << image.uri; // found under its encoded name
    EXPECT_EQ(folder.files(), 2u + 2u);
}

/// Scenes that must be refused, each with a word its message contains.
struct BadScene {
    const char* word;
    void (*spoil)(ExportScene&);
};

class BadScenes : public testing::TestWithParam<BadScene> {};

TEST_P(BadScenes, AreRefusedAndTheOldExportStays) {
    const ExportFolder folder;
    write_gltf(small_scene(), folder / "room.gltf");
    const Json before = read_json(folder / "room.gltf");
    const size_t files = folder.files();
    ExportScene scene = small_scene();
    GetParam().spoil(scene);
    try {
        write_gltf(scene, folder / "room.gltf");
        FAIL() << "not refused";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find(GetParam().word), std::string::npos)
            << error.what();
        EXPECT_NE(std::string(error.what()).find("room.gltf"), std::string::npos);
    }
    EXPECT_EQ(read_json(folder / "room.gltf"), before);
    EXPECT_EQ(folder.files(), files);
}

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

INSTANTIATE_TEST_SUITE_P(
    SceneExport, BadScenes,
    testing::Values(
        BadScene{"no material 9", [](ExportScene& s) { s.meshes[0].primitives[0].material = 9; }},
        BadScene{"no texture 7", [](ExportScene& s) { s.materials[0].texture = 7; }},
        BadScene{"no mesh 5", [](ExportScene& s) { s.instances[0].mesh = 5; }},
        BadScene{"index 4", [](ExportScene& s) { s.meshes[0].primitives[0].indices[2] = 4; }},
        BadScene{"not triangles",
                 [](ExportScene& s) { s.meshes[0].primitives[0].indices.pop_back(); }},
        BadScene{"coordinates", [](ExportScene& s) { s.meshes[0].primitives[0].uvs.pop_back(); }},
        BadScene{"not finite",
                 [](ExportScene& s) { s.meshes[0].primitives[0].positions[1].y = not_a_number; }},
        BadScene{"not finite",
                 [](ExportScene& s) { s.meshes[0].primitives[0].uvs[1].y = not_a_number; }},
        BadScene{"not finite",
                 [](ExportScene& s) { s.instances[1].world_from_object[3].x = not_a_number; }},
        BadScene{"out of range", [](ExportScene& s) { s.materials[1].radiance.x = -1.0f; }},
        BadScene{"out of range", [](ExportScene& s) { s.materials[1].radiance.x = not_a_number; }},
        BadScene{"camera", [](ExportScene& s) { s.camera.aspect = 0.0f; }},
        BadScene{"sun", [](ExportScene& s) { s.sun->direction = glm::vec3(0.0f); }},
        BadScene{"texels", [](ExportScene& s) { s.textures[0].width = 3; }}));

TEST(SceneExport, UnwritablePlacesLeaveNothing) {
    const ExportFolder folder;
    EXPECT_THROW(write_gltf(small_scene(), folder / "room.glb"), Error);
    EXPECT_THROW(write_gltf(small_scene(), folder / ".gltf"), Error);
    // A file stands where the folder should be.
    std::ofstream(folder / "file") << "x";
    EXPECT_THROW(write_gltf(small_scene(), folder / "file" / "room.gltf"), Error);
    EXPECT_EQ(folder.files(), 1u);
}

TEST(SceneExport, FullDiskKeepsTheOldExport) {
    const ExportFolder folder;
    write_gltf(small_scene(), folder / "room.gltf");
    const Json before = read_json(folder / "room.gltf");
    const size_t files = folder.files();
    // A limit on the size of files stands in for a full disk: writing fails half way.
    rlimit old{};
    ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &old), 0);
    const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
    rlimit small = old;
    small.rlim_cur = 1000;
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
    ExportScene other = small_scene();
    other.name = "another";
    EXPECT_THROW(write_gltf(other, folder / "room.gltf"), Error);
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &old), 0);
    std::signal(SIGXFSZ, old_handler);
    EXPECT_EQ(read_json(folder / "room.gltf"), before);
    EXPECT_EQ(folder.files(), files);
}

TEST(SceneExport, MissingFoldersAreMade) {
    const ExportFolder folder;
    write_gltf(small_scene(), folder / "deep" / "er" / "room.gltf");
    EXPECT_EQ(read_model(folder / "deep" / "er" / "room.gltf").meshes.size(), 2u);
}

} // namespace
} // namespace vigil::vkpt
