// SPDX-License-Identifier: GPL-2.0-or-later
// A walker who wanders at random through levels that compilers made, jumping, crouching and
// shooting: it never leaves the level, never ends in a solid, and never stays stuck.
#include "formats/real_levels.h"
#include "game/game.h"
#include "game/mover.h"

#include <glm/glm.hpp>
#include <gtest/gtest.h>

#include <random>
#include <set>

namespace vigil {
namespace {

std::shared_ptr<const Level> load(const std::filesystem::path& path) {
    auto level = std::make_shared<Level>();
    level->name = path.stem().string();
    level->bsp = parse_bsp(level->name, read_file(path));
    return level;
}

std::filesystem::path shipped(const std::string& name) {
    return std::filesystem::path(VIGIL_SOURCE_DIR) / "baseq2" / "maps" / (name + ".bsp");
}

glm::vec3 start_of(const Level& level) {
    for (const Entity& entity : level.bsp.entities)
        if (entity.classname() == "info_player_start") return entity.get_vec3("origin");
    return glm::vec3(0.0f);
}

PlayerCommand any_command(std::mt19937& random, const PlayerCommand& before) {
    const auto between = [&](float low, float high) {
        return std::uniform_real_distribution<float>(low, high)(random);
    };
    PlayerCommand command;
    command.angles.x = between(-40, 40);
    command.angles.y =
        between(0, 1) < 0.3f ? between(-180, 180) : before.angles.y + between(-40, 40);
    command.forward = 400.0f;
    command.side = between(0, 1) < 0.2f ? between(-400, 400) : 0.0f;
    command.up = between(0, 1) < 0.3f ? 400.0f : between(0, 1) < 0.1f ? -400.0f : 0.0f;
    command.attack = between(0, 1) < 0.2f;
    return command;
}

/// Wanders for `ticks`.
void wander(const std::shared_ptr<const Level>& level, int ticks, unsigned seed) {
    SCOPED_TRACE(level->name);
    Game game(level, start_of(*level));
    std::mt19937 random(seed);
    PlayerCommand command;
    std::set<std::array<int, 3>> cells;
    int still = 0, in_solid = 0;
    glm::vec3 last(0.0f);
    for (int i = 0; i < ticks; ++i) {
        constexpr int ticks_per_command = 50;
        if (i % ticks_per_command == 0) command = any_command(random, command);
        game.tick(command);
        const PlayerState& player = game.player();
        ASSERT_GT(player.origin.z, level->bsp.models[0].mins.z - 64.0f) << "tick " << i;
        // Rounding may leave it inside by a hair for a tick.
        const bool is_free =
            game.collision().is_free(player.origin, player.box(), mask_player_solid);
        in_solid = is_free ? 0 : in_solid + 1;
        ASSERT_LT(in_solid, 3) << "tick " << i;
        still = glm::distance(player.origin, last) < 4.0f ? still + 1 : 0;
        if (still == 0) last = player.origin;
        // Some commands push into corners; forty in a row do not.
        ASSERT_LT(still, 40 * ticks_per_command) << "stuck at tick " << i;
        const glm::ivec3 cell = glm::floor(player.origin / 64.0f);
        cells.insert({cell.x, cell.y, cell.z});
    }
    EXPECT_GT(cells.size(), 30u);
}

TEST(LevelWalk, WandersThroughShippedLevels) {
    for (const char* name : {"warehouse", "mine", "gallery", "ring", "yard", "room", "many_1000"})
        for (const unsigned seed : {1u, 2u})
            wander(load(shipped(name)), 12000, seed);
}

TEST(LevelWalk, WandersThroughRealLevels) {
    const auto folder = real_levels_folder();
    if (!folder) GTEST_SKIP() << "the real levels are not here";
    for (const RealLevel& real : real_levels)
        for (const unsigned seed : {1u, 2u})
            wander(load(*folder / "baseq2" / "maps" / (std::string(real.name) + ".bsp")), 12000,
                   seed);
}

TEST(LevelWalk, DoorOfTheWarehouseOpensAndCloses) {
    const auto level = load(shipped("warehouse"));
    Game game(level, start_of(*level));
    const std::vector<Actor*> doors = game.find_actors("boiler_door");
    ASSERT_EQ(doors.size(), 1u);
    const auto& door = dynamic_cast<const Mover&>(*doors[0]);
    const glm::vec3 closed = door.place().origin;
    doors[0]->use();
    float highest = closed.z;
    for (int i = 0; i < 20 * player::ticks_per_second; ++i) {
        game.tick({});
        highest = std::max(highest, door.place().origin.z);
    }
    EXPECT_GT(highest, closed.z + 50.0f);
    EXPECT_EQ(door.place().origin, closed);
}

/// Every button of a real level is pressed and every door used: all that move come to rest where
/// they began, or stay open by their keys.
TEST(LevelWalk, EverythingUsedAtOnceEnds) {
    const auto folder = real_levels_folder();
    if (!folder) GTEST_SKIP() << "the real levels are not here";
    for (const RealLevel& real : real_levels) {
        const auto level = load(*folder / "baseq2" / "maps" / (std::string(real.name) + ".bsp"));
        Game game(level, start_of(*level));
        for (const auto& actor : game.actors())
            if (!actor->removed()) actor->use();
        for (int i = 0; i < 30 * player::ticks_per_second; ++i)
            game.tick({});
        for (const MovedModel& model : game.moved_models())
            for (size_t axis = 0; axis < 3; ++axis)
                EXPECT_LT(std::abs(model.now.origin[axis]), 16384.0f) << real.name;
    }
}

} // namespace
} // namespace vigil
