// SPDX-License-Identifier: GPL-2.0-or-later
// Materials from texinfos, meshes and materials.json, and what is said when that file is wrong.
#include "refresh/vkpt/scene/material_set.h"

#include "common/file_system.h"
#include "common/scratch_folder.h"

#include <gtest/gtest.h>

namespace vigil::vkpt {
namespace {

class MaterialSetTest : public testing::Test {
protected:
    MaterialSetTest() {
        files_.mount_game(std::filesystem::path(VIGIL_SOURCE_DIR) / "tests" / "data", "baseq2");
    }

    void write(std::string_view name, std::string_view text) {
        folder_.write(name, text);
        files_.mount_folder(folder_.path());
    }

    /// Adds a texinfo and returns its index.
    uint32_t add(const std::string& texture, uint32_t flags = 0, int value = 0, int32_t next = -1) {
        BspTexInfo info;
        info.texture = texture;
        info.flags = flags;
        info.value = value;
        info.next = next;
        bsp_.texinfos.push_back(info);
        return static_cast<uint32_t>(bsp_.texinfos.size() - 1);
    }

    test::ScratchFolder folder_;
    FileSystem files_;
    TextureSet textures_{files_};
    Bsp bsp_;
};

TEST_F(MaterialSetTest, FlagsOfATexinfo) {
    MaterialSet materials(files_, textures_);
    const auto flags_of = [&](uint32_t surface_flags) {
        return materials
            .materials()[materials.world_material(bsp_, add("test/sand", surface_flags)).index]
            .flags;
    };
    EXPECT_EQ(flags_of(0), 0u);
    EXPECT_EQ(flags_of(SURF_SKY), shader::MATERIAL_SKY);
    EXPECT_EQ(flags_of(SURF_WARP), shader::MATERIAL_WARP);
    EXPECT_EQ(flags_of(SURF_FLOWING), shader::MATERIAL_FLOWING);
    const auto coverage_of = [&](uint32_t surface_flags) {
        return materials.world_material(bsp_, add("test/sand", surface_flags)).coverage;
    };
    EXPECT_EQ(coverage_of(0), 255u);
    EXPECT_EQ(coverage_of(SURF_TRANS33), coverage_trans33);
    EXPECT_EQ(coverage_of(SURF_TRANS66), coverage_trans66);
}

TEST_F(MaterialSetTest, EmissionIsValueTimesMeanTexel) {
    MaterialSet materials(files_, textures_);
    const MaterialSet::WorldMaterial lamp =
        materials.world_material(bsp_, add("test/lamp_warm", SURF_LIGHT, 400));
    const glm::vec3 mean = textures_.texture("test/lamp_warm").mean;
    EXPECT_NEAR(glm::distance(lamp.radiance, 40.0f * mean), 0.0f, 1e-4f);
    const shader::Material& material = materials.materials()[lamp.index];
    EXPECT_TRUE(material.flags & shader::MATERIAL_EMISSIVE);
    EXPECT_NEAR(glm::distance(material.inverse_mean * mean, glm::vec3(1.0f)), 0.0f, 1e-5f);
    // Without the flag, without a value, in the sky or hidden: no emission.
    for (const auto& [flags, value] : {std::pair<uint32_t, int>{0, 400},
                                       {SURF_LIGHT, 0},
                                       {SURF_LIGHT, -5},
                                       {SURF_LIGHT | SURF_SKY, 400},
                                       {SURF_LIGHT | SURF_NODRAW, 400}})
        EXPECT_EQ(materials.world_material(bsp_, add("test/lamp_warm", flags, value)).radiance,
                  glm::vec3(0.0f))
            << flags;
}

TEST_F(MaterialSetTest, ColourlessChannelsHaveNoInverse) {
    MaterialSet materials(files_, textures_);
    const auto lamp = materials.world_material(bsp_, add("test/black", SURF_LIGHT, 100));
    EXPECT_EQ(lamp.radiance, glm::vec3(0.0f));
    EXPECT_EQ(materials.materials()[lamp.index].inverse_mean, glm::vec3(0.0f));
}

TEST_F(MaterialSetTest, AnimationFollowsTheTexinfoChain) {
    MaterialSet materials(files_, textures_);
    const uint32_t last = add("test/red", 0, 0, 0), middle = add("test/blue", 0, 0, 0),
                   first = add("test/white");
    bsp_.texinfos[first].next = static_cast<int32_t>(middle);
    bsp_.texinfos[middle].next = static_cast<int32_t>(last);
    bsp_.texinfos[last].next = static_cast<int32_t>(first); // closed, as compilers write it
    const shader::Material& material =
        materials.materials()[materials.world_material(bsp_, first).index];
    ASSERT_EQ(material.frame_count, 3u);
    const auto texel_of = [&](uint32_t header) { return textures_.headers()[header].first_texel; };
    EXPECT_EQ(texel_of(material.texture), texel_of(textures_.texture("test/white").header));
    EXPECT_EQ(texel_of(material.texture + 1), texel_of(textures_.texture("test/blue").header));
    EXPECT_EQ(texel_of(material.texture + 2), texel_of(textures_.texture("test/red").header));
    // Starting in the middle shows the rest first.
    const shader::Material& other =
        materials.materials()[materials.world_material(bsp_, middle).index];
    EXPECT_EQ(texel_of(other.texture), texel_of(textures_.texture("test/blue").header));
    EXPECT_EQ(other.frame_count, 3u);
}

TEST_F(MaterialSetTest, GlossComesFromMaterialsJson) {
    write("materials.json",
          R"({"Test/SAND": {"roughness": 0.3, "specular": 0.05}, "test/red": {"roughness": 0.5}})");
    MaterialSet materials(files_, textures_);
    const shader::Material sand =
        materials.materials()[materials.world_material(bsp_, add("test/sand")).index];
    EXPECT_TRUE(sand.flags & shader::MATERIAL_GLOSSY);
    EXPECT_FLOAT_EQ(sand.roughness, 0.3f);
    EXPECT_FLOAT_EQ(sand.specular, 0.05f);
    const shader::Material red =
        materials.materials()[materials.world_material(bsp_, add("test/red")).index];
    EXPECT_FALSE(red.flags & shader::MATERIAL_GLOSSY) << "no reflectance, no gloss";
}

TEST_F(MaterialSetTest, LightOfMaterialsJsonReplacesTheLevels) {
    write("materials.json", R"({"test/sand": {"light": 50}, "test/red": {"light": 0}})");
    MaterialSet materials(files_, textures_);
    const auto& sand = materials.world_material(bsp_, add("test/sand"));
    EXPECT_EQ(sand.radiance, textures_.texture("test/sand").mean * 5.0f);
    EXPECT_TRUE(materials.materials()[sand.index].flags & shader::MATERIAL_EMISSIVE);
    EXPECT_FALSE(materials.materials()[sand.index].flags & shader::MATERIAL_GLOSSY);
    const uint32_t lamp = add("test/red");
    bsp_.texinfos[lamp].flags |= SURF_LIGHT;
    bsp_.texinfos[lamp].value = 100;
    EXPECT_EQ(materials.world_material(bsp_, lamp).radiance, glm::vec3(0.0f));
    const uint32_t sky = add("test/sand");
    bsp_.texinfos[sky].flags |= SURF_SKY;
    EXPECT_EQ(materials.world_material(bsp_, sky).radiance, glm::vec3(0.0f));
}

TEST_F(MaterialSetTest, WrongMaterialsJsonIsNamedAndIgnored) {
    for (const char* text : {"{", "[1, 2]", R"({"test/sand": 5})",
                             R"({"test/sand": {"roughness": "smooth", "specular": 1}})",
                             R"({"test/sand": {"roughness": 0.01, "specular": 0.5}})",
                             R"({"test/sand": {"roughness": 0.5, "specular": 2}})", ""}) {
        SCOPED_TRACE(text);
        write("materials.json", text);
        const test::LogCapture log;
        MaterialSet materials(files_, textures_);
        EXPECT_TRUE(log.contains("materials.json")) << log.all();
        const uint32_t index = materials.world_material(bsp_, add("test/sand")).index;
        EXPECT_FALSE(materials.materials()[index].flags & shader::MATERIAL_GLOSSY);
    }
}

TEST_F(MaterialSetTest, MeshesHaveFlatColoursAndTheirOwnEmission) {
    MaterialSet materials(files_, textures_);
    MeshMaterial plaster;
    plaster.base_color = {0.5f, 0.25f, 0.125f, 1.0f};
    plaster.metallic = 0.0f;
    const shader::Material dull = materials.materials()[materials.mesh_material(plaster)];
    EXPECT_EQ(dull.flags, 0u);
    EXPECT_NEAR(decode_rgb9e5(textures_.texels()[textures_.headers()[dull.texture].first_texel]).y,
                0.25f, 1e-3f);
    plaster.roughness = 0.4f;
    const shader::Material smooth = materials.materials()[materials.mesh_material(plaster)];
    EXPECT_TRUE(smooth.flags & shader::MATERIAL_GLOSSY);
    EXPECT_FLOAT_EQ(smooth.specular, 0.04f);
    plaster.metallic = 1.0f;
    const shader::Material metal = materials.materials()[materials.mesh_material(plaster)];
    EXPECT_EQ(decode_rgb9e5(textures_.texels()[textures_.headers()[metal.texture].first_texel]),
              glm::vec3(0.0f));
    EXPECT_NEAR(metal.specular, 0.875f / 3.0f, 1e-6f);
    plaster.emissive = {1, 2, 3};
    const shader::Material glowing = materials.materials()[materials.mesh_material(plaster)];
    EXPECT_TRUE(glowing.flags & shader::MATERIAL_EMISSIVE);
    EXPECT_EQ(glowing.inverse_mean, glm::vec3(0.0f)) << "its emission has no texture";
}

TEST_F(MaterialSetTest, EqualMaterialsAreOne) {
    MaterialSet materials(files_, textures_);
    const uint32_t first = materials.world_material(bsp_, add("test/sand")).index;
    EXPECT_EQ(materials.world_material(bsp_, add("test/sand")).index, first);
    EXPECT_NE(materials.world_material(bsp_, add("test/red")).index, first);
    EXPECT_EQ(materials.picture_material("textures/test/blue.png"),
              materials.picture_material("textures/test/blue.png"));
}

} // namespace
} // namespace vigil::vkpt
