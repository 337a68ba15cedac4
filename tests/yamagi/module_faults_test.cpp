// SPDX-License-Identifier: GPL-2.0-or-later
// One message for everything that is wrong, and light for levels that were made without.
#include "module_fixture.h"

#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <map>

namespace vigil::test {
namespace {

/// A level of tests/data whose faces do not shine, with other entities.
Bytes dark_level(const std::string& entities) {
    std::ifstream file(VIGIL_SOURCE_DIR "/tests/data/baseq2/maps/lamp.bsp", std::ios::binary);
    Bytes bytes(std::istreambuf_iterator<char>(file), {});
    const auto lump = [&](size_t number) {
        std::array<uint32_t, 2> place{};
        std::memcpy(place.data(), &bytes.at(8 + 8 * number), sizeof(place));
        return place;
    };
    const auto [infos, size] = lump(5);
    for (size_t info = infos; info < infos + size; info += 76)
        std::fill_n(bytes.begin() + static_cast<ptrdiff_t>(info + 32), 4, uint8_t{0}); // flags
    const std::array place{static_cast<uint32_t>(bytes.size()),
                           static_cast<uint32_t>(entities.size() + 1)};
    std::memcpy(&bytes.at(8), place.data(), sizeof(place));
    bytes.insert(bytes.end(), entities.begin(), entities.end());
    bytes.push_back(0);
    return bytes;
}

TEST_F(ModuleTest, LevelsMadeForLightMapsAreNotBlack) {
    const std::string world = "{ \"classname\" \"worldspawn\" }";
    const std::string place = "\"origin\" \"0 0 64\"";
    MemorySource::Files files = game_files();
    files["maps/red.bsp"] = dark_level(world + "{ \"classname\" \"light\" " + place +
                                       " \"_color\" \"1 0 0\" \"style\" \"5\" }");
    files["maps/start.bsp"] =
        dark_level(world + "{ \"classname\" \"info_player_start\" \"origin\" \"0 0 24\" }");
    start("8.20", 5, std::move(files));
    ASSERT_EQ(module().init(), 1);
    EngineView seen = view();
    std::ranges::copy(std::array{-40.0f, 0.0f, 60.0f}, seen.origin);
    std::ranges::copy(std::array{30.0f, 0.0f, 0.0f}, seen.angles);
    const auto picture = [&](const char* level) {
        module().begin_registration(level);
        for (int i = 0; i < 2; ++i)
            show(seen);
        return host().screenshot();
    };
    const auto sum = [](const HostPicture& shown, size_t part) {
        double total = 0.0;
        for (size_t i = part; i < shown.rgb.size(); i += 3)
            total += shown.rgb[i];
        return total / (static_cast<double>(shown.rgb.size()) / 3.0);
    };
    const HostPicture red_light = picture("red"), start_light = picture("start");
    EXPECT_GT(sum(red_light, 0), 10.0);
    EXPECT_LT(sum(red_light, 2), 0.2 * sum(red_light, 0));
    EXPECT_GT(sum(start_light, 2), 10.0) << "as long as somebody starts there";
}

TEST_F(ModuleTest, MissingLevelIsOneMessage) {
    begin();
    module().begin_registration("nowhere");
    EXPECT_EQ(host().count("nowhere"), 1);
    ModelObject* const box = module().register_model("models/box/tris.md2");
    ViewEntity entity{};
    entity.model = box;
    EngineView seen = view();
    seen.entity_count = 1;
    seen.entities = &entity;
    const size_t before = host().lines.size();
    for (int i = 0; i < 3; ++i)
        host().frame([&](const ModuleFunctions& f) {
            f.render_view(&seen);
            f.draw_stretched(0, 0, 4, 4, "icon");
        });
    EXPECT_EQ(host().lines.size(), before);
    const HostPicture picture = host().screenshot();
    EXPECT_EQ(picture.at(1, 1), blue);
    EXPECT_EQ(count(picture, black), EngineHost::width * EngineHost::height - 16);
    module().begin_registration("rooms");
    show(seen); // the same object, in the next level
    EXPECT_GT(mean(host().screenshot()), 20.0);
}

TEST_F(ModuleTest, DamagedFilesAreOneMessageEach) {
    MemorySource::Files files = game_files();
    files["models/bad/tris.md2"] = {'I', 'D', 'P', '2', 1};
    files["pics/bad.tga"] = {1, 2, 3};
    files["maps/bad.bsp"] = {'I', 'B', 'S', 'P', 0};
    start("8.20", 5, std::move(files));
    ASSERT_EQ(module().init(), 1);
    module().begin_registration("bad");
    module().begin_registration("rooms");
    EXPECT_NE(module().register_model("models/bad/tris.md2"), nullptr);
    EXPECT_NE(module().register_model("models/bad/tris.md2"), nullptr);
    for (int i = 0; i < 3; ++i)
        host().frame([&](const ModuleFunctions& f) {
            f.draw_picture(0, 0, "bad", 1.0f);
            f.draw_character(0, 0, 'A', 1.0f);
        });
    EXPECT_EQ(host().count("maps/bad.bsp"), 1);
    EXPECT_EQ(host().count("models/bad/tris.md2"), 1);
    EXPECT_EQ(host().count("pics/bad.tga"), 1);
}

TEST_F(ModuleTest, UnknownVersionIsOneMessage) {
    start("9.10 x86_64", 5); // no more is written than the oldest makes room for
    EXPECT_EQ(module().api_version, 0) << "which no engine takes";
    EXPECT_EQ(host().count("9.10"), 1);
    EXPECT_EQ(host().lines.size(), 1);
    module().shutdown();
    host().set("vigil_api", "8");
    host().get_functions(8);
    EXPECT_EQ(module().api_version, 8);
    EXPECT_EQ(host().lines.size(), 1);
}

TEST_F(ModuleTest, WithoutVulkanTheEngineGoesOn) {
    const char* const names[] = {"VK_DRIVER_FILES", "VK_ICD_FILENAMES"};
    std::map<std::string, std::optional<std::string>> before;
    for (const char* name : names) {
        const char* const value = std::getenv(name);
        before[name] = value != nullptr ? std::optional<std::string>(value) : std::nullopt;
        setenv(name, "/nowhere.json", 1);
    }
    start();
    host().set("vk_validation", "0"); // which tells of it, too
    EXPECT_EQ(module().init(), 0);
    EXPECT_EQ(host().windows, 0);
    EXPECT_EQ(host().lines.size(), 1);
    EXPECT_EQ(host().count("Vulkan"), 1);
    EXPECT_FALSE(host().has_command("screenshot"));
    module().shutdown();
    for (const auto& [name, value] : before)
        value ? setenv(name.c_str(), value->c_str(), 1) : unsetenv(name.c_str());
    EXPECT_EQ(module().init(), 1) << "as soon as there is one";
}

} // namespace
} // namespace vigil::test
