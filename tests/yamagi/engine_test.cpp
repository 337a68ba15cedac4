// SPDX-License-Identifier: GPL-2.0-or-later
// Which engine is which, what a version's structure looks like, and which file a picture is.
#include "common/memory_source.h"
#include "yamagi/engine.h"
#include "yamagi/level_lights.h"
#include "yamagi/level_view.h"
#include "yamagi/screen.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace vigil::yamagi {
namespace {

TEST(Versions, OfTheEngine) {
    EXPECT_EQ(api_of("8.20 x86_64 Jan  8 2023"), 5);
    EXPECT_EQ(api_of("Yamagi Quake II v8.50"), 7);
    EXPECT_EQ(api_of("8.51"), 7);
    EXPECT_EQ(api_of("8.70 x86_64"), 8);
    for (const char* text : {"", "8", "x86_64", "7.45", "8.30", "8.41", "9.00", "18.20", "8.2"})
        EXPECT_EQ(api_of(text), 0) << text;
}

TEST(Versions, HaveTheirOwnStructures) {
    ModuleFunctions functions{};
    functions.init = [] { return Flag{0}; };
    functions.drawable_size = [](int*, int*) {};
    functions.shutdown_context = [] {};
    functions.end_level_view = [] { return Flag{1}; };
    functions.draw_coloured = [](int, int, const char*, float, const float*) {};
    for (const int api : {0, 5, 6, 7, 8}) {
        functions.api_version = api;
        std::array<std::byte, 256> bytes{};
        write_api(functions, bytes.data());
        const auto pointer_at = [&](size_t offset) {
            void* pointer = nullptr;
            std::memcpy(&pointer, &bytes.at(offset), sizeof(pointer));
            return pointer;
        };
        const size_t shift = api >= 6 ? 8 : 0;
        EXPECT_EQ(pointer_at(8), reinterpret_cast<void*>(functions.init));
        EXPECT_EQ(pointer_at(40) == reinterpret_cast<void*>(functions.drawable_size), api >= 6);
        EXPECT_EQ(pointer_at(40 + shift), reinterpret_cast<void*>(functions.shutdown_context));
        EXPECT_EQ(pointer_at(200 + shift), reinterpret_cast<void*>(functions.end_level_view));
        EXPECT_EQ(pointer_at(216) == reinterpret_cast<void*>(functions.draw_coloured), api >= 8);
        EXPECT_EQ(pointer_at(bytes_of_api(api)), nullptr) << "nothing behind it";
    }
}

TEST(Pictures, HaveFilesInSeveralFormats) {
    FileSystem files;
    files.mount(std::make_unique<test::MemorySource>(
        test::MemorySource::Files{{"pics/a.pcx", {}},
                                  {"pics/a.png", {}},
                                  {"pics/b.png", {}},
                                  {"pics/c.jpg", {}},
                                  {"players/male/grunt.pcx", {}}}));
    EXPECT_EQ(picture_file(files, "a"), "pics/a.pcx");
    EXPECT_EQ(picture_file(files, "b"), "pics/b.png");
    EXPECT_EQ(picture_file(files, "c"), "pics/c.jpg");
    EXPECT_EQ(picture_file(files, "d"), std::nullopt);
    EXPECT_EQ(picture_file(files, "/players/male/grunt.pcx"), "players/male/grunt.pcx");
    EXPECT_EQ(picture_file(files, "\\pics\\b.pcx"), "pics/b.png");
    for (const char* name : {"", "/", "/a", "../x", "/../pics/a.pcx", "//a.pcx"})
        EXPECT_EQ(picture_file(files, name), std::nullopt) << name;
}

std::vector<LevelLight> lights_of(const Bsp& bsp, EntityLights wanted,
                                  const MaterialTable& materials = {}) {
    return entity_lights(Level{"test", bsp, {}}, materials, wanted);
}

TEST(Views, WaverUnderWater) {
    float widest = 0.0f, most = 0.0f;
    double fov = 0.0, roll = 0.0;
    for (int i = 0; i < 100; ++i) {
        refresh::View view;
        view.fov_y = 60.0f;
        waver(view, 1000.0 + 0.025 * i); // one turn
        widest = std::max(widest, std::abs(view.fov_y - 60.0f));
        most = std::max(most, std::abs(view.angles.z));
        fov += static_cast<double>(view.fov_y) / 100;
        roll += static_cast<double>(view.angles.z) / 100;
    }
    EXPECT_NEAR(widest, 1.2f, 0.01f);
    EXPECT_NEAR(most, 1.0f, 0.01f);
    EXPECT_NEAR(fov, 60.0, 1e-3);
    EXPECT_NEAR(roll, 0.0, 1e-3);
}

TEST(Views, WeaponsHaveTheirAngleAndHand) {
    EXPECT_EQ(weapon_scale({}, 60.0f), glm::vec2(1.0f));
    EXPECT_EQ(weapon_scale({true, true, -1.0f}, 60.0f), glm::vec2(-1.0f, 1.0f));
    // What fills the height of its own 90 degrees is tan(30) as high in a view of 60: it is drawn
    // that much smaller across.
    const glm::vec2 scale = weapon_scale({true, false, 90.0f}, 60.0f);
    EXPECT_NEAR(scale.x, std::tan(glm::radians(30.0f)), 1e-6f);
    EXPECT_EQ(scale.x, scale.y);
}

TEST(LevelLights, AreThoseOfEntitiesOrOfStarts) {
    Bsp bsp;
    const std::string starts = R"({ "classname" "worldspawn" }
        { "classname" "info_player_start" "origin" "1 2 3" })";
    bsp.entities = parse_entities("starts", starts);
    const auto over = lights_of(bsp, EntityLights::WhereNothingShines);
    ASSERT_EQ(over.size(), 1);
    EXPECT_EQ(over[0].origin, glm::vec3(1, 2, 43));
    EXPECT_TRUE(lights_of(bsp, EntityLights::None).empty());

