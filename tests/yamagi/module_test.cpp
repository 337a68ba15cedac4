// SPDX-License-Identifier: GPL-2.0-or-later
// The module as an engine sees it, by the calls of every API version: pictures that are not black,
// 2D in its place, levels that change, and one message for everything that is wrong.
#include "common/scratch_folder.h"
#include "engine_host.h"
#include "formats/picture_bytes.h"
#include "formats/small_models.h"
#include "gpu/validated.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>
#include <iterator>
#include <map>
#include <optional>
#include <unistd.h>

namespace vigil::test {
namespace {

using Color = std::array<int, 3>;
using yamagi::EngineView;
using yamagi::ModelObject;
using yamagi::ModuleFunctions;
using yamagi::PictureObject;
using yamagi::ViewEntity;

constexpr Color red{255, 0, 0}, green{0, 255, 0}, blue{0, 0, 255}, black{0, 0, 0};

/// A picture of one colour.
Bytes plain(uint32_t width, uint32_t height, const Color& color) {
    Image image{width, height, {}};
    for (uint32_t i = 0; i < width * height; ++i)
        for (const int part : {color[0], color[1], color[2], 255})
            image.rgba.push_back(static_cast<uint8_t>(part));
    return write_tga(image, {2, 32, 0x28});
}

/// 16 x 16 characters of 8 x 8 texels: red, those of the last row green, and the space blue.
Bytes characters() {
    Image image{128, 128, {}};
    for (int y = 0; y < 128; ++y)
        for (int x = 0; x < 128; ++x) {
            const int number = y / 8 * 16 + x / 8;
            const Color color = number == 32 ? blue : number >= 240 ? green : red;
            for (const int part : {color[0], color[1], color[2], 255})
                image.rgba.push_back(static_cast<uint8_t>(part));
        }
    return write_tga(image, {2, 32, 0x28});
}

MemorySource::Files game_files() {
    return {{"pics/conchars.tga", characters()},
            {"pics/tile.tga", plain(4, 4, green)},
            {"pics/icon.tga", plain(6, 3, blue)},
            {"models/box/tris.md2", small_md2()},
            {"models/box/skin.tga", plain(2, 2, red)}};
}

class ModuleTest : public testing::Test {
protected:
    /// Of API 5, 7 and 8.
    void start(const std::string& version, int api, MemorySource::Files files = game_files()) {
        host_.emplace(version, std::move(files));
        host_->get_functions(api);
        for (const auto& [name, text] : {std::pair("pt_nee", "sll"),
                                         {"pt_guide", "brdf"},
                                         {"flt_enable", "0"},
                                         {"flt_taa", "0"}})
            host_->set(name, text);
        host_->set("vk_validation", std::to_string(validation()));
    }
    void start() { start("8.20 x86_64", 5); }
    void begin() {
        start();
        ASSERT_EQ(module().init(), 1);
    }
    void TearDown() override {
        if (!host_) return;
        EXPECT_EQ(host_->count("Vulkan validation"), 0);
        host_.reset();
    }
    EngineHost& host() { return *host_; }
    const ModuleFunctions& module() { return host_->module(); }

