// SPDX-License-Identifier: GPL-2.0-or-later
// Playing in the client: walks as files, the same end at every frame rate, what the session shows,
// and the commands.
#include "client/play/play.h"
#include "fake_renderer.h"
#include "program_run.h"

#include <gtest/gtest.h>

namespace vigil::client {
namespace {

TEST(Walk, TextAndBack) {
    Walk walk;
    PlayerCommand command;
    for (int i = 0; i < 10; ++i)
        walk.add(command);
    command = {{1.25f, -90.1f, 0.0f}, 400.0f, -400.0f, 200.0f, true};
    walk.add(command);
    const Walk again = Walk::parse("w", walk.text());
    ASSERT_EQ(again.ticks(), 11);
    EXPECT_EQ(again.command_at(9), PlayerCommand{});
    EXPECT_EQ(again.command_at(10), command);
    EXPECT_EQ(again.text(), walk.text());
}

TEST(Walk, RefusesWhatIsNone) {
    for (const char* text :
         {"", "# nothing\n", "1 2 3\n", "0 0 0 0 0 0 0 0\n", "1.5 0 0 0 0 0 0 0\n",
          "1 1e9 0 0 0 0 0 0\n", "1 0 0 0 0 0 0 2\n", "1 0 0 0 0 0 0 0 0\n", "1 nan 0 0 0 0 0 0\n",
          "1000000 0 0 0 0 0 0 0\n1000000 0 0 0 0 0 0 0\n"
          "1000000 0 0 0 0 0 0 0\n1000000 0 0 0 0 0 0 0\n"
          "1000000 0 0 0 0 0 0 0\n1000000 0 0 0 0 0 0 0\n"})
        EXPECT_THROW(Walk::parse("w", text), Error) << text;
    EXPECT_NO_THROW(Walk::parse("w", "5 0 0 0 0 0 0 0 # a comment\r\n\n"));
}

/// The level "warehouse" of the game, shown by a renderer that draws nothing.
class PlayTest : public testing::Test {
protected:
    PlayTest() {
        files_.mount_game(std::filesystem::path(VIGIL_SOURCE_DIR), "baseq2");
        session_.load_map("warehouse");
    }
    RenderLog log_;
    FakeRenderer renderer_{log_};
    FileSystem files_;
    Session session_{files_, renderer_, cvars()};
};

TEST_F(PlayTest, WalksEndInTheSamePlaceAtEveryFrameRate) {
    const std::string text = "50 0 0 0 0 0 0 0\n"
                             "170 400 0 0 0 40 0 0\n"
                             "90 400 -100 200 -10 75.5 0 1\n"
                             "201 400 0 0 20 -100 0 0\n";
    std::optional<PlayerState> end;
    std::optional<glm::vec3> eye;
    for (const double fps : {10.0, 60.0, 77.0, 1000.0}) {
        Play play(session_);
        play.follow(Walk::parse("w", text));
        int frames = 0;
        while (play.following() && ++frames < 100000)
            play.frame({}, 1.0 / fps, false, session_);
        EXPECT_NEAR(frames, 5.11 * fps, 1.01);
        EXPECT_EQ(play.game().ticks(), 511);
        if (!end) {
            end = play.game().player();
            eye = session_.camera().origin();
        }
        EXPECT_EQ(play.game().player(), *end) << fps;
        EXPECT_EQ(session_.camera().origin(), *eye) << fps;
        EXPECT_EQ(session_.camera().angles(), glm::vec3(20, -100, 0));
        Play::clear(session_);
    }
    EXPECT_GT(glm::distance(*eye, find_start(session_.level()->bsp).origin), 300.0f);
}

TEST_F(PlayTest, KillBringsThePlayerBackAndTheLevelGoesOn) {
    Play play(session_);
    FlightInput keys;
    keys.forward = 1.0f;
    for (int i = 0; i < 60; ++i)
        play.frame(keys, 1.0 / 60.0, false, session_);
    const StartPlace start = find_start(session_.level()->bsp);
    EXPECT_GT(glm::distance(session_.camera().origin(), start.origin), 50.0f);
    session_.camera().set(session_.camera().origin(), {10.0f, 20.0f, 0.0f});
    const int64_t ticks = play.game().ticks();
    play.kill(session_);
    EXPECT_EQ(play.game().deaths(), 1);
    EXPECT_EQ(play.game().health(), Game::full_health);
    EXPECT_EQ(play.game().ticks(), ticks);
    EXPECT_LT(glm::distance(session_.camera().origin(), start.origin), 30.0f);
    EXPECT_EQ(session_.camera().angles(), start.angles);
    Play::clear(session_);
}

TEST_F(PlayTest, RecordedKeysGiveTheSameWalk) {
    FlightInput keys;
    keys.forward = 1.0f;
    keys.turn_left = 0.5f;
    Play first(session_);
    first.record("walks/x.walk");
    for (int i = 0; i < 100; ++i)
        first.frame(keys, 1.0 / 37.0, false, session_);
    const PlayerState end = first.game().player();
    const std::optional<Walk> walk = first.take_recording();
    ASSERT_TRUE(walk);
    EXPECT_EQ(walk->ticks(), first.game().ticks());

    Play second(session_);
    second.follow(Walk::parse("x", walk->text()));
    while (second.following())
        second.frame({}, 1.0 / 60.0, false, session_);
    EXPECT_EQ(second.game().player(), end);
}

TEST_F(PlayTest, TheEyeIsInterpolated) {
    Play play(session_);
    FlightInput keys;
    keys.forward = 1.0f;
    for (int i = 0; i < 200; ++i)
        play.frame(keys, 0.005, false, session_);
    const float speed = glm::length(play.game().player().velocity);
    ASSERT_GT(speed, 100.0f);
    // Frames shorter than ticks move the eye evenly.
    glm::vec3 last = session_.camera().origin();
    for (int i = 0; i < 20; ++i) {
        play.frame(keys, 0.004, false, session_);
        EXPECT_NEAR(glm::distance(last, session_.camera().origin()), speed * 0.004f, 0.5f);
        last = session_.camera().origin();
    }
}

TEST_F(PlayTest, FlightKeepsTheEyeAndWalkingReturnsToIt) {
    Play play(session_);
    EXPECT_TRUE(play.set_walking(false, session_));
    const glm::vec3 eye = session_.camera().origin() + glm::vec3(0, 0, 4);
    session_.camera().set(eye, {});
    for (int i = 0; i < 60; ++i)
        play.frame({}, 1.0 / 60.0, false, session_);
    EXPECT_EQ(session_.camera().origin(), eye);
    EXPECT_TRUE(play.set_walking(true, session_));
    play.frame({}, 0.0, false, session_);
    EXPECT_NEAR(glm::distance(session_.camera().origin(), eye), 0.0f, 0.1f);
    // Far outside there is no room.
    play.set_walking(false, session_);
    session_.camera().set({1e5f, 0, 0}, {});
    EXPECT_FALSE(play.set_walking(true, session_));
    play.frame({}, 1.0, false, session_);
    EXPECT_LT(glm::distance(session_.camera().origin(), eye), 200.0f);
}

class PlayCommands : public ProgramRun {
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

TEST_F(PlayCommands, WithoutAWindowNothingMovesUntilNoclip) {
    EXPECT_EQ(run(VIGIL_SOURCE_DIR, "+map warehouse +wait 30 +viewpos"), 0) << errors_;
    for (const refresh::View& view : render_.views)
        EXPECT_EQ(view.origin, render_.views.front().origin);
    const glm::vec3 start = render_.views.front().origin;
    render_ = {};
    EXPECT_EQ(run(VIGIL_SOURCE_DIR, "+map warehouse +noclip +wait 60 +playerinfo"), 0) << errors_;
    EXPECT_GT(glm::distance(render_.views.back().origin, start), 1.0f); // down to the floor
    EXPECT_NE(output_.find("on the ground"), std::string::npos) << output_;
}

TEST_F(PlayCommands, SetviewposHoldsTheEye) {
    EXPECT_EQ(run(VIGIL_SOURCE_DIR, "+map warehouse +noclip +wait 5 +setviewpos 1 2 300 4 5 6 "
                                    "+wait 30 +screenshot"),
              0)
        << errors_;
    EXPECT_EQ(render_.views.back().origin, glm::vec3(1, 2, 300));
    EXPECT_EQ(render_.views.back().angles, glm::vec3(4, 5, 6));
}

TEST_F(PlayCommands, AWalkRunsToItsEndBeforeWhatFollows) {
    game_.write("out/walks/a.walk", "100 400 0 0 0 0 0 0\n");
    EXPECT_EQ(run(VIGIL_SOURCE_DIR, "+map warehouse +walk a +playerinfo"), 0) << errors_;
    EXPECT_NE(output_.find("tick 100"), std::string::npos) << output_;
    EXPECT_EQ(run(VIGIL_SOURCE_DIR, "+map warehouse +walk nowhere"), 1);
    EXPECT_NE(errors_.find("there is no walk walks/nowhere.walk"), std::string::npos) << errors_;
}

TEST_F(PlayCommands, ShippedWalksRun) {
    EXPECT_EQ(run(VIGIL_SOURCE_DIR, "+map ring +walk ring +playerinfo"), 0) << errors_;
    EXPECT_NE(output_.find("on the ground"), std::string::npos) << output_;
    EXPECT_GT(render_.views.size(), 600u);
}

TEST_F(PlayCommands, WalksAreRecorded) {
    EXPECT_EQ(run(VIGIL_SOURCE_DIR, "+map warehouse +walkrecord b +wait 30 +walkstop "
                                    "+walk b +playerinfo"),
              0)
        << errors_;
    EXPECT_TRUE(game_.exists("out/walks/b.walk"));
    EXPECT_NE(output_.find("tick 50"), std::string::npos) << output_;
    EXPECT_EQ(run(VIGIL_SOURCE_DIR, "+map warehouse +walkrecord ../b"), 1);
    EXPECT_EQ(run(VIGIL_SOURCE_DIR, "+walkrecord b"), 1);
    EXPECT_EQ(run(VIGIL_SOURCE_DIR, "+map warehouse +walkstop"), 1);
}

TEST_F(PlayCommands, AFlightAlongARouteEndsPlay) {
    EXPECT_EQ(run(VIGIL_SOURCE_DIR, "+map ring +fly ring 2"), 0) << errors_;
    const std::vector<refresh::View> alone = render_.views;
    render_ = {};
    EXPECT_EQ(run(VIGIL_SOURCE_DIR, "+map ring +noclip +wait 20 +fly ring 2"), 0) << errors_;
    ASSERT_GE(render_.views.size(), alone.size());
    for (size_t i = 0; i < alone.size(); ++i)
        EXPECT_EQ(alone[i].origin, render_.views[render_.views.size() - alone.size() + i].origin);
}

} // namespace
} // namespace vigil::client
