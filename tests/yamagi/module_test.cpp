// SPDX-License-Identifier: GPL-2.0-or-later
// The module as an engine sees it, by the calls of every API version: pictures that are not black,
// 2D in its place, and levels that change.
#include "common/scratch_folder.h"
#include "module_fixture.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <glm/trigonometric.hpp>
#include <iterator>
#include <unistd.h>

namespace vigil::test {
namespace {

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

TEST_F(ModuleTest, PresetsSetTheirVariablesAndThoseEndPresets) {
    start();
    ASSERT_EQ(module().init(), 1);
    const auto next_frame = [&] { host().frame([](const ModuleFunctions&) {}); };
    EXPECT_EQ(host().text("pt_preset"), "custom") << "the tests' own settings";
    host().set("pt_preset", "fast");
    next_frame();
    EXPECT_EQ(host().text("pt_nee"), "vlc");
    EXPECT_EQ(host().text("pt_light_points"), "4");
    host().set("pt_preset", "none");
    next_frame();
    EXPECT_EQ(host().text("pt_preset"), "fast");
    EXPECT_EQ(host().count("pt_preset: \"none\" is none of paper|fast"), 1);
    host().set("pt_light_points", "16");
    next_frame();
    EXPECT_EQ(host().text("pt_preset"), "custom");
    host().set("pt_preset", "accurate");
    host().set("pt_spp", "2"); // both in one frame: the one that says more
    next_frame();
    EXPECT_EQ(host().text("pt_spp"), "2");
    EXPECT_EQ(host().text("pt_guide"), "cdq");
    EXPECT_EQ(host().text("pt_preset"), "custom");
    host().set("pt_spp", "4");
    next_frame();
    EXPECT_EQ(host().text("pt_preset"), "accurate");
}

TEST_F(ModuleTest, PresetsComeBackAtTheNextStart) {
    // What the engine's configuration and command line have set before the module is there.
    struct Start {
        std::vector<std::pair<std::string, std::string>> set;
        std::string preset, spp, points;
    };
    const std::vector<std::pair<std::string, std::string>> accurate = {
        {"pt_nee", "vlc"},         {"pt_guide", "cdq"},       {"vigil_preset_kept", "accurate"},
        {"pt_light_points", "16"}, {"pt_preset", "accurate"}, {"pt_spp", "4"}};
    std::vector<std::pair<std::string, std::string>> custom = accurate;
    custom[2].second = custom[4].second = "custom";
    custom[5].second = "7";
    const auto with = [](auto all, const std::string& name, const std::string& value) {
        all.emplace_back(name, value);
        return all;
    };
    const Start starts[] = {
        {accurate, "accurate", "4", "16"},
        {with(accurate, "pt_preset", "fast"), "fast", "1", "4"},
        {with(accurate, "pt_spp", "2"), "custom", "2", "16"},
        {with(accurate, "pt_light_points", "8"), "custom", "4", "8"}, // the default
        {with(with(accurate, "pt_preset", "fast"), "pt_spp", "2"), "custom", "2", "4"},
        {custom, "custom", "7", "16"},
        {with(custom, "pt_spp", "9"), "custom", "9", "16"},
        {with(custom, "pt_preset", "fast"), "fast", "1", "4"},
    };
    for (const Start& one : starts) {
        start();
        for (const auto& [name, value] : one.set)
            host().set(name, value);
        ASSERT_EQ(module().init(), 1);
        EXPECT_EQ(host().text("pt_preset"), one.preset);
        EXPECT_EQ(host().text("vigil_preset_kept"), one.preset);
        EXPECT_EQ(host().text("pt_spp"), one.spp) << one.preset;
        EXPECT_EQ(host().text("pt_light_points"), one.points) << one.preset;
        module().shutdown();
    }
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

} // namespace
} // namespace vigil::test