    /// A view into a room of tests/data, over all of the screen.
    static EngineView view() {
        static const std::array<yamagi::ViewLightStyle, yamagi::view_light_styles> styles = [] {
            std::array<yamagi::ViewLightStyle, yamagi::view_light_styles> on{};
            on.fill({{1, 1, 1}, 3});
            return on;
        }();
        EngineView view{};
        view.width = EngineHost::width;
        view.height = EngineHost::height;
        view.fov_x = 90;
        view.fov_y = 67.4f;
        std::ranges::copy(std::array{290.0f, 20.0f, 96.0f}, view.origin);
        std::ranges::copy(std::array{5.0f, 55.0f, 0.0f}, view.angles);
        view.light_styles = styles.data();
        return view;
    }
    void show(const EngineView& view) {
        host().frame([&](const ModuleFunctions& f) { f.render_view(&view); });
    }
    static double mean(const HostPicture& picture) {
        double sum = 0.0;
        for (const uint8_t value : picture.rgb)
            sum += value;
        return sum / static_cast<double>(picture.rgb.size());
    }
    static int count(const HostPicture& picture, const Color& color) {
        int count = 0;
        for (int y = 0; y < picture.height; ++y)
            for (int x = 0; x < picture.width; ++x)
                count += picture.at(x, y) == color ? 1 : 0;
        return count;
    }

private:
    std::optional<EngineHost> host_;
};

struct Version {
    const char* text;
    int api;
};

class EveryVersion : public ModuleTest, public testing::WithParamInterface<Version> {};

TEST_P(EveryVersion, ShowsALevelWithDrawsOverIt) {
    start(GetParam().text, GetParam().api);
    EXPECT_EQ(module().api_version, GetParam().api);
    module().shutdown(); // the engine may call it first
    ASSERT_EQ(module().init(), 1);
    EXPECT_EQ(host().windows, 1);
    EXPECT_EQ(host().menus, 1);
    int width = 0, height = 0;
    if (GetParam().api >= 6) {
        module().drawable_size(&width, &height);
        EXPECT_EQ(std::pair(width, height), std::pair(EngineHost::width, EngineHost::height));
    }
    module().begin_registration("rooms");
    EXPECT_NE(module().register_model("maps/rooms.bsp"), nullptr);
    ModelObject* const box = module().register_model("models/box/tris.md2");
    ASSERT_NE(box, nullptr);
    EXPECT_EQ(module().register_model("models/none/tris.md2"), nullptr);
    EXPECT_EQ(module().register_skin("models/none/skin.pcx"), nullptr);
    PictureObject* const skin = module().register_skin("models/box/skin.pcx");
    ASSERT_NE(skin, nullptr) << "as another kind of picture";
    float axis[3] = {0, 0, 1};
    module().set_sky("unit1_", 0.0f, axis);
    module().end_registration();

    // Everything at once: a model, a beam, a light, a particle, a tint.
    std::array<ViewEntity, 3> entities{};
    entities[0].model = box;
    entities[0].skin = skin;
    std::ranges::copy(std::array{320.0f, 60.0f, 80.0f}, entities[0].origin);
    entities[1].flags = yamagi::flag_beam;
    entities[1].frame = 4;
    std::ranges::copy(std::array{330.0f, 60.0f, 80.0f}, entities[1].origin);
    std::ranges::copy(std::array{330.0f, 90.0f, 120.0f}, entities[1].old_origin);
    entities[2] = entities[0]; // translucent, in a shell, with nothing else
    entities[2].flags = yamagi::flag_translucent | yamagi::flag_shell_green;
    entities[2].alpha = 0.3f;
    yamagi::ViewLight light{{300, 60, 100}, {1, 0.5f, 0}, 200};
    yamagi::ViewParticle particle{{310, 50, 90}, 0xe0, 0.5f};
    EngineView all = view();
    all.entity_count = 3;
    all.entities = entities.data();
    all.light_count = 1;
    all.lights = &light;
    all.particle_count = 1;
    all.particles = &particle;
    for (int i = 0; i < 3; ++i) {
        all.time_s = 0.1f * static_cast<float>(i);
        host().frame([&](const ModuleFunctions& f) {
            f.render_view(&all);
            f.draw_character(40, 0, 'A', 1.0f);
            f.draw_picture(0, 29, "icon", 1.0f);
            if (f.draw_coloured != nullptr) {
                const float yellow[3] = {1, 1, 0.5f};
                f.draw_coloured(10, 29, "icon", 1.0f, yellow);
            }
        });
    }
    const HostPicture picture = host().screenshot();
    EXPECT_GT(mean(picture), 20.0);
    EXPECT_EQ(picture.at(44, 4), red);
    EXPECT_EQ(picture.at(5, 31), blue);
    if (GetParam().api >= 8) {
        EXPECT_EQ(picture.at(10, 29), (Color{0, 0, 128}));
    }
    EXPECT_EQ(module().is_vsync_active(), 1);
    host().set("r_vsync", "0");
    EXPECT_EQ(module().is_vsync_active(), 0) << "the engine paces its frames by it";
}

INSTANTIATE_TEST_SUITE_P(Yamagi, EveryVersion,
                         testing::Values(Version{"8.20 x86_64", 5}, Version{"8.50 x86_64", 7},
                                         Version{"8.70 x86_64", 8}),
                         [](const auto& version) {
                             return "Api" + std::to_string(version.param.api);
                         });

TEST_F(ModuleTest, DrawsLandInPlace) {
    begin(); // no level: over black
    int width = 0, height = 0;
    module().picture_size(&width, &height, "icon");
    EXPECT_EQ(std::pair(width, height), std::pair(6, 3));
    module().picture_size(&width, &height, "none");
    EXPECT_EQ(std::pair(width, height), std::pair(0, 0));
    EXPECT_EQ(module().find_picture("none"), nullptr);
    EXPECT_STREQ(module().find_picture("icon")->name, "icon");
    EXPECT_EQ(module().find_picture("icon"), module().find_picture("icon"));

    std::array<uint8_t, 768> palette{};
    palette[3] = 255; // 1: red
    palette[8] = 255; // 2: blue
    const uint8_t film[4] = {1, 2, 2, 1};
    host().frame([&](const ModuleFunctions& f) {
        f.draw_tiles(0, 0, 10, 6, "tile");
        f.draw_character(16, 0, 'A', 1.0f);
        f.draw_character(24, 0, 255, 1.0f); // all eight bits count
        f.draw_character(32, 0, ' ', 1.0f); // nothing
        f.draw_picture(0, 8, "icon", 2.0f);
        f.draw_stretched(20, 8, 2, 6, "icon");
        f.set_palette(palette.data());
        f.draw_film(30, 8, 8, 4, 2, 2, film, 0);
        f.set_palette(nullptr);
        f.draw_picture(40, 8, "none", 1.0f);
    });
    HostPicture picture = host().screenshot();
    EXPECT_EQ(picture.at(0, 0), green);
    EXPECT_EQ(picture.at(9, 5), green);
    EXPECT_EQ(picture.at(10, 5), black);
    EXPECT_EQ(picture.at(9, 6), black);
    EXPECT_EQ(picture.at(16, 0), red);
    EXPECT_EQ(picture.at(23, 7), red);
    EXPECT_EQ(picture.at(24, 7), green);
    EXPECT_EQ(picture.at(36, 4), black);
    EXPECT_EQ(picture.at(11, 13), blue);
    EXPECT_EQ(picture.at(12, 13), black);
    EXPECT_EQ(picture.at(21, 13), blue);
    EXPECT_EQ(picture.at(33, 8), red);
    EXPECT_EQ(picture.at(34, 8), blue);
    EXPECT_EQ(picture.at(33, 11), blue);
    EXPECT_EQ(picture.at(37, 11), red);
    EXPECT_EQ(count(picture, green), 10 * 6 + 64);

    // A frame shows nothing of the one before; a fade darkens what was drawn before it.
    host().frame([&](const ModuleFunctions& f) {
        f.draw_stretched(0, 0, 4, 4, "icon");
        f.draw_fade();
        f.draw_stretched(8, 0, 4, 4, "icon");
        f.draw_fill(20, 0, 4, 4, 15);
    });
    picture = host().screenshot();
    EXPECT_EQ(picture.at(8, 0), blue);
    EXPECT_EQ(picture.at(0, 0), (Color{0, 0, 102}));
    EXPECT_GT(picture.at(21, 1)[1], 200) << "the brightest of the greys";
    EXPECT_EQ(count(picture, green), 0);
}

TEST_F(ModuleTest, MenuShowsAPlayerWithoutALevel) {
    begin();
    ViewEntity player{};
    player.model = module().register_model("models/box/tris.md2");
    player.skin = module().register_skin("models/box/skin.pcx");
    ASSERT_NE(player.model, nullptr);
    EngineView menu{};
    menu.x = 8;
    menu.y = 4;
    menu.width = menu.height = 20;
    menu.fov_x = menu.fov_y = 90;
    std::ranges::copy(std::array{5.0f, 5.0f, 11.0f}, menu.origin); // from 10 above: half the width
    std::ranges::copy(std::array{90.0f, 0.0f, 0.0f}, menu.angles);
    menu.flags = yamagi::view_without_level;
    menu.entity_count = 1;
    menu.entities = &player;
    host().frame([&](const ModuleFunctions& f) {
        f.draw_fill(0, 0, 48, 32, 0);
        f.render_view(&menu);
        f.draw_stretched(8, 4, 2, 2, "icon");
    });
    const HostPicture picture = host().screenshot();
    const Color ground = picture.at(0, 0), seen = picture.at(18, 14);
    EXPECT_GT(seen[0], 150);
    EXPECT_LT(seen[1], 20);
    EXPECT_EQ(picture.at(10, 14), ground) << "around it";
    EXPECT_EQ(picture.at(12, 14), ground);
    EXPECT_EQ(picture.at(13, 14)[0], seen[0]);
    EXPECT_EQ(picture.at(9, 5), blue) << "what is drawn later covers it";
}

TEST_F(ModuleTest, SmallViewIsTheMiddleOfTheScreen) {
    begin();
    module().begin_registration("rooms");
    const auto picture_of = [&](const EngineView& seen) {
        module().begin_registration("rooms"); // random numbers begin anew
        show(seen);
        return host().screenshot();
    };
    const HostPicture whole = picture_of(view());
    EngineView small = view();
    small.x = 12;
    small.y = 8;
    small.width = 24;
    small.height = 16;
    small.fov_y = glm::degrees(2.0f * std::atan(0.5f * std::tan(glm::radians(67.4f / 2.0f))));
    EXPECT_EQ(picture_of(small).rgb, whole.rgb);
    EngineView tinted = view();
    std::ranges::copy(std::array{1.0f, 0.0f, 0.0f, 1.0f}, tinted.blend);
    EXPECT_EQ(count(picture_of(tinted), red), EngineHost::width * EngineHost::height);
}

TEST_F(ModuleTest, VariablesFollowBothWays) {
    start();
    host().set("pt_spp", "100000");
    ASSERT_EQ(module().init(), 1);
    EXPECT_EQ(host().text("pt_spp"), "4096") << "in range from the start";
    EXPECT_EQ(host().text("pt_nee"), "sll");
    const auto next_frame = [&] { host().frame([](const ModuleFunctions&) {}); };
    host().set("pt_spp", "2");
    host().set("pt_nee", "lh");
    next_frame();
    EXPECT_EQ(host().text("pt_nee"), "lh");
    const size_t before = host().lines.size();
    host().set("pt_nee", "magic");
    host().set("pt_exposure_bias", "99");
    next_frame();
    next_frame();
    EXPECT_EQ(host().text("pt_nee"), "lh");
    EXPECT_EQ(host().text("pt_exposure_bias"), "16");
    EXPECT_EQ(host().lines.size(), before + 2) << "one message each";
}

TEST_F(ModuleTest, PresetIsAVariable) {
    start();
    // As `+set pt_preset fast` on the engine's command line, before there is a renderer.
    host().set("pt_preset", "fast");
    ASSERT_EQ(module().init(), 1);
    EXPECT_EQ(host().text("pt_nee"), "vlc");
    EXPECT_EQ(host().text("pt_light_points"), "4");
    EXPECT_EQ(host().text("pt_preset"), "fast");
    const auto next_frame = [&] { host().frame([](const ModuleFunctions&) {}); };
    host().set("pt_light_points", "2");
    next_frame();
    EXPECT_EQ(host().text("pt_preset"), "") << "none is in force";
    host().set("pt_preset", "none");
    next_frame();
    next_frame();
    EXPECT_EQ(host().count("pt_preset none: one of paper, fast"), 1);
    EXPECT_EQ(host().text("pt_preset"), "");
    EXPECT_EQ(host().text("pt_light_points"), "2");
    host().set("pt_preset", "accurate");
    next_frame();
    EXPECT_EQ(host().text("pt_spp"), "4");
    EXPECT_EQ(host().text("pt_preset"), "accurate");
}

TEST_F(ModuleTest, CommandsTellOfTheRenderer) {
    begin();
    for (const char* command :
         {"scene", "guiding", "vlcinfo", "cdqinfo", "passes", "guidingreset"}) {
        EXPECT_TRUE(host().has_command(command));
        host().run({command});
    }
    EXPECT_EQ(host().count("no level is loaded"), 6);
    module().begin_registration("rooms");
    for (int i = 0; i < 3; ++i)
        show(view());
    const size_t before = host().lines.size();
    host().run({"scene"});
    host().run({"passes"});
    EXPECT_GT(host().lines.size(), before + 10);
    EXPECT_EQ(host().count("primary"), 1);
    module().shutdown();
    EXPECT_FALSE(host().has_command("scene"));
    EXPECT_EQ(module().register_model("models/box/tris.md2"), nullptr) << "and nothing happens";
    show(view());
}

TEST_F(ModuleTest, TimedDemosLeaveTheirTimes) {
    begin();
    const ScratchFolder scratch;
    host().folder = scratch.path().string();
    host().set("timedemo", "1");
    const auto play = [&](const std::string& file) {
        host().set("vigil_timedemo_json", file);
        module().begin_registration("rooms");
        host().frame([](const ModuleFunctions&) {}); // shows no level: it does not count
        for (int i = 0; i < 3; ++i)
            show(view());
        module().begin_registration("rooms"); // the next one
    };
    play("times.json");
    EXPECT_EQ(host().count("milliseconds over 3 frames"), 1);
    std::ifstream file(scratch.path() / "times.json");
    const std::string text(std::istreambuf_iterator<char>(file), {});
    for (const char* part :
         {"\"level\": \"rooms\"", "\"frames\": 3", "\"pt_nee\": \"sll\"", "\"primary\""})
        EXPECT_NE(text.find(part), std::string::npos) << part;
    play("../out.json");
    play("autoexec.cfg");
    EXPECT_FALSE(std::filesystem::exists(scratch.path().parent_path() / "out.json"));
    EXPECT_FALSE(std::filesystem::exists(scratch.path() / "autoexec.cfg"));
    EXPECT_EQ(host().count("warning"), 2);
}

/// Bytes of this process in memory.
double resident_mib() {
    std::ifstream file("/proc/self/statm");
    double pages = 0.0, resident = 0.0;
    file >> pages >> resident;
    return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1048576.0;
}

TEST_F(ModuleTest, TwentyLevelsKeepMemorySteady) {
    begin();
    double early = 0.0;
    for (int i = 0; i < 20; ++i) {
        module().begin_registration(i % 2 == 0 ? "rooms" : "lamp");
        ViewEntity box{};
        box.model = module().register_model("models/box/tris.md2");
        box.skin = module().register_skin("models/box/skin.pcx");
        std::ranges::copy(std::array{320.0f, 60.0f, 80.0f}, box.origin);
        EngineView seen = view();
        seen.entity_count = 1;
        seen.entities = &box;
        show(seen);
        show(seen);
        if (i == 5) early = resident_mib();
    }
    EXPECT_EQ(host().count("warning"), 0);
    EXPECT_EQ(host().count("error"), 0);
    if (host().count("Mesa 22.") > 0) GTEST_SKIP() << "Mesa 22 loses about 4 MB a frame";
#ifdef VIGIL_SANITIZED
    RecordProperty("resident_MiB_at_level_6", std::to_string(early)); // what is freed stays a while
#else
    EXPECT_LT(resident_mib(), early + 8.0);
#endif
}

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