    bsp.entities = parse_entities("lights", starts + R"(
        { "classname" "light" "origin" "8 9 10" "light" "200" "_color" "0.5 0.25 0" "style" "3" }
        { "classname" "light_torch_small_walltorch" "light" "400" }
        { "classname" "light" "light" "-5" }
        { "classname" "light_mine1" }
        { "classname" "light" "style" "999" })");
    const auto lights = lights_of(bsp, EntityLights::WhereNothingShines);
    ASSERT_EQ(lights.size(), 3);
    EXPECT_EQ(lights[0].origin, glm::vec3(8, 9, 10));
    EXPECT_EQ(lights[0].style, 3);
    EXPECT_EQ(lights[2].style, 255);
    // Half way, a white surface under the ball is as bright as under the light map: 100 of 255.
    const float seen = lights[0].radiance.x * level_light_radius * level_light_radius / (100 * 100);
    EXPECT_NEAR(seen, 20.0f * 100.0f / 255.0f, 0.01f);
    EXPECT_FLOAT_EQ(lights[0].radiance.y, 0.5f * lights[0].radiance.x);
    EXPECT_FLOAT_EQ(lights[1].radiance.y, 8.0f * lights[0].radiance.x);
}

TEST(LevelLights, StandForWhatDoesNotShine) {
    // A square of 64 units at the height 0, whose front looks up; no visibility: all is seen.
    Bsp bsp;
    bsp.vertices = {{0, 0, 0}, {64, 0, 0}, {64, 64, 0}, {0, 64, 0}};
    bsp.edges = {{0, 0}, {0, 1}, {1, 2}, {2, 3}, {3, 0}};
    bsp.surf_edges = {1, 2, 3, 4};
    bsp.planes.resize(1);
    bsp.planes[0].normal = {0, 0, 1};
    bsp.models.resize(1);
    bsp.leafs.resize(1);
    bsp.models[0].headnode = -1;
    bsp.faces.resize(1);
    bsp.faces[0].edge_count = 4;
    bsp.texinfos = {{{}, {}, SURF_LIGHT, 100, "Lamp", -1}};
    bsp.entities = parse_entities("lights", R"(
        { "classname" "light" "origin" "32 32 40" "light" "200" }
        { "classname" "light" "origin" "32 500 40" "light" "200" })");
    const auto found = [&](EntityLights wanted, const MaterialTable& materials = {}) {
        return lights_of(bsp, wanted, materials).size();
    };
    EXPECT_EQ(found(EntityLights::All), 2);
    EXPECT_EQ(found(EntityLights::WhereNothingShines), 1) << "one has a lamp in its reach";
    EXPECT_EQ(found(EntityLights::WhereNothingShines, {{"lamp", {1, 0, 0.0f}}}), 2);
    bsp.texinfos[0].value = 0;
    EXPECT_EQ(found(EntityLights::WhereNothingShines), 2) << "it does not shine";
    EXPECT_EQ(found(EntityLights::WhereNothingShines, {{"lamp", {1, 0, 80.0f}}}), 1);
    bsp.texinfos[0].flags = SURF_SKY;
    EXPECT_EQ(found(EntityLights::WhereNothingShines), 1);
}

} // namespace
} // namespace vigil::yamagi
