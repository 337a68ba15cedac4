// SPDX-License-Identifier: GPL-2.0-or-later
// Demos in the whole program, without a GPU: recording, playing with the time and as a measurement,
// damage, and what effects become.
#include "client/demo/effects.h"
#include "client/demo/player.h"
#include "client/demo/recorder.h"
#include "client/demo/route.h"
#include "console/cvar.h"
#include "fake_renderer.h"
#include "formats/dm2_protocol.h"
#include "formats/real_levels.h"
#include "program_run.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

namespace vigil::client {
namespace {

class DemoTest : public ProgramRun {
protected:
    int run(const std::string& text) {
        render_ = {};
        return run_program_on(
            game_.basedir(), text,
            [this](FileSystem&, refresh::SurfaceProvider*, const refresh::Settings&) {
                return std::make_unique<FakeRenderer>(render_);
            });
    }

    void write_demo(std::string_view name, const std::vector<uint8_t>& bytes) {
        game_.write("data/baseq2/demos/" + std::string(name),
                    {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    }
    std::vector<uint8_t> read_demo(std::string_view name) {
        const std::string text = game_.read(name);
        return {text.begin(), text.end()};
    }

    RenderLog render_; // of the last run
};

/// A demo of the level "tiny" whose frames the caller fills.
class SmallDemo {
public:
    explicit SmallDemo(std::string_view map = "maps/tiny.bsp") {
        dm2::ServerData data;
        data.level_title = "Small";
        writer_.add(data);
        writer_.add(dm2::ConfigString{dm2::CS_MODELS + 1, std::string(map)});
        writer_.add(dm2::ConfigString{dm2::CS_MODELS + 2, "*1"});
        writer_.add(dm2::ConfigString{dm2::CS_MODELS + 3, "models/box/tris.md2"});
        writer_.add(dm2::ConfigString{dm2::CS_MODELS + 4, "models/gone/tris.md2"});
        writer_.add(dm2::ConfigString{dm2::CS_LIGHTS, "z"});
        writer_.end_block();
        frame_.player.fov = 90;
        frame_.player.view_offset = {0, 0, 22};
    }
    dm2::Frame& frame() { return frame_; }
    void add(const dm2::Message& message) { writer_.add(message); }
    /// Ends this tenth of a second.
    void next() {
        ++frame_.number;
        writer_.add(frame_);
        writer_.end_block();
    }
    std::vector<uint8_t> bytes() { return writer_.finish(); }

private:
    dm2::Writer writer_;
    dm2::Frame frame_;
};

dm2::EntityState entity(uint32_t number, uint8_t model, const glm::vec3& origin) {
    dm2::EntityState state;
    state.number = number;
    state.models[0] = model;
    state.origin = state.old_origin = origin;
    return state;
}

TEST_F(DemoTest, ARouteIsRecordedAndPlayedTheSameEachTime) {
    ASSERT_EQ(run("+map tiny +turn lamp 45 +lightstyle 3 mmaa +record line line"), 0) << errors_;
    EXPECT_EQ(render_.count("render"), 0u); // recording a route renders nothing
    ASSERT_TRUE(game_.exists("out/demos/line.dm2"));
    EXPECT_NE(output_.find("line.dm2 (6 frames"), std::string::npos) << output_;

    ASSERT_EQ(run("+set timedemo 2 +set timedemo_json t.json +demomap line p 1 +quit"), 0)
        << errors_;
    // Both times the level is loaded, and every frame rendered once.
    EXPECT_EQ(render_.count("map tiny"), 2u);
    ASSERT_EQ(render_.views.size(), 12u);
    for (size_t i = 0; i < 6; ++i) {
        EXPECT_EQ(render_.views[i].origin, render_.views[i + 6].origin);
        EXPECT_EQ(render_.times[i], render_.times[i + 6]);
        EXPECT_NEAR(render_.times[i], 0.1 * static_cast<double>(i), 1e-9);
    }
    // The view is the route's to an eighth of a unit and 360/65536 degrees.
    EXPECT_NEAR(render_.views[5].origin.x, 100.0f, 1.0f / 16);
    EXPECT_NEAR(render_.views[5].origin.z, 10.0f, 1.0f / 16);
    EXPECT_NEAR(render_.views[5].angles.y, 90.0f, 0.003f);
    EXPECT_EQ(render_.views[0].fov, 90.0f);
    // The brush model was turned, and not moved.
    ASSERT_EQ(render_.entities.size(), 1u);
    EXPECT_EQ(render_.entities[0].origin, glm::vec3(1, 2, 3));
    EXPECT_NEAR(render_.entities[0].angles.y, 45.0f, 360.0f / 512);
    EXPECT_NE(output_.find("6 frames, "), std::string::npos);
    EXPECT_NE(output_.find("all 2 together: 12 frames"), std::string::npos);
    EXPECT_TRUE(game_.exists("out/p_000.png"));
    EXPECT_TRUE(game_.exists("out/p_011.png"));

    const auto report = nlohmann::json::parse(game_.read("out/t.json"));
    EXPECT_EQ(report["demo"], "line");
    EXPECT_EQ(report["frame_count"], 12);
    EXPECT_EQ(report["frames"].size(), 12u);
    EXPECT_EQ(report["repetitions"].size(), 2u);
    EXPECT_EQ(report["repetitions"][1]["frame_count"], 6);
    EXPECT_EQ(report["device"], "a fake device");
    EXPECT_EQ(report["variables"]["timedemo"], "2");
    // Path tracing by technique: here of one pass, preparation did not run.
    ASSERT_EQ(report["groups"].size(), 1u);
    EXPECT_EQ(report["groups"][0]["name"], "path tracing, vlc + cdq");
    EXPECT_EQ(report["groups"][0]["mean_ms"], 1.0);
    EXPECT_EQ(report["groups"][0]["share"], 0.25);
    EXPECT_FALSE(report["commit"].get<std::string>().empty());
    for (const auto& frame : report["frames"])
        EXPECT_EQ(frame["passes_ms"]["primary"], 1.0);
}

TEST_F(DemoTest, FlightIsRecordedTenTimesASecond) {
    ASSERT_EQ(run("+map tiny +record free +wait 30 +setviewpos 5 6 7 0 10 0 +wait 31 +stop"), 0)
        << errors_;
    ASSERT_EQ(run("+set timedemo 1 +demomap free.dm2 +quit"), 0) << errors_;
    // 61 frames of 1/60 s begin eleven tenths of a second.
    ASSERT_EQ(render_.views.size(), 11u);
    EXPECT_EQ(render_.views[0].origin, glm::vec3(32, 32, 46));
    EXPECT_EQ(render_.views[10].origin, glm::vec3(5, 6, 7));
    // The end of the program, or another level, ends a recording too.
    ASSERT_EQ(run("+map tiny +record quit +wait 20 +quit"), 0) << errors_;
    EXPECT_TRUE(game_.exists("out/demos/quit.dm2"));
    ASSERT_EQ(run("+map tiny +record other +wait 20 +map tiny +wait 2 +quit"), 0) << errors_;
    EXPECT_TRUE(game_.exists("out/demos/other.dm2"));
}

TEST_F(DemoTest, PlaysWithTheTimeAndBetweenFrames) {
    SmallDemo demo;
    demo.frame().entities = {entity(2, 2, {0, 0, 0})};
    demo.next();
    demo.frame().player.origin.x = 60;
    demo.frame().player.view_angles.y = -170;
    demo.frame().entities = {entity(2, 2, {6, 0, 0})};
    demo.next();
    demo.frame().player.origin.x = 1000; // too far: a jump
    demo.frame().player.view_angles.y = 170;
    demo.next();
    write_demo("small.dm2", demo.bytes());
    ASSERT_EQ(run("+demomap small"), 0) << errors_;
    // Without anything that waits, the program ends with the demo: 0.2 s of 1/60 s each, and the
    // first frame.
    ASSERT_GE(render_.views.size(), 13u);
    EXPECT_LE(render_.views.size(), 14u);
    for (size_t i = 0; i <= 6; ++i)
        EXPECT_NEAR(render_.views[i].origin.x, 10.0f * static_cast<float>(i), 0.01f) << i;
    EXPECT_EQ(render_.views[8].origin.x, 1000.0f);
    EXPECT_EQ(render_.views[0].origin.z, 22.0f);
    // From -170 to 170 degrees the short way; a jump of the place does turn at once.
    EXPECT_NEAR(render_.views[3].angles.y, -85.0f, 0.01f);
    EXPECT_EQ(render_.style_0.back(), 25.0f / 12.0f);
    EXPECT_NE(output_.find("Small"), std::string::npos);
    EXPECT_NE(output_.find("3 frames played"), std::string::npos);
}

TEST_F(DemoTest, ADemoMayGoOnInAnotherLevel) {
    game_.write_level_file("next", tiny_entities);
    SmallDemo demo;
    demo.frame().entities = {entity(3, 3, {0, 0, 0})};
    demo.next();
    demo.next();
    dm2::ServerData data;
    data.level_title = "Next";
    demo.add(data);
    demo.add(dm2::ConfigString{dm2::CS_MODELS + 1, "maps/next.bsp"});
    demo.add(dm2::ConfigString{dm2::CS_MODELS + 2, "models/other/tris.md2"});
    demo.frame().number = 0;
    demo.frame().entities = {entity(3, 2, {0, 0, 0})};
    demo.next();
    demo.next();
    write_demo("two.dm2", demo.bytes());
    ASSERT_EQ(run("+set timedemo 1 +set timedemo_json t.json +demomap two"), 0) << errors_;
    EXPECT_EQ(render_.calls, (std::vector<std::string>{"map tiny", "render", "render", "map next",
                                                       "render", "render"}));
    EXPECT_EQ(render_.models.back(), "models/other/tris.md2");
    const auto report = nlohmann::json::parse(game_.read("out/t.json"));
    for (const auto& frame : report["frames"])
        EXPECT_EQ(frame["passes_ms"]["primary"], 1.0);
    ASSERT_EQ(run("+demomap two"), 0) << errors_; // with the time, too
    EXPECT_EQ(render_.count("map next"), 1u);
}

TEST_F(DemoTest, WhatIsNotThereIsSaidOnce) {
    render_.broken_models.insert("models/gone/tris.md2");
    SmallDemo demo;
    for (int i = 0; i < 4; ++i) {
        demo.frame().entities = {entity(3, 4, {0, 0, 0}), entity(4, 3, {0, 0, 0})};
        demo.next();
    }
    write_demo("small.dm2", demo.bytes());
    RenderLog broken;
    broken.broken_models.insert("models/gone/tris.md2");
    FakeRenderer renderer(broken);
    FileSystem files;
    files.mount_game(game_.basedir(), "baseq2");
    Session session(files, renderer, cvars());
    DemoPlayer player("demos/small.dm2", read_demo("data/baseq2/demos/small.dm2"));
    player.start(session);
    while (!player.at_last_frame())
        player.step(session);
    EXPECT_EQ(session.played()->entities.size(), 1u);
    const size_t first = output_.find("models/gone/tris.md2");
    ASSERT_NE(first, std::string::npos);
    EXPECT_EQ(output_.find("models/gone/tris.md2", first + 1), std::string::npos);
}

TEST_F(DemoTest, EffectsShineAndVanish) {
    SmallDemo demo;
    dm2::EntityState rocket = entity(5, 3, {0, 0, 100});
    rocket.effects = dm2::EF_ROCKET;
    dm2::EntityState beam = entity(6, 0, {0, 0, 0});
    beam.models = {1, 0, 0, 0};
    beam.old_origin = {0, 0, 64};
    beam.render_flags = dm2::RF_BEAM;
    beam.frame = 4;
    beam.skin = 0xf2f2f0f0;
    demo.frame().entities = {entity(1, 255, {0, 0, 0}), rocket, beam};
    demo.next();
    dm2::TempEntity boom;
    boom.type = dm2::TE_ROCKET_EXPLOSION;
    boom.place = {10, 20, 30};
    demo.frame().entities = {entity(1, 255, {0, 0, 0}), beam};
    demo.add(boom);
    demo.add(dm2::MuzzleFlash{1, 7, false, false});
    demo.next();
    for (int i = 0; i < 20; ++i)
        demo.next();
    const std::vector<uint8_t> bytes = demo.bytes();

    FakeRenderer renderer(render_);
    FileSystem files;
    files.mount_game(game_.basedir(), "baseq2");
    Session session(files, renderer, cvars());
    DemoPlayer player("demos/small.dm2", bytes);
    player.start(session);
    const PlayedScene* scene = session.played();
    ASSERT_NE(scene, nullptr);
    ASSERT_EQ(scene->dynamic_lights.size(), 1u);
    const refresh::DynamicLight first = scene->dynamic_lights[0];
    EXPECT_EQ(first.origin, glm::vec3(0, 0, 100));
    EXPECT_EQ(first.radius, 8.0f); // a light of 200
    EXPECT_EQ(first.radiance.z, 0.0f);
    EXPECT_EQ(first.radiance.x, first.radiance.y);
    ASSERT_EQ(scene->beams.size(), 1u);
    EXPECT_EQ(scene->beams[0].radius, 2.0f);
    EXPECT_EQ(scene->beams[0].to, glm::vec3(0, 0, 64));
    EXPECT_EQ(scene->entities.size(), 1u); // the rocket, not whose eyes we see through
    player.step(session);
    // The explosion and the flash; the rocket is gone.
    scene = session.played();
    ASSERT_EQ(scene->dynamic_lights.size(), 2u);
    EXPECT_EQ(scene->dynamic_lights[0].origin, glm::vec3(10, 20, 30));
    EXPECT_EQ(scene->dynamic_lights[1].origin, glm::vec3(18, -16, 0));
    EXPECT_GT(scene->particles.size(), 100u);
    float last = scene->dynamic_lights[0].radius;
    player.step(session);
    scene = session.played();
    ASSERT_EQ(scene->dynamic_lights.size(), 1u); // a flash lasts a tenth of a second
    EXPECT_LT(scene->dynamic_lights[0].radius, last);
    while (!player.at_last_frame())
        player.step(session);
    scene = session.played();
    EXPECT_TRUE(scene->dynamic_lights.empty());
    EXPECT_TRUE(scene->particles.empty());
    EXPECT_EQ(scene->beams.size(), 1u);
}

TEST_F(DemoTest, ADamagedDemoPlaysWhatIsIntact) {
    ASSERT_EQ(run("+map tiny +record whole line"), 0) << errors_;
    std::vector<uint8_t> bytes = read_demo("out/demos/whole.dm2");
    bytes.resize(bytes.size() - 6); // into the last frame's block
    write_demo("cut.dm2", bytes);
    EXPECT_EQ(run("+set timedemo 3 +demomap cut +quit"), 1);
    EXPECT_EQ(render_.count("render"), 5u); // once: it will not get better
    EXPECT_NE(errors_.find("demos/cut.dm2: byte "), std::string::npos) << errors_;
    EXPECT_NE(errors_.find("cut off"), std::string::npos) << errors_;
    EXPECT_NE(errors_.find("after 5 frames"), std::string::npos) << errors_;
    EXPECT_NE(output_.find("5 frames, "), std::string::npos) << output_;

    errors_.clear();
    EXPECT_EQ(run("+demomap cut"), 1); // with the time, too
    EXPECT_NE(errors_.find("cut off"), std::string::npos) << errors_;
    EXPECT_NEAR(render_.views.back().origin.x, 80.0f, 20.0f);
}

TEST_F(DemoTest, WhatCannotBePlayedEndsWithOneMessage) {
    SmallDemo nowhere("maps/nowhere.bsp");
    nowhere.next();
    write_demo("nowhere.dm2", nowhere.bytes());
    SmallDemo empty;
    write_demo("empty.dm2", empty.bytes());
    SmallDemo other;
    other.next();
    std::vector<uint8_t> bytes = other.bytes();
    bytes[5] = 26;
    write_demo("other.dm2", bytes);
    SmallDemo outside("maps/../../../etc/passwd");
    outside.next();
    write_demo("outside.dm2", outside.bytes());
    game_.write("data/baseq2/demos/text.dm2", "this is no demo");

    const auto fault = [this](const std::string& words, std::string_view part) {
        errors_.clear();
        EXPECT_EQ(run(words + " +wait 1"), 1) << words;
        EXPECT_NE(errors_.find(part), std::string::npos) << words << ": " << errors_;
        EXPECT_EQ(std::count(errors_.begin(), errors_.end(), '\n'), 1) << errors_;
    };
    fault("+demomap nowhere", "demos/nowhere.dm2: its level cannot be shown");
    fault("+demomap nowhere", "maps/nowhere.bsp");
    fault("+demomap empty", "no frame");
    fault("+demomap other", "protocol 26");
    fault("+demomap outside", "its level cannot be shown");
    fault("+demomap text", "demos/text.dm2: byte 0");
    fault("+demomap absent", "there is no demo demos/absent.dm2");
    fault("+demomap ../../x", "is no name of a demo");
    fault("+map tiny +record ../x", "not written, the name goes up");
    fault("+record x", "no level is loaded");
    fault("+map tiny +record x nowhere", "there is no route");
    fault("+stop", "nothing is recorded or played");
    fault("+map tiny +record x +record y", "is being recorded");
}

TEST_F(DemoTest, DamagedDemosNeverCrashThePlayer) {
    SmallDemo demo;
    for (int i = 0; i < 12; ++i) {
        dm2::EntityState state = entity(7, 3, {static_cast<float>(i), 0, 0});
        state.effects = 1u << i | 1u << (i + 12);
        state.frame = static_cast<uint16_t>(i);
        demo.frame().entities = {state};
        dm2::TempEntity effect;
        effect.type = static_cast<uint8_t>(i * 2);
        effect.count = 20;
        demo.add(effect);
        demo.add(dm2::MuzzleFlash{7, static_cast<uint8_t>(i), i % 2 == 0, false});
        demo.next();
    }
    const std::vector<uint8_t> whole = demo.bytes();
    FakeRenderer renderer(render_);
    FileSystem files;
    files.mount_game(game_.basedir(), "baseq2");
    std::mt19937 random(3);
    size_t played = 0;
    for (int round = 0; round < 150; ++round) {
        std::vector<uint8_t> bytes = whole;
        for (int flip = 0; flip < 2; ++flip) {
            uint8_t& byte = bytes[random() % bytes.size()];
            byte = static_cast<uint8_t>(byte ^ 1u << random() % 8);
        }
        Session session(files, renderer, cvars());
        DemoPlayer player("x.dm2", bytes);
        try {
            player.start(session);
            for (int step = 0; step < 400 && !player.finished(); ++step)
                player.advance(1.0 / 60.0, session);
            ++played;
        } catch (const Error& error) {
            EXPECT_TRUE(std::string_view(error.what()).starts_with("x.dm2")) << error.what();
        }
    }
    EXPECT_GT(played, 20u);
}

TEST_F(DemoTest, LightsAndStylesGoIntoDemos) {
    ASSERT_EQ(run("+map tiny +lightstyle 40 0.5 +dlight 1 1 2 3 4 9 0 0 +record lit +wait 8 "
                  "+lightstyle 41 az +wait 8 +stop"),
              0)
        << errors_;
    dm2::File file("lit.dm2", read_demo("out/demos/lit.dm2"));
    dm2::Parser parser("lit.dm2");
    std::vector<dm2::Message> messages;
    while (const auto block = file.next()) {
        EXPECT_LE(block->bytes.size(), dm2::portable_block_bytes);
        parser.parse(*block, messages);
    }
    std::map<uint32_t, std::string> strings;
    const dm2::Frame* last = nullptr;
    bool precached = false;
    for (const dm2::Message& message : messages) {
        if (const auto* string = std::get_if<dm2::ConfigString>(&message))
            strings[string->index] = string->text;
        if (const auto* frame = std::get_if<dm2::Frame>(&message)) last = frame;
        if (const auto* stuff = std::get_if<dm2::StuffText>(&message))
            precached |= stuff->text == "precache\n";
    }
    EXPECT_TRUE(precached);
    EXPECT_EQ(strings[dm2::CS_MODELS + 1], "maps/tiny.bsp");
    EXPECT_EQ(strings[dm2::CS_MODELS + 2], "*1");
    EXPECT_EQ(strings[dm2::CS_LIGHTS + 1].substr(0, 4), "mmnm");
    EXPECT_EQ(strings[dm2::CS_LIGHTS + 32], "a");
    EXPECT_EQ(strings[dm2::CS_LIGHTS + 40], "g");
    EXPECT_EQ(strings[dm2::CS_LIGHTS + 41], "az");
    ASSERT_NE(last, nullptr);
    ASSERT_EQ(last->entities.size(), 2u);
    EXPECT_EQ(last->entities[1].effects, uint32_t{dm2::EF_FLAG1});
    EXPECT_EQ(last->entities[1].origin, glm::vec3(1, 2, 3));
    EXPECT_EQ(last->player.movement_type, dm2::PM_FREEZE);
}

TEST_F(DemoTest, DemosAreListedAndRecordedOnesComeFirst) {
    SmallDemo demo;
    demo.next();
    write_demo("both.dm2", demo.bytes());
    write_demo("theirs.dm2", demo.bytes());
    ASSERT_EQ(run("+map tiny +record both line +demos"), 0) << errors_;
    EXPECT_NE(output_.find("  both\n"), std::string::npos);
    EXPECT_NE(output_.find("  theirs\n"), std::string::npos);
    EXPECT_NE(output_.find("2 demos"), std::string::npos);
    ASSERT_EQ(run("+set timedemo 1 +demomap both"), 0) << errors_;
    EXPECT_EQ(render_.views.size(), 6u);
    // Game data was not written.
    EXPECT_EQ(read_demo("data/baseq2/demos/both.dm2"), demo.bytes());
}

/// The demos that come with the levels, as docs/play/demos.md says: their routes, recorded.
TEST(ShippedDemos, AreTheRoutesOfTheirLevels) {
    FileSystem files;
    files.mount_game(VIGIL_SOURCE_DIR, "baseq2");
    for (const std::string name : {"warehouse", "mine", "gallery", "ring", "yard", "room"}) {
        const std::string path = "demos/" + name + ".dm2";
        dm2::File file(path, files.read(path));
        dm2::Parser parser(path);
        std::vector<dm2::Message> messages;
        while (const auto block = file.next()) {
            EXPECT_LE(block->bytes.size(), dm2::portable_block_bytes) << path;
            parser.parse(*block, messages);
        }
        const Route route = load_route(files, name);
        int frames = 0;
        for (const dm2::Message& message : messages) {
            if (const auto* string = std::get_if<dm2::ConfigString>(&message)) {
                if (string->index == dm2::CS_MODELS + 1) {
                    EXPECT_EQ(string->text, "maps/" + name + ".bsp");
                }
            }
            const auto* frame = std::get_if<dm2::Frame>(&message);
            if (frame == nullptr) continue;
            const glm::vec3 eye = frame->player.origin + frame->player.view_offset;
            const glm::vec3 wanted = route.at(frames / dm2::frames_per_second).origin;
            EXPECT_LE(glm::length(eye - wanted), 0.125f) << path << ", frame " << frames;
            ++frames;
        }
        EXPECT_EQ(frames, route.frame_count(dm2::frames_per_second)) << path;
    }
}

TEST_F(DemoTest, ARealDemoPlaysToItsEnd) {
    const auto folder = real_levels_folder();
    if (!folder) GTEST_SKIP() << "the real demos are not there";
    // Its level is not there; the small one stands in for it.
    game_.write_level_file("q2rdm2", tiny_entities);
    const Bytes bytes = read_file(*folder / "demos" / "testduel.dm2");
    FakeRenderer renderer(render_);
    FileSystem files;
    files.mount_game(game_.basedir(), "baseq2");
    Session session(files, renderer, cvars());
    DemoPlayer player("demos/testduel.dm2", bytes);
    player.log_texts(false);
    player.start(session);
    std::set<int> drawn;
    size_t most_lights = 0, most_particles = 0, jumps = 0;
    while (!player.at_last_frame()) {
        const glm::vec3 before = session.camera().origin();
        player.step(session);
        jumps += glm::distance(before, session.camera().origin()) > 256.0f ? 1 : 0;
        const PlayedScene& scene = *session.played();
        std::set<int> numbers;
        for (const refresh::Entity& entity : scene.entities) {
            EXPECT_TRUE(numbers.insert(entity.number).second) << entity.number;
            drawn.insert(entity.model);
        }
        std::set<uint32_t> ids;
        for (const refresh::DynamicLight& light : scene.dynamic_lights) {
            EXPECT_TRUE(ids.insert(light.id).second);
            EXPECT_GT(light.radius, 0.0f);
            EXPECT_LT(glm::length(light.origin), 8000.0f);
        }
        most_lights = std::max(most_lights, scene.dynamic_lights.size());
        most_particles = std::max(most_particles, scene.particles.size());
    }
    EXPECT_EQ(player.fault(), "");
    EXPECT_EQ(player.frames(), 3199);
    EXPECT_GT(drawn.size(), 20u);
    EXPECT_GT(most_lights, 3u);
    EXPECT_GT(most_particles, 200u);
    EXPECT_LT(jumps, 40u); // players are born again elsewhere
}

} // namespace
} // namespace vigil::client
