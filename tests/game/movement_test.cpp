// SPDX-License-Identifier: GPL-2.0-or-later
// The known figures of the original's movement, each measured.
#include "box_level.h"
#include "game/player_movement.h"

#include <glm/glm.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace vigil {
namespace {

using namespace player;

constexpr float forward_speed = 400.0f;

PlayerCommand ahead() {
    PlayerCommand command;
    command.forward = forward_speed;
    return command;
}
PlayerCommand upwards(float up) {
    PlayerCommand command;
    command.up = up;
    return command;
}

struct Ground {
    explicit Ground(const BoxLevel& level) : bsp(level.build()), world(bsp) {}
    PlayerState at(const glm::vec3& origin) const {
        return move_player_for(place_player(origin, world), {}, world, 20);
    }
    Bsp bsp;
    CollisionWorld world;
};

TEST(Movement, RunsAtThreeHundred) {
    const Ground ground(BoxLevel::with_floor());
    PlayerState state = ground.at({0, 0, 24.1f});
    ASSERT_EQ(state.ground, owner_world);
    state = move_player_for(state, ahead(), ground.world, 100);
    const PlayerState later = move_player_for(state, ahead(), ground.world, 100);
    EXPECT_NEAR(state.velocity.x, max_speed, 0.01f);
    EXPECT_NEAR(later.origin.x - state.origin.x, 300.0f, 0.1f);
    EXPECT_NEAR(later.origin.z, state.origin.z, 1e-3f);
}

TEST(Movement, CrouchesAtOneHundredUnderALowCeiling) {
    BoxLevel level = BoxLevel::with_floor();
    level.add_box({{100, -200, 40}, {600, 200, 200}});
    const Ground ground(level);
    PlayerCommand command = ahead();
    const PlayerState standing =
        move_player_for(ground.at({0, 0, 24.1f}), command, ground.world, 300);
    EXPECT_LT(standing.origin.x, 100.0f);
    command.up = -200.0f;
    PlayerState state = move_player_for(ground.at({0, 0, 24.1f}), command, ground.world, 300);
    EXPECT_TRUE(state.ducked);
    EXPECT_NEAR(state.velocity.x, ducked_speed, 0.01f);
    EXPECT_GT(state.origin.x, 200.0f);
    // There is no room to stand up, later there is.
    state = move_player_for(state, ahead(), ground.world, 10);
    EXPECT_TRUE(state.ducked);
    state = move_player_for(state, ahead(), ground.world, 600);
    EXPECT_FALSE(state.ducked);
}

TEST(Movement, JumpsFortyFiveUnits) {
    const Ground ground(BoxLevel::with_floor());
    PlayerState state = ground.at({0, 0, 24.1f});
    const float floor = state.origin.z;
    float highest = floor;
    int ticks = 0;
    do {
        state = move_player(state, upwards(200), ground.world);
        highest = std::max(highest, state.origin.z);
        ++ticks;
    } while (state.ground == owner_none && ticks < 1000);
    // Sampled at ticks, the highest place may miss the very top by g (dt / 2)^2 / 2 = 0.01.
    EXPECT_NEAR(highest - floor, 270.0f * 270.0f / (2.0f * 800.0f), 0.02f);
    EXPECT_NEAR(static_cast<float>(ticks) * tick_s, 2.0f * 270.0f / 800.0f, 2.0f * tick_s);
    // The key is still down: no second jump before it comes up.
    state = move_player_for(state, upwards(200), ground.world, 50);
    EXPECT_EQ(state.ground, owner_world);
    state = move_player(state, {}, ground.world);
    state = move_player(state, upwards(200), ground.world);
    EXPECT_EQ(state.ground, owner_none);
}

TEST(Movement, FallsAsGravitySays) {
    const Ground ground(BoxLevel::with_floor());
    PlayerState state = place_player({0, 0, 24 + 400}, ground.world);
    int ticks = 0;
    while (state.ground == owner_none && ticks < 1000) {
        state = move_player(state, {}, ground.world);
        ++ticks;
    }
    EXPECT_NEAR(static_cast<float>(ticks) * tick_s, std::sqrt(2.0f * 400.0f / 800.0f), 2 * tick_s);
}

/// Walks against a step of a height; returns where the feet are then.
float feet_after_step(float height) {
    BoxLevel level = BoxLevel::with_floor();
    level.add_box({{100, -500, 0}, {1000, 500, height}});
    const Ground ground(level);
    const PlayerState state = move_player_for(ground.at({0, 0, 24.1f}), ahead(), ground.world, 150);
    return state.origin.z - 24.0f;
}

// Who stands may hover up to a quarter of a unit.
TEST(Movement, StepsUpEighteenUnitsAndNotNineteen) {
    EXPECT_NEAR(feet_after_step(1.0f), 1.0f, 0.25f);
    EXPECT_NEAR(feet_after_step(18.0f), 18.0f, 0.25f);
    EXPECT_NEAR(feet_after_step(19.0f), 0.0f, 0.25f);
}

TEST(Movement, FrictionStops) {
    const Ground ground(BoxLevel::with_floor());
    PlayerState state = move_player_for(ground.at({0, 0, 24.1f}), ahead(), ground.world, 100);
    const float begin = state.origin.x;
    int ticks = 0;
    while (state.velocity.x > 0.0f && ticks < 1000) {
        state = move_player(state, {}, ground.world);
        ++ticks;
    }
    // v' = -6 v down to 100 units a second, then -600: ln(3) / 6 + 1 / 6 s, and their way. Each
    // tick may be wrong by its own slowing down, 6 v dt: 6 % of the whole.
    EXPECT_NEAR(static_cast<float>(ticks) * tick_s, std::log(3.0f) / 6.0f + 1.0f / 6.0f, 0.03f);
    EXPECT_NEAR(state.origin.x - begin, 200.0f / 6.0f + 100.0f * 100.0f / 1200.0f, 2.5f);
}

TEST(Movement, SlickFloorsDoNotBrake) {
    const Ground ground(BoxLevel::with_floor(SURF_SLICK));
    PlayerState state = ground.at({0, 0, 24.1f});
    state.velocity.x = 200.0f;
    state = move_player_for(state, {}, ground.world, 100);
    EXPECT_NEAR(state.velocity.x, 200.0f, 0.01f);
}

/// A floor that rises with a slope of `degrees` from x = 0 on.
BoxLevel slope(float degrees) {
    BoxLevel level = BoxLevel::with_floor();
    const float a = glm::radians(degrees);
    const glm::vec3 normal(-std::sin(a), 0.0f, std::cos(a));
    const std::array<glm::vec4, 6> planes = {glm::vec4(normal, 0.0f), {1, 0, 0, 3000},
                                             {0, 1, 0, 500},          {0, -1, 0, 500},
                                             {0, 0, -1, 64},          {-1, 0, 0, 0}};
    level.add_brush(planes);
    return level;
}

TEST(Movement, SlopesCarryUpToFortyFiveDegrees) {
    const Ground gentle(slope(40.0f)); // normal.z = 0.77
    PlayerState up = move_player_for(gentle.at({-60, 0, 24.1f}), ahead(), gentle.world, 100);
    EXPECT_GT(up.origin.z, 120.0f);
    EXPECT_EQ(up.ground, owner_world);
    const PlayerState rest = move_player_for(up, {}, gentle.world, 200);
    EXPECT_NEAR(move_player_for(rest, {}, gentle.world, 100).origin.z, rest.origin.z, 0.01f);

    const Ground steep(slope(60.0f)); // 0.5: slides down
    PlayerState state =
        place_player({200, 0, 24 + 200 * std::tan(glm::radians(60.0f)) + 40}, steep.world);
    state = move_player_for(state, {}, steep.world, 300);
    EXPECT_LT(state.origin.x, 10.0f);
    EXPECT_NEAR(state.origin.z, 24.0f, 1.0f);
}

TEST(Movement, SwimsAtHalfSpeedAndSinks) {
    BoxLevel level = BoxLevel::with_floor();
    level.flood(2000, CONTENTS_WATER);
    const Ground ground(level);
    PlayerState state = place_player({0, 0, 1000}, ground.world);
    state = move_player_for(state, {}, ground.world, 300);
    EXPECT_EQ(state.water_level, 3);
    EXPECT_LT(state.velocity.z, -10.0f);
    EXPECT_GT(state.velocity.z, -31.0f); // half of 60, less what friction takes
    state = move_player_for(state, ahead(), ground.world, 300);
    EXPECT_LE(state.velocity.x, 150.5f);
    EXPECT_GT(state.velocity.x, 110.0f);
    state = move_player_for(state, upwards(200), ground.world, 100);
    EXPECT_GT(state.velocity.z, 50.0f);
}

TEST(Movement, LeapsOutOfWaterOverItsEdge) {
    BoxLevel level = BoxLevel::with_floor();
    level.add_box({{100, -500, 0}, {1000, 500, 200}}); // the bank, 8 over the water
    level.flood(192, CONTENTS_WATER);
    const Ground ground(level);
    PlayerCommand command = ahead();
    command.up = 200.0f;
    const PlayerState state =
        move_player_for(place_player({0, 0, 150}, ground.world), command, ground.world, 300);
    EXPECT_GT(state.origin.x, 110.0f);
    EXPECT_GT(state.origin.z, 223.0f);
}

TEST(Movement, JumpsOutOfAWedge) {
    BoxLevel level = BoxLevel::with_floor();
    const float a = glm::radians(60.0f);
    for (const float side : {-1.0f, 1.0f}) {
        // A groove along y of two slopes that nobody can stand on.
        const std::array<glm::vec4, 6> planes = {glm::vec4(-side * std::sin(a), 0, std::cos(a), 0),
                                                 {side, 0, 0, 40},
                                                 {-side, 0, 0, 0},
                                                 {0, 1, 0, 500},
                                                 {0, -1, 0, 500},
                                                 {0, 0, -1, 0}};
        level.add_brush(planes);
    }
    const Ground ground(level);
    PlayerState state =
        move_player_for(place_player({0, 0, 200}, ground.world), {}, ground.world, 300);
    const float rest = state.origin.z;
    EXPECT_GT(rest, 40.0f);
    state = move_player_for(state, upwards(200), ground.world, 20);
    EXPECT_GT(state.origin.z, rest + 20.0f);
}

TEST(Movement, ClimbsLadders) {
    BoxLevel level = BoxLevel::with_floor();
    level.add_box({{100, -64, 0}, {116, 64, 512}}, CONTENTS_SOLID | CONTENTS_LADDER);
    const Ground ground(level);
    PlayerCommand command = ahead();
    command.angles.x = -30.0f;
    PlayerState state = move_player_for(ground.at({70, 0, 24.1f}), command, ground.world, 150);
    EXPECT_TRUE(state.on_ladder);
    EXPECT_GT(state.origin.z, 150.0f);
    // Holds on without keys.
    const float height = state.origin.z;
    state = move_player_for(state, {}, ground.world, 100);
    EXPECT_GE(state.origin.z, height - 1.0f);
}

TEST(Movement, CornersAndWallsStopWithoutTrembling) {
    BoxLevel level = BoxLevel::with_floor();
    level.add_box({{100, -500, 0}, {200, 500, 200}});
    level.add_box({{-500, 100, 0}, {500, 200, 200}});
    const Ground ground(level);
    PlayerCommand command = ahead();
    command.angles.y = 40.0f;
    PlayerState state = move_player_for(ground.at({0, 0, 24.1f}), command, ground.world, 300);
    EXPECT_NEAR(state.origin.x, 84.0f, 0.1f);
    EXPECT_NEAR(state.origin.y, 84.0f, 0.1f);
    const PlayerState later = move_player_for(state, command, ground.world, 100);
    EXPECT_NEAR(glm::distance(later.origin, state.origin), 0.0f, 0.01f);
}

TEST(Movement, ConveyorsCarry) {
    BoxLevel level;
    level.add_box({{-4096, -4096, -64}, {4096, 4096, 0}}, CONTENTS_SOLID | CONTENTS_CURRENT_90);
    const Ground ground(level);
    const PlayerState state = move_player_for(ground.at({0, 0, 24.1f}), {}, ground.world, 100);
    EXPECT_NEAR(state.velocity.y, conveyor_speed, 1.0f);
}

TEST(Movement, IsAFunctionOfItsArguments) {
    const Ground ground(slope(40.0f));
    const PlayerState begin = ground.at({-60, 0, 24.1f});
    EXPECT_EQ(move_player_for(begin, ahead(), ground.world, 333),
              move_player_for(begin, ahead(), ground.world, 333));
}

} // namespace
} // namespace vigil
