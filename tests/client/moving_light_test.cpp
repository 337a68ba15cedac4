// SPDX-License-Identifier: GPL-2.0-or-later
// Lights that move, appear and go, as the renderer gets them: each under an id of its own that
// stays while it exists, none once it is gone.
#include "client/play/flashlight.h"
#include "client/play/play.h"
#include "client/play/test_lights.h"
#include "fake_renderer.h"
#include "game/view_axes.h"
#include "program_run.h"

#include <glm/glm.hpp>
#include <gtest/gtest.h>

#include <map>
#include <set>

namespace vigil::client {
namespace {

std::map<uint32_t, refresh::DynamicLight> by_id(std::span<const refresh::DynamicLight> lights) {
    std::map<uint32_t, refresh::DynamicLight> found;
    for (const refresh::DynamicLight& light : lights)
        EXPECT_TRUE(found.emplace(light.id, light).second) << "two lights " << light.id;
    return found;
}

/// A level of the game, shown by a renderer that draws nothing.
class MovingLights : public testing::Test {
protected:
    MovingLights() {
        files_.mount_game(std::filesystem::path(VIGIL_SOURCE_DIR), "baseq2");
        session_.load_map("warehouse");
    }
    ~MovingLights() override {
        cvars().set("testlights", "0");
        cvars().set("testlights_speed", "1");
    }
    std::map<uint32_t, refresh::DynamicLight> lights() const {
        return by_id(session_.frame().dynamic_lights);
    }
    RenderLog log_;
    FakeRenderer renderer_{log_};
    FileSystem files_;
    Session session_{files_, renderer_, cvars()};
};

TEST_F(MovingLights, TestLightsKeepTheirIdsAndMove) {
    cvars().set("testlights", "32");
    const auto before = lights();
    ASSERT_EQ(before.size(), 32u);
    std::set<std::array<float, 3>> colors;
    for (const auto& [id, light] : before)
        colors.insert({light.radiance.x, light.radiance.y, light.radiance.z});
    EXPECT_EQ(colors.size(), 32u);
    std::map<uint32_t, refresh::DynamicLight> last = before;
    int moved = 0;
    for (int frame = 0; frame < 120; ++frame) {
        session_.advance(1.0 / 60.0);
        const auto now = lights();
        ASSERT_EQ(now.size(), 32u);
        for (const auto& [id, light] : now) {
            ASSERT_TRUE(last.contains(id));
            EXPECT_EQ(light.radiance, last[id].radiance);
            const float way = glm::distance(light.origin, last[id].origin);
            EXPECT_LT(way, 1.01f * TestLights::speed / 60.0f);
            moved += way > 1.0f ? 1 : 0;
        }
        last = now;
    }
    EXPECT_GT(moved, 31 * 120);
    // Fewer: the others stay as they are. None: all are gone.
    cvars().set("testlights", "5");
    EXPECT_EQ(lights().size(), 5u);
    EXPECT_EQ(lights().begin()->second.origin, last.begin()->second.origin);
    cvars().set("testlights", "0");
    EXPECT_TRUE(lights().empty());
}

TEST_F(MovingLights, TestLightsAreAFunctionOfTheTime) {
    TestLights first(session_.shared_level()), second(session_.shared_level());
    first.at(3, 100.0);
    const auto a = first.at(16, 12.5), b = second.at(16, 12.5);
    for (size_t i = 0; i < a.size(); ++i)
        EXPECT_EQ(a[i].origin, b[i].origin);
    cvars().set("testlights", "1");
    cvars().set("testlights_speed", "0");
    const auto before = lights();
    session_.advance(1.0);
    EXPECT_EQ(lights().begin()->second.origin, before.begin()->second.origin);
}

TEST_F(MovingLights, TestLightsStayInTheOpen) {
    for (const char* name : {"warehouse", "mine", "gallery", "ring", "yard", "room"}) {
        session_.load_map(name);
        TestLights lights(session_.shared_level());
        const CollisionWorld world(session_.level()->bsp);
        for (int second = 0; second < 60; ++second)
            for (const refresh::DynamicLight& light : lights.at(64, second + 0.37))
                EXPECT_TRUE(world.is_free(light.origin,
                                          {glm::vec3(-light.radius), glm::vec3(light.radius)},
                                          mask_player_solid))
                    << name << " light " << light.id;
    }
}

TEST_F(MovingLights, FlashlightFollowsTheEyeAndStaysInsideThePlayer) {
    EXPECT_TRUE(session_.frame().spots.empty());
    session_.set_flashlight(true);
    for (int i = 0; i < 50; ++i) {
        const float t = static_cast<float>(i);
        const glm::vec3 angles(3.0f * t - 75.0f, 47.0f * t, 0.0f);
        const glm::vec3 eye(10.0f * t, -5.0f * t, 60.0f);
        session_.camera().set(eye, angles);
        const auto spots = session_.frame().spots;
        ASSERT_EQ(spots.size(), 1u);
        EXPECT_EQ(spots[0].id, flashlight_id);
        const ViewAxes axes = view_axes(spots[0].angles);
        EXPECT_NEAR(glm::distance(axes.forward, view_axes(angles).forward), 0.0f, 1e-5f);
        // Beside the picture, and nothing of it outside of the box that walls keep out.
        const glm::vec3 away = spots[0].origin - eye;
        EXPECT_LT(std::abs(away.x) + spots[0].radius, 16.0f);
        EXPECT_LT(std::abs(away.y) + spots[0].radius, 16.0f);
        EXPECT_GT(glm::dot(away, axes.right), 2.0f * glm::dot(away, axes.forward));
    }
    session_.set_flashlight(false);
    EXPECT_TRUE(session_.frame().spots.empty());
}

TEST_F(MovingLights, BoltsAndTheirHitsKeepTheirIdsAndGo) {
    Play play(session_);
    FlightInput keys;
    keys.attack = true;
    play.frame(keys, 0.05, false, session_);
    const auto first = lights();
    ASSERT_EQ(first.size(), 1u);
    const uint32_t bolt = first.begin()->first;
    // One shot: flies under one id, is seen under another where it hits, fades, and is gone.
    std::set<uint32_t> seen;
    float brightest = 0.0f, last = 0.0f;
    for (int frame = 0; frame < 4 * 60; ++frame) {
        play.frame({}, 1.0 / 60.0, false, session_);
        for (const auto& [id, light] : lights()) {
            seen.insert(id);
            if (id == bolt) continue;
            brightest = std::max(brightest, light.radiance.x);
            if (last > 0.0f) {
                EXPECT_LE(light.radiance.x, last);
            }
            last = light.radiance.x;
        }
    }
    EXPECT_EQ(seen.size(), 2u);
    EXPECT_TRUE(seen.contains(bolt));
    EXPECT_GT(brightest, 0.0f);
    EXPECT_TRUE(lights().empty());
}

class MovingLightCommands : public ProgramRun {
protected:
    int run(const std::string& basedir, const std::string& text) {
        return run_program_on(
            basedir, text,
            [this](FileSystem&, refresh::SurfaceProvider*, const refresh::Settings&) {
                return std::make_unique<FakeRenderer>(render_);
            });
    }
    RenderLog render_;
};

TEST_F(MovingLightCommands, FlashlightAndTestLightsSwitch) {
    EXPECT_EQ(run(VIGIL_SOURCE_DIR, "+map ring +testlights 7 +flashlight +wait 3"), 0) << errors_;
    EXPECT_EQ(render_.lights.size(), 7u);
    EXPECT_EQ(render_.spots.size(), 1u);
    EXPECT_EQ(run(VIGIL_SOURCE_DIR, "+map ring +testlights 7 +flashlight +wait 3 +flashlight "
                                    "+testlights 0 +wait 2"),
              0)
        << errors_;
    EXPECT_TRUE(render_.lights.empty());
    EXPECT_TRUE(render_.spots.empty());
    EXPECT_EQ(run(VIGIL_SOURCE_DIR, "+flashlight"), 1);
}

/// An explosive beside the start that bursts as soon as the level lives.
TEST_F(MovingLightCommands, ExplosionsGlowAndGo) {
    game_.write_level_file("burst", R"({
"classname" "worldspawn"
}
{
"classname" "info_player_start"
"origin" "32 32 24"
}
{
"classname" "target_explosion"
"origin" "20 20 30"
"targetname" "bang"
}
{
"classname" "trigger_always"
"target" "bang"
}
)");
    EXPECT_EQ(run(game_.basedir(), "+map burst +noclip +wait 40"), 0) << errors_;
    ASSERT_EQ(render_.lights.size(), 1u);
    const refresh::DynamicLight early = render_.lights.front();
    EXPECT_EQ(early.origin, glm::vec3(20, 20, 30));
    EXPECT_EQ(run(game_.basedir(), "+map burst +noclip +wait 80"), 0) << errors_;
    ASSERT_EQ(render_.lights.size(), 1u);
    EXPECT_EQ(render_.lights.front().id, early.id);
    EXPECT_LT(render_.lights.front().radiance.x, early.radiance.x);
    EXPECT_EQ(run(game_.basedir(), "+map burst +noclip +wait 140"), 0) << errors_;
    EXPECT_TRUE(render_.lights.empty());
}

} // namespace
} // namespace vigil::client
