// SPDX-License-Identifier: GPL-2.0-or-later
// Levels pay only for what they have, and lose nothing by it: code for a feature that a level lacks
// changes no pixel. Also what a player does while the program runs: other sizes, other techniques,
// lights that come and go, levels without any light.
#include "common/error.h"
#include "render_test.h"

#include <cmath>
#include <fmt/format.h>
#include <iostream>
#include <map>

namespace vigil::test {
namespace {

class Features : public RenderTest {
protected:
    static void expect_reported(const vkpt::SceneFeatures& features) {
        const refresh::SceneReport report = renderer().report_scene(cvars().values());
        const std::map<std::string, bool> expected = {
            {"lights", features.lights},
            {"sky", features.sky},
            {"sun", renderer().scene()->has_sun()},
            {"sky as light", features.environment},
            {"translucency", features.translucent},
            {"gloss", features.gloss},
            {"liquids", false},
            {"animation", false},
            {"instances", features.instances},
            {"effects", features.effects},
            {"light caches", renderer().technique()->uses_guiding()}};
        std::map<std::string, bool> reported;
        for (const refresh::SceneReport::Feature& feature : report.features) {
            reported[feature.name] = feature.on;
            if (feature.count) {
                EXPECT_EQ(feature.on, *feature.count > 0) << feature.name;
            }
        }
        EXPECT_EQ(reported, expected);
    }
};

TEST_F(Features, AreOnWhereTheLevelHasThem) {
    struct Row {
        const char* level;
        Shot shot;
        vkpt::SceneFeatures features;
        const char* env_nee = "1";
    };
    vkpt::SceneFeatures lights, windows, sky, sky_by_rays;
    lights.lights = true;
    windows.lights = windows.translucent = true;
    sky_by_rays.sky = true;
    sky = sky_by_rays;
    sky.lights = sky.environment = true;
    const Row rows[] = {
        {"lamp", {{{-192, 0, 64}, {20, 0, 0}, 90}, {}, {}, 0}, lights},
        {"rooms", {{{420, 40, 90}, {0, 50, 0}, 90}, {}, {}, 0}, windows},
        {"opensky", {{{-192, -64, 56}, {0, 20, 0}, 90}, {}, {}, 0}, sky},
        {"opensky", {{{-192, -64, 56}, {0, 20, 0}, 90}, {}, {}, 0}, sky_by_rays, "0"},
    };
    for (const Row& row : rows) {
        SCOPED_TRACE(fmt::format("{}, pt_env_nee {}", row.level, row.env_nee));
        set("pt_env_nee", row.env_nee);
        load(row.level);
        radiance(row.shot);
        EXPECT_EQ(renderer().scene()->features(), row.features);
        expect_reported(row.features);
        // Compiled with everything, the same level gives the same picture but for rounding, which
        // may turn a few paths at edges. Lights stay as they are: they draw random numbers; and
        // sky and sun are lights or not.
        vkpt::SceneFeatures everything;
        for (const vkpt::SceneFeatureRow& feature : vkpt::scene_feature_rows)
            everything.*feature.member = true;
        everything.lights = row.features.lights;
        everything.environment = row.features.environment || !row.features.sky;
        const auto trace_with = [&](const vkpt::SceneFeatures& features) {
            return trace(params(row.shot), {Technique::sll, features, false, renderer().guide()}, 8,
                         features.lights);
        };
        const std::vector<float> lean = trace_with(row.features), full = trace_with(everything);
        size_t differing = 0;
        double brightness = 0.0;
        for (size_t i = 0; i < lean.size(); ++i) {
            differing += std::abs(lean[i] - full[i]) > 1e-4f * std::abs(lean[i]) + 1e-6f ? 1 : 0;
            brightness += static_cast<double>(lean[i]);
        }
        std::cout << fmt::format("{}: {} of {} values differ\n", row.level, differing, lean.size());
        EXPECT_LT(differing, lean.size() / 200);
        EXPECT_GT(brightness, 0.0);
    }
}

TEST_F(Features, AreCompiledAsAskedFor) {
    const auto compiled = [&](std::string_view choice) {
        set("pt_features", choice);
        return renderer().scene()->compiled_features(cvars().values());
    };
    load("opensky");
    EXPECT_EQ(compiled("auto"), renderer().scene()->features());
    for (const vkpt::SceneFeatureRow& row : vkpt::scene_feature_rows) {
        vkpt::SceneFeatures expected = renderer().scene()->features();
        expected.*row.member = true;
        EXPECT_EQ(compiled(row.name), expected) << row.name;
        EXPECT_TRUE(compiled("all").*row.member) << row.name;
    }
    // Sky and sun become lights by pt_env_nee alone.
    set("pt_env_nee", "0");
    load("opensky");
    EXPECT_FALSE(compiled("all").environment);
    EXPECT_FALSE(compiled("environment").environment);
}

TEST_F(Features, SwitchOnWithWhatAppears) {
    load("rooms");
    Shot shot;
    shot.view = {{40, 40, 60}, {0, 35, 0}, 90};
    radiance(shot);
    EXPECT_FALSE(renderer().scene()->features().instances);
    shot.dynamic_lights = {{1, {120, 120, 60}, 6.0f, {5, 5, 5}}};
    radiance(shot);
    EXPECT_TRUE(renderer().scene()->features().instances);
    expect_reported(renderer().scene()->features());
    shot.dynamic_lights.clear();
    radiance(shot);
    EXPECT_FALSE(renderer().scene()->features().instances);
}

/// A level where no face emits.
void put_out(Level& level) {
    for (BspTexInfo& info : level.bsp.texinfos)
        info.value = 0;
}

TEST_F(Features, WithoutLightEverythingIsBlack) {
    load("lamp", put_out);
    Shot shot;
    shot.view = {{-192, 0, 64}, {20, 0, 0}, 90};
    for (const TechniqueInfo& info : technique_infos) {
        set("pt_nee", info.name);
        for (const float value : radiance(shot).rgb)
            ASSERT_EQ(value, 0.0f) << info.name;
        for (const uint8_t byte : renderer().read_picture(true).rgba)
            ASSERT_TRUE(byte == 0 || byte == 255);
        EXPECT_FALSE(renderer().scene()->features().lights);
        expect_reported(renderer().scene()->features());
    }
    // The first light of all is a dynamic one.
    shot.dynamic_lights = {{1, {0, 0, 60}, 6.0f, {50, 50, 50}}};
    for (const TechniqueInfo& info : technique_infos) {
        set("pt_nee", info.name);
        set("pt_spp", "64");
        double sum = 0.0;
        for (const float value : radiance(shot).rgb)
            sum += static_cast<double>(value);
        EXPECT_GT(sum, 0.0) << info.name;
        EXPECT_TRUE(renderer().scene()->features().lights);
        expect_reported(renderer().scene()->features());
    }
}

TEST_F(Features, CachesAreMadeWhereLightIsOutOfSight) {
    load("lamp");
    Shot shot;
    shot.view = {{-192, 0, 64}, {20, 0, 0}, 90};
    const auto has_caches = [&] {
        radiance(shot);
        const bool on = renderer().technique()->uses_guiding();
        EXPECT_EQ(renderer().compiled_features().caches, on);
        EXPECT_EQ(renderer().report_guiding().on, on);
        expect_reported(renderer().scene()->features());
        return on;
    };
    set("pt_nee", "vlc");
    EXPECT_TRUE(has_caches()) << "pt_vlc_enough 0";
    set("pt_vlc_enough", "0.5");
    EXPECT_FALSE(has_caches()) << "every lamp is in sight";
    set("pt_features", "caches");
    EXPECT_TRUE(has_caches());
    set("pt_features", "auto");
    for (uint32_t id = 1; id <= 40; ++id)
        shot.dynamic_lights.push_back(
            {id, {-110.0f + 5.0f * static_cast<float>(id), 0, 60}, 2.0f, {5, 5, 5}});
    EXPECT_FALSE(has_caches()) << "cuts hold any number of lights";
    shot.dynamic_lights.clear();

    // A lamp that is off may be switched on later: it counts as if it were lit.
    load("rooms");
    set("pt_vlc_enough", "1");
    EXPECT_TRUE(has_caches()) << "lamps behind walls";
    shot.dark_styles = {0};
    load("rooms");
    EXPECT_TRUE(has_caches());
    set("pt_vlc_enough", "0.5");

    load("opensky");
    EXPECT_TRUE(has_caches()) << "the sun is not asked whether it is in sight";
    load("opensky", [](Level& level) { level.bsp.entities[0].set("_sun_light", "0"); });
    EXPECT_FALSE(has_caches()) << "windows to the sky are";
}

TEST_F(Features, CutsAloneHaveTheSameMean) {
    load("rooms");
    Shot shot;
    shot.view = {{420, 40, 90}, {0, 50, 0}, 90};
    const PictureBatches expected = batches(shot, 8, 64, 100, 8);
    set("pt_nee", "vlc");
    set("pt_vlc_enough", "0.01");
    for (const char* guide : {"brdf", "cdq"}) {
        set("pt_guide", guide);
        const PictureBatches seen = batches(shot, 8, 64, 200, 8);
        EXPECT_FALSE(renderer().technique()->uses_guiding());
        judge(fmt::format("cuts alone, {}", guide), seen, expected, {0.015});
    }
}

TEST_F(Features, SizesChangeBetweenFrames) {
    load("lamp");
    Shot shot;
    shot.view = {{-192, 0, 64}, {20, 0, 0}, 90};
    for (const glm::ivec2 size : {glm::ivec2(16, 16), {97, 33}, {64, 64}, {17, 61}, {48, 32}}) {
        set_size(size.x, size.y);
        const refresh::RadiancePicture seen = radiance(shot);
        EXPECT_EQ(glm::ivec2(seen.width, seen.height), size);
        EXPECT_EQ(seen.rgb.size(), static_cast<size_t>(3 * size.x * size.y));
        const refresh::Picture picture = renderer().read_picture(true);
        EXPECT_EQ(glm::ivec2(picture.width, picture.height), size);
        EXPECT_EQ(picture.rgba, renderer().read_picture(false).rgba)
            << "without an overlay both are the same";
    }
}

TEST_F(Features, AnotherTechniqueEveryFrame) {
    load("lamp");
    Shot shot;
    shot.view = {{-192, 0, 64}, {40, 0, 0}, 80};
    constexpr int frames = 16;
    set("pt_spp", "16");
    std::vector<PictureBatches> switching(std::size(technique_infos), PictureBatches(48, 32, 8));
    for (int frame = 0; frame < frames; ++frame) {
        for (size_t technique = 0; technique < switching.size(); ++technique) {
            set("pt_nee", std::to_string(technique)); // by number
            set("pt_spp", technique_infos[technique].name == "brute" ? "64" : "16");
            set("pt_seed", std::to_string(frame));
            switching[technique].add(radiance(shot).rgb);
        }
    }
    set("pt_nee", "uniform");
    const PictureBatches steady = batches(shot, frames, 16, 200, 8);
    for (size_t technique = 0; technique < switching.size(); ++technique) {
        const bool brute = technique_infos[technique].name == "brute";
        judge(technique_infos[technique].name, switching[technique], steady,
              brute ? Bounds{0.05, 0.2, 0.4} : Bounds{0.015});
    }
}

TEST_F(Features, LightsComeAndGo) {
    load("lamp", put_out);
    Shot shot;
    shot.view = {{-192, 0, 64}, {40, 0, 0}, 80};
    for (const std::string_view technique : {"sll", "uniform"}) {
        set("pt_nee", technique);
        for (const uint32_t count : {1u, 200u, 3u, 0u, 199u, 50u}) {
            shot.dynamic_lights.clear();
            for (uint32_t id = 0; id < count; ++id) {
                const float angle = 0.3f * static_cast<float>(id);
                shot.dynamic_lights.push_back(
                    {1000 + id,
                     {-100.0f + 60.0f * std::cos(angle), 60.0f * std::sin(angle), 40.0f},
                     1.0f,
                     {9, 9, 9}});
            }
            double sum = 0.0;
            for (const float value : radiance(shot).rgb)
                sum += static_cast<double>(value);
            EXPECT_EQ(sum > 0.0, count > 0) << technique << " with " << count;
        }
        EXPECT_LE(renderer().scene()->lights().lights().size(),
                  200u * vkpt::dynamic_light_triangles + 2);
    }
}

TEST_F(Features, ABrokenLevelOrModelLeavesTheOneBefore) {
    load("lamp");
    Shot shot;
    shot.view = {{-192, 0, 64}, {20, 0, 0}, 90};
    const auto picture = [&] {
        renderer().render(shot.frame());
        return trace(params(shot), 4);
    };
    const std::vector<float> before = picture();
    EXPECT_GT(sum_of(before), 0.0);
    for (const char* name : {"*7", "*", "models/none.md2", "models/none.glb"}) {
        EXPECT_THROW(renderer().register_model(name), Error) << name;
        EXPECT_EQ(picture(), before) << name;
    }
    // A level that no buffer of the device can hold, where that takes less than 2 GiB here.
    const uint64_t nodes =
        renderer().device().features().max_storage_buffer_bytes / sizeof(shader::BspTreeNode) + 1;
    if (nodes < 30'000'000) {
        EXPECT_THROW(
            load("rooms",
                 [&](Level& level) { level.bsp.nodes.resize(nodes, level.bsp.nodes.front()); }),
            Error);
        EXPECT_EQ(picture(), before);
    }
    EXPECT_EQ(renderer().report_scene(cvars().values()).level, "lamp");
}

} // namespace
} // namespace vigil::test
