// SPDX-License-Identifier: GPL-2.0-or-later
// Entities that live, one after the other, on levels of boxes.
#include "played_boxes.h"

#include <glm/glm.hpp>
#include <gtest/gtest.h>

namespace vigil {
namespace {

/// A door across the way at x = 200, 16 thick, 128 high, that goes up.
BoxLevel with_door() {
    BoxLevel level = BoxLevel::with_floor();
    level.add_box({{200, 64, 0}, {216, 1000, 300}});
    level.add_box({{200, -1000, 0}, {216, -64, 300}});
    const uint32_t door = level.add_model({{200, -64, 0}, {216, 64, 128}});
    level.add_entity({{"classname", "func_door"}, {"model", model(door)}, {"angle", "-1"}});
    return level;
}

TEST(Door, OpensBeforeThePlayerAndCloses) {
    Play play(with_door());
    play.run(0.5f);
    EXPECT_EQ(play.place(1), glm::vec3(0));
    // 200 - 60 - 16 units away at 300 units a second; the door needs 122 units at 100 a second.
    play.run(4.0f, ahead());
    EXPECT_GT(play.game.player().origin.x, 300.0f);
    play.run(6.0f);
    EXPECT_EQ(play.place(1), glm::vec3(0));
}

TEST(Door, GoesItsSizeLessItsLipInTime) {
    Play play(with_door());
    play.game.actor(1)->use();
    play.run(0.61f);
    EXPECT_NEAR(play.place(1).z, 61.0f, 1.1f);
    play.run(1.0f);
    EXPECT_NEAR(play.place(1).z, 130.0f - 8.0f,
                1e-3f); // a unit wider on both sides, as in the game
    play.run(2.0f);
    EXPECT_NEAR(play.place(1).z, 122.0f, 1e-3f);
    play.run(1.5f);
    EXPECT_LT(play.place(1).z, 122.0f);
}

TEST(Door, WithANameWaitsForItsButton) {
    BoxLevel level = BoxLevel::with_floor();
    const uint32_t door = level.add_model({{200, -64, 0}, {216, 64, 128}});
    const uint32_t button = level.add_model({{100, -16, 0}, {108, 16, 64}});
    level.add_entity({{"classname", "func_door"},
                      {"model", model(door)},
                      {"angle", "-1"},
                      {"targetname", "gate"},
                      {"wait", "-1"}});
    level.add_entity({{"classname", "func_button"},
                      {"model", model(button)},
                      {"angle", "0"},
                      {"target", "gate"},
                      {"delay", "0.5"}});
    Play play(level);
    play.run(0.2f);
    EXPECT_EQ(play.place(1), glm::vec3(0));
    play.run(1.0f, ahead());
    EXPECT_GT(play.place(2).x, 1.0f);
    play.run(3.0f);
    EXPECT_NEAR(play.place(1).z, 122.0f, 1e-3f);
    play.run(5.0f);
    EXPECT_NEAR(play.place(1).z, 122.0f, 1e-3f); // wait -1: stays
    EXPECT_EQ(play.place(2), glm::vec3(0));      // the button came back
}

TEST(Door, TeamsMoveAsOneAndArriveTogether) {
    BoxLevel level = BoxLevel::with_floor();
    const uint32_t left = level.add_model({{200, 0, 0}, {216, 64, 128}});
    const uint32_t right = level.add_model({{200, -32, 0}, {216, 0, 128}});
    level.add_entity(
        {{"classname", "func_door"}, {"model", model(left)}, {"angle", "90"}, {"team", "t"}});
    level.add_entity(
        {{"classname", "func_door"}, {"model", model(right)}, {"angle", "270"}, {"team", "t"}});
    Play play(level);
    play.game.actor(2)->use();
    play.run(0.13f); // 26 units at 100 a second take 0.26 s
    EXPECT_NEAR(play.place(1).y, 0.5f * 58.0f, 3.0f);
    EXPECT_NEAR(play.place(2).y, -0.5f * 26.0f, 1.5f);
    play.run(0.2f);
    EXPECT_NEAR(play.place(1).y, 58.0f, 1e-3f);
    EXPECT_NEAR(play.place(2).y, -26.0f, 1e-3f);
}

TEST(Door, ReversesAboveThePlayersHead) {
    BoxLevel level = BoxLevel::with_floor();
    const uint32_t door = level.add_model({{200, -64, 0}, {216, 64, 128}});
    level.add_entity({{"classname", "func_door"},
                      {"model", model(door)},
                      {"angle", "-1"},
                      {"targetname", "d"},
                      {"wait", "1"}});
    Play play(level);
    play.game.actor(1)->use();
    play.run(1.5f);
    play.game.place_player_at({208, 0, 24.1f});
    float lowest = 1000.0f;
    for (int i = 0; i < 1000; ++i) {
        play.game.tick({});
        lowest = std::min(lowest, play.place(1).z);
    }
    EXPECT_GT(lowest, 56.0f);
    EXPECT_LT(lowest, 58.0f);
    EXPECT_EQ(play.game.player().ground, owner_world);
    play.run(1.0f, ahead());
    play.run(5.0f);
    EXPECT_EQ(play.place(1), glm::vec3(0));
}

TEST(RotatingDoor, TurnsNinetyDegrees) {
    BoxLevel level = BoxLevel::with_floor();
    const uint32_t door = level.add_model({{0, -4, 0}, {64, 4, 128}});
    level.add_entity({{"classname", "func_door_rotating"},
                      {"model", model(door)},
                      {"origin", "500 0 0"},
                      {"targetname", "x"}});
    Play play(level);
    play.game.actor(1)->use();
    play.run(0.46f);
    EXPECT_NEAR(play.angles(1).y, 46.0f, 1.1f);
    play.run(1.0f);
    EXPECT_EQ(play.angles(1), glm::vec3(0, 90, 0));
    // Open, it stands across y: its tip is at (500, 64).
    const Trace trace =
        play.game.collision().trace({400, 40, 50}, {600, 40, 50}, {}, mask_player_solid);
    EXPECT_NEAR(trace.end.x, 496.0f, 0.1f);
    EXPECT_EQ(trace.owner, 1);
}

TEST(Plat, LiftsWhoStepsOnIt) {
    BoxLevel level = BoxLevel::with_floor();
    // Drawn at its top, 200 over the floor.
    const uint32_t plat = level.add_model({{100, -64, -8}, {228, 64, 200}});
    level.add_entity({{"classname", "func_plat"}, {"model", model(plat)}, {"height", "192"}});
    Play play(level);
    EXPECT_NEAR(play.place(1).z, -192.0f, 1e-3f);
    play.run(0.7f, ahead());
    EXPECT_EQ(play.game.player().ground, 1);
    play.run(1.5f);
    EXPECT_NEAR(play.game.player().origin.z, 224.0f, 0.3f);
    EXPECT_EQ(play.game.player().ground, 1);
    // Down again once it is left.
    play.run(1.0f, ahead());
    play.run(6.0f);
    EXPECT_NEAR(play.place(1).z, -192.0f, 1e-3f);
}

TEST(Train, CarriesAlongItsCorners) {
    BoxLevel level = BoxLevel::with_floor();
    const uint32_t train = level.add_model({{-64, -64, 0}, {64, 64, 16}});
    level.add_entity(
        {{"classname", "func_train"}, {"model", model(train)}, {"target", "a"}, {"speed", "50"}});
    level.add_entity({{"classname", "path_corner"},
                      {"targetname", "a"},
                      {"target", "b"},
                      {"origin", "-64 -64 0"}});
    level.add_entity({{"classname", "path_corner"},
                      {"targetname", "b"},
                      {"target", "a"},
                      {"origin", "136 -64 100"},
                      {"wait", "1"}});
    Play play(level, {0, 0, 41});
    play.run(0.3f);
    EXPECT_EQ(play.game.player().ground, 1);
    const float ahead_of_it = play.game.player().origin.x - play.place(1).x; // fell onto it
    play.run(2.0f);
    EXPECT_NEAR(play.game.player().origin.x, play.place(1).x + ahead_of_it, 0.1f);
    EXPECT_GT(play.game.player().origin.z, 60.0f);
    play.run(3.0f);
    EXPECT_NEAR(play.place(1).x, 200.0f, 1e-3f);
    play.run(3.0f);
    EXPECT_LT(play.place(1).x, 150.0f);
    EXPECT_NEAR(play.game.player().origin.x, play.place(1).x + ahead_of_it, 0.1f);
}

TEST(Rotating, CarriesAndTurnsTheView) {
    BoxLevel level = BoxLevel::with_floor();
    const uint32_t disc = level.add_model({{-128, -128, 0}, {128, 128, 16}});
    level.add_entity({{"classname", "func_rotating"},
                      {"model", model(disc)},
                      {"spawnflags", "1"},
                      {"speed", "90"}});
    Play play(level, {64, 0, 41});
    play.run(1.0f);
    // A quarter of a turn, less what falling onto it took.
    EXPECT_NEAR(glm::length(glm::vec2(play.game.player().origin)), 64.0f, 1.0f);
    EXPECT_GT(play.game.player().origin.y, 55.0f);
    EXPECT_NEAR(play.game.take_view_turn(), 90.0f, 10.0f);
}

TEST(Wall, ComesAndGoes) {
    BoxLevel level = BoxLevel::with_floor();
    const uint32_t wall = level.add_model({{100, -64, 0}, {116, 64, 128}});
    level.add_entity({{"classname", "func_wall"},
                      {"model", model(wall)},
                      {"spawnflags", "3"},
                      {"targetname", "w"}});
    level.add_entity({{"classname", "trigger_relay"}, {"target", "w"}});
    Play play(level);
    EXPECT_FALSE(play.shown(1));
    play.game.actor(2)->use();
    EXPECT_TRUE(play.shown(1));
    play.run(1.0f, ahead());
    EXPECT_LT(play.game.player().origin.x, 84.1f);
    play.game.actor(2)->use();
    play.run(1.0f, ahead());
    EXPECT_GT(play.game.player().origin.x, 150.0f);
}

TEST(Explosive, IsShotAndFires) {
    BoxLevel level = BoxLevel::with_floor();
    const uint32_t crate = level.add_model({{200, -32, 0}, {264, 32, 64}});
    const uint32_t door = level.add_model({{500, -64, 0}, {516, 64, 128}});
    level.add_entity({{"classname", "func_explosive"},
                      {"model", model(crate)},
                      {"health", "20"},
                      {"target", "d"}});
    level.add_entity({{"classname", "func_door"},
                      {"model", model(door)},
                      {"angle", "-1"},
                      {"targetname", "d"},
                      {"wait", "-1"}});
    Play play(level);
    PlayerCommand command;
    command.attack = true;
    command.angles.x = 5.0f;
    play.run(0.4f, command); // the first bolt has hit
    EXPECT_TRUE(play.shown(1));
    EXPECT_FALSE(play.game.bolts().hits().empty());
    play.run(0.6f, command);
    EXPECT_FALSE(play.shown(1));
    play.run(2.0f);
    EXPECT_NEAR(play.place(2).z, 122.0f, 1e-3f);
    EXPECT_TRUE(play.game.bolts().flying().empty());
}

/// A volume over the floor at x = 100..150.
uint32_t add_volume(BoxLevel& level) {
    return level.add_model({{100, -64, 0}, {150, 64, 128}});
}

TEST(Trigger, OnceFiresOnceAndMultipleAgain) {
    for (const bool once : {true, false}) {
        BoxLevel level = BoxLevel::with_floor();
        level.add_entity({{"classname", once ? "trigger_once" : "trigger_multiple"},
                          {"model", model(add_volume(level))},
                          {"target", "l"},
                          {"wait", "0.5"}});
        level.add_entity(
            {{"classname", "light"}, {"targetname", "l"}, {"style", "32"}, {"spawnflags", "1"}});
        Play play(level, {125, 0, 24.1f});
        int changes = 0;
        std::string last = "a";
        for (int i = 0; i < 180; ++i) {
            play.game.tick({});
            const auto& styles = play.game.light_styles();
            if (styles.contains(32) && styles.at(32) != last) {
                last = styles.at(32);
                ++changes;
            }
        }
        EXPECT_EQ(changes, once ? 1 : 4); // at 0, 0.5, 1 and 1.5 s
    }
}

TEST(Trigger, CircleOfRelaysEnds) {
    BoxLevel level = BoxLevel::with_floor();
    level.add_entity({{"classname", "trigger_relay"}, {"targetname", "a"}, {"target", "a"}});
    level.add_entity({{"classname", "trigger_relay"}, {"targetname", "a"}, {"target", "a"}});
    Play play(level);
    play.game.actor(1)->use();
    play.run(0.1f);
}

TEST(Trigger, KillTargetRemoves) {
    BoxLevel level = BoxLevel::with_floor();
    const uint32_t wall = level.add_model({{100, -64, 0}, {116, 64, 128}});
    level.add_entity({{"classname", "func_wall"}, {"model", model(wall)}, {"targetname", "w"}});
    level.add_entity({{"classname", "trigger_relay"}, {"killtarget", "w"}});
    Play play(level);
    play.game.actor(2)->use();
    EXPECT_FALSE(play.shown(1));
    play.run(1.0f, ahead());
    EXPECT_GT(play.game.player().origin.x, 150.0f);
}

TEST(Push, Throws) {
    BoxLevel level = BoxLevel::with_floor();
    level.add_entity({{"classname", "trigger_push"},
                      {"model", model(add_volume(level))},
                      {"angle", "-1"},
                      {"speed", "60"}});
    Play play(level, {125, 0, 24.1f});
    play.run(1.0f);
    EXPECT_GT(play.game.player().origin.z, 150.0f); // 600 units a second
}

TEST(Teleport, MovesAndTurns) {
    BoxLevel level = BoxLevel::with_floor();
    level.add_entity({{"classname", "trigger_teleport"},
                      {"model", model(add_volume(level))},
                      {"target", "there"}});
    level.add_entity({{"classname", "misc_teleporter_dest"},
                      {"targetname", "there"},
                      {"origin", "-500 300 30"},
                      {"angle", "90"}});
    Play play(level);
    play.run(0.5f, ahead());
    const glm::vec3 eye = play.game.eye_at(0.0f);
    EXPECT_NEAR(eye.y, 300.0f, 60.0f); // no way is shown between
    EXPECT_NEAR(play.game.player().origin.x, -500.0f, 60.0f);
    EXPECT_EQ(play.game.take_view(), glm::vec3(0, 90, 0));
    EXPECT_EQ(play.game.take_view(), std::nullopt);
}

TEST(LightRamp, GoesUpAndBack) {
    BoxLevel level = BoxLevel::with_floor();
    level.add_entity({{"classname", "target_lightramp"},
                      {"target", "l"},
                      {"message", "az"},
                      {"speed", "1"},
                      {"spawnflags", "1"}});
    level.add_entity({{"classname", "light"}, {"targetname", "l"}, {"style", "33"}});
    Play play(level);
    play.game.actor(1)->use();
    EXPECT_EQ(play.game.light_styles().at(33), "a");
    play.run(0.5f);
    EXPECT_NEAR(play.game.light_styles().at(33)[0], 'm', 1);
    play.run(0.6f);
    EXPECT_EQ(play.game.light_styles().at(33), "z");
    play.game.actor(1)->use();
    play.run(1.1f);
    EXPECT_EQ(play.game.light_styles().at(33), "a");
}

TEST(AreaPortals, OpenWithTheirDoor) {
    BoxLevel level = BoxLevel::with_floor();
    const uint32_t door = level.add_model({{200, -64, 0}, {216, 64, 128}});
    level.add_entity(
        {{"classname", "func_door"}, {"model", model(door)}, {"angle", "-1"}, {"target", "p"}});
    level.add_entity({{"classname", "func_areaportal"}, {"targetname", "p"}, {"style", "5"}});
    Play play(level);
    EXPECT_FALSE(play.game.area_portals().is_open(5));
    play.game.actor(1)->use();
    play.run(0.1f);
    EXPECT_TRUE(play.game.area_portals().is_open(5));
    play.run(8.0f);
    EXPECT_FALSE(play.game.area_portals().is_open(5));
}

TEST(AreaPortals, ConnectAreas) {
    Bsp bsp;
    bsp.areas = {{}, {0, 1}, {1, 2}, {3, 1}};
    bsp.area_portals = {{1, 2}, {1, 1}, {2, 3}, {2, 2}};
    AreaPortals portals(bsp);
    EXPECT_FALSE(portals.connected(1, 2));
    portals.set_open(1, true);
    EXPECT_TRUE(portals.connected(1, 2));
    EXPECT_FALSE(portals.connected(1, 3));
    portals.set_open(2, true);
    EXPECT_TRUE(portals.connected(1, 3));
    portals.set_open(1, false);
    EXPECT_FALSE(portals.connected(1, 3));
}

TEST(Game, SurvivesKeysThatMakeNoSense) {
    BoxLevel level = BoxLevel::with_floor();
    for (const char* name :
         {"func_door", "func_door_rotating", "func_button", "func_plat", "func_rotating",
          "func_train", "func_wall", "func_explosive", "trigger_multiple", "trigger_push",
          "trigger_teleport", "target_lightramp", "light", "misc_teleporter", "func_areaportal",
          "nonsense"})
        for (const char* number : {"1e38", "-1e38", "x", "-2147483648"}) {
            const uint32_t box = level.add_model({{100, -64, 0}, {116, 64, 128}});
            level.add_entity({{"classname", name},
                              {"model", model(box)},
                              {"origin", std::string(number) + " 0 0"},
                              {"speed", number},
                              {"lip", number},
                              {"wait", number},
                              {"height", number},
                              {"style", number},
                              {"distance", number},
                              {"delay", number},
                              {"angle", number},
                              {"spawnflags", number},
                              {"message", number},
                              {"target", "a"},
                              {"targetname", "a"},
                              {"killtarget", "b"},
                              {"health", number},
                              {"count", number}});
            level.add_entity({{"classname", name}, {"model", "*4711"}});
        }
    Play play(level);
    for (const auto& actor : play.game.actors()) {
        actor->use();
        actor->hurt(1e30f);
        actor->touch();
    }
    play.run(5.0f, ahead());
}

} // namespace
} // namespace vigil
