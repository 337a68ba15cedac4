// SPDX-License-Identifier: GPL-2.0-or-later
// Timers, secret doors, what falls, carries, hurts and bursts, on levels of boxes.
#include "played_boxes.h"

#include <glm/glm.hpp>
#include <gtest/gtest.h>

#include <set>

namespace vigil {
namespace {

/// A wall that something takes away and brings back: shows how often it was used.
int add_switched_wall(BoxLevel& level, const char* name) {
    const uint32_t wall = level.add_model({{3000, 0, 0}, {3010, 10, 10}});
    return level.add_entity({{"classname", "func_wall"},
                             {"model", model(wall)},
                             {"spawnflags", "7"},
                             {"targetname", name}});
}

/// Ticks at which the wall changed within some seconds.
std::vector<int> changes(Play& play, int wall, float seconds) {
    std::vector<int> found;
    for (int tick = 0; tick < static_cast<int>(ticks_of(seconds)); ++tick) {
        const bool before = play.shown(wall);
        play.game.tick({});
        if (play.shown(wall) != before) found.push_back(tick);
    }
    return found;
}

TEST(Timer, FiresEveryWaitUntilItIsSwitchedOff) {
    BoxLevel level = BoxLevel::with_floor();
    const int wall = add_switched_wall(level, "w");
    level.add_entity({{"classname", "func_timer"},
                      {"wait", "0.5"},
                      {"target", "w"},
                      {"targetname", "t"},
                      {"spawnflags", "1"}});
    Play play(level);
    const std::vector<int> fired = changes(play, wall, 4.2f);
    ASSERT_EQ(fired.size(), 6u); // from 1.5 s on
    for (size_t i = 1; i < fired.size(); ++i)
        EXPECT_EQ(fired[i] - fired[i - 1], 50);
    play.game.actor(2)->use();
    EXPECT_TRUE(changes(play, wall, 3.0f).empty());
    play.game.actor(2)->use(); // at once
    EXPECT_EQ(changes(play, wall, 1.2f).size(), 2u);
}

TEST(Timer, RandomIsTheSameEachTime) {
    BoxLevel level = BoxLevel::with_floor();
    const int wall = add_switched_wall(level, "w");
    level.add_entity({{"classname", "func_timer"},
                      {"wait", "1"},
                      {"random", "0.5"},
                      {"target", "w"},
                      {"spawnflags", "1"}});
    Play first(level), second(level);
    const std::vector<int> fired = changes(first, wall, 30.0f);
    EXPECT_EQ(changes(second, wall, 30.0f), fired);
    std::set<int> waits;
    for (size_t i = 1; i < fired.size(); ++i) {
        waits.insert(fired[i] - fired[i - 1]);
        EXPECT_GE(fired[i] - fired[i - 1], 50);
        EXPECT_LE(fired[i] - fired[i - 1], 150);
    }
    EXPECT_GT(waits.size(), 10u);
}

TEST(SecretDoor, GoesAsideThenAlongAndComesBack) {
    BoxLevel level = BoxLevel::with_floor();
    // 16 thick along x, 64 wide; its angle is +x, so right is -y.
    const uint32_t door = level.add_model({{200, -32, 0}, {216, 32, 128}});
    level.add_entity({{"classname", "func_door_secret"}, {"model", model(door)}, {"wait", "2"}});
    Play play(level);
    PlayerCommand shot;
    shot.attack = true;
    play.run(0.01f, shot);
    play.run(2.0f);
    EXPECT_LT(play.place(1).y, -60.0f); // 66 units at 50 a second, a unit wider as in the game
    EXPECT_EQ(play.place(1).x, 0.0f);
    play.run(1.7f);
    EXPECT_NEAR(play.place(1).x, 18.0f, 0.01f);
    EXPECT_NEAR(play.place(1).y, -66.0f, 0.01f);
    play.run(6.0f);
    EXPECT_EQ(play.place(1), glm::vec3(0));
}

TEST(SecretDoor, WithANameIsOpenedByUseAlone) {
    BoxLevel level = BoxLevel::with_floor();
    const uint32_t door = level.add_model({{200, -32, 0}, {216, 32, 128}});
    level.add_entity({{"classname", "func_door_secret"},
                      {"model", model(door)},
                      {"spawnflags", "4"},
                      {"wait", "-1"},
                      {"targetname", "s"}});
    Play play(level);
    play.game.actor(1)->hurt(100.0f);
    play.run(0.5f);
    EXPECT_EQ(play.place(1), glm::vec3(0));
    play.game.actor(1)->use();
    play.run(10.0f);
    EXPECT_NEAR(play.place(1).z, -130.0f, 0.01f);
    EXPECT_NEAR(play.place(1).x, 18.0f, 0.01f);
}

TEST(Object, FallsWhenWhatHeldItIsGone) {
    BoxLevel level = BoxLevel::with_floor();
    const uint32_t object = level.add_model({{500, -16, 100}, {532, 16, 132}});
    const uint32_t shelf = level.add_model({{480, -40, 90}, {550, 40, 100}});
    level.add_entity({{"classname", "func_object"}, {"model", model(object)}});
    level.add_entity({{"classname", "func_wall"},
                      {"model", model(shelf)},
                      {"spawnflags", "7"},
                      {"targetname", "shelf"}});
    Play play(level);
    play.run(2.0f);
    EXPECT_NEAR(play.place(1).z, 0.0f, 1.5f);
    play.game.actor(2)->use();
    play.run(2.0f);
    EXPECT_NEAR(play.place(1).z, -100.0f, 1.5f);
    EXPECT_EQ(play.game.deaths(), 0);
}

TEST(Object, KillsWhoStandsBelow) {
    BoxLevel level = BoxLevel::with_floor();
    const uint32_t object = level.add_model({{-20, -20, 300}, {20, 20, 340}});
    level.add_entity({{"classname", "func_object"},
                      {"model", model(object)},
                      {"spawnflags", "1"},
                      {"targetname", "o"}});
    Play play(level, {0, 0, 24.1f});
    play.run(1.0f);
    EXPECT_FALSE(play.shown(1));
    EXPECT_EQ(play.place(1).z, 0.0f);
    play.game.actor(1)->use();
    play.run(1.2f);
    EXPECT_GT(play.game.deaths(), 0);
}

TEST(Conveyor, CarriesWhileItIsOn) {
    BoxLevel level = BoxLevel::with_floor();
    const uint32_t belt =
        level.add_model({{-64, -2000, 0}, {64, 2000, 16}}, CONTENTS_SOLID | CONTENTS_CURRENT_90);
    level.add_entity({{"classname", "func_conveyor"}, {"model", model(belt)}, {"spawnflags", "3"}});
    Play play(level, {0, 0, 40.1f});
    play.run(2.0f);
    const float carried = play.game.player().origin.y;
    EXPECT_GT(carried, 100.0f);
    play.game.actor(1)->use();
    play.run(1.0f);
    const float stopped = play.game.player().origin.y;
    play.run(1.0f);
    EXPECT_NEAR(play.game.player().origin.y, stopped, 1.0f);
    play.game.actor(1)->use();
    play.run(2.0f);
    EXPECT_GT(play.game.player().origin.y, stopped + 100.0f);
}

TEST(Hurt, KillsAndThePlayerStartsAnew) {
    BoxLevel level = BoxLevel::with_floor();
    const uint32_t pain = level.add_model({{200, -200, 0}, {600, 200, 100}});
    level.add_entity({{"classname", "trigger_hurt"},
                      {"model", model(pain)},
                      {"dmg", "30"},
                      {"spawnflags", "18"},
                      {"targetname", "h"}});
    Play play(level);
    play.run(1.0f, ahead());
    EXPECT_EQ(play.game.health(), 70.0f);
    play.run(0.4f);
    EXPECT_EQ(play.game.health(), 70.0f); // once a second
    play.game.actor(1)->use();            // off
    play.run(3.0f);
    EXPECT_EQ(play.game.health(), 70.0f);
    play.game.actor(1)->use();
    play.run(2.5f);
    EXPECT_EQ(play.game.deaths(), 1);
    EXPECT_EQ(play.game.health(), Game::full_health);
    EXPECT_NEAR(play.game.player().origin.x, 0.0f, 1.0f);
}

TEST(Button, ShotOnItsWayBackCanBeShotAgain) {
    BoxLevel level = BoxLevel::with_floor();
    const uint32_t button = level.add_model({{100, -16, 0}, {108, 16, 64}});
    level.add_entity({{"classname", "func_button"},
                      {"model", model(button)},
                      {"health", "10"},
                      {"speed", "4"},
                      {"wait", "1"}});
    Play play(level);
    play.game.actor(1)->hurt(10.0f);
    play.run(3.0f); // in after 1.5 s, waits a second
    EXPECT_NEAR(play.place(1).x, 4.0f, 0.1f);
    play.game.actor(1)->hurt(10.0f);
    play.run(2.0f);
    EXPECT_EQ(play.place(1), glm::vec3(0)); // only what is out can be pressed
    play.game.actor(1)->hurt(10.0f);
    play.run(1.0f);
    EXPECT_NEAR(play.place(1).x, 4.0f, 0.1f);
}

TEST(Explosion, GlowsFadesAndHurtsWhoIsNear) {
    BoxLevel level = BoxLevel::with_floor();
    const uint32_t crate = level.add_model({{300, -16, 0}, {332, 16, 32}});
    level.add_entity({{"classname", "func_explosive"},
                      {"model", model(crate)},
                      {"health", "10"},
                      {"dmg", "200"},
                      {"target", "far"}});
    level.add_entity({{"classname", "target_explosion"},
                      {"targetname", "far"},
                      {"delay", "0.5"},
                      {"origin", "2000 0 64"}});
    Play play(level);
    play.game.actor(1)->hurt(10.0f);
    ASSERT_EQ(play.game.explosions().glowing().size(), 1u);
    const Glow first = play.game.explosions().glowing().front();
    EXPECT_EQ(first.place, glm::vec3(316, 0, 16));
    EXPECT_EQ(first.brightness(), 1.0f);
    EXPECT_NEAR(play.game.health(), 100.0f - (200.0f - 0.5f * 316.0f), 0.5f);
    play.run(0.6f);
    ASSERT_EQ(play.game.explosions().glowing().size(), 2u);
    EXPECT_EQ(play.game.explosions().glowing()[0].id, first.id);
    EXPECT_NEAR(play.game.explosions().glowing()[0].brightness(), 0.6f, 0.02f);
    EXPECT_NE(play.game.explosions().glowing()[1].id, first.id);
    play.run(1.0f);
    EXPECT_EQ(play.game.explosions().glowing().size(), 1u);
    play.run(0.6f);
    EXPECT_TRUE(play.game.explosions().glowing().empty());
}

TEST(Explosion, WallsShield) {
    BoxLevel level = BoxLevel::with_floor();
    level.add_box({{100, -100, 0}, {110, 100, 200}});
    level.add_entity({{"classname", "target_explosion"},
                      {"targetname", "e"},
                      {"dmg", "1000"},
                      {"origin", "200 0 30"}});
    Play play(level);
    play.game.actor(1)->use();
    EXPECT_EQ(play.game.explosions().glowing().size(), 1u);
    EXPECT_EQ(play.game.health(), 100.0f);
}

} // namespace
} // namespace vigil
