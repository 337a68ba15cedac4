// SPDX-License-Identifier: GPL-2.0-or-later
// What the entity text of a level puts into the picture, and the light styles.
#include "client/play/level_entities.h"
#include "client/play/light_styles.h"
#include "common/error.h"
#include "formats/small_level.h"

#include <gtest/gtest.h>

#include <vector>

namespace vigil::client {
namespace {

Bsp level_with(std::string_view entities) {
    LevelLumps lumps = small_level();
    lumps[level_entities].clear();
    append_text(lumps[level_entities], entities, entities.size() + 1);
    return parse_bsp("test", write_level(lumps));
}

constexpr std::string_view world = "{ classname worldspawn }\n";

struct Models {
    std::vector<std::string> names;
    RegisterModel function() {
        return [this](std::string_view name) {
            if (name.find("broken") != std::string_view::npos) fail("{}: broken", name);
            names.emplace_back(name);
            return static_cast<refresh::ModelHandle>(names.size()) - 1;
        };
    }
};

TEST(LevelEntities, PlacesBrushModelsAndMiscModels) {
    const Bsp bsp = level_with(std::string(world) +
                               R"({ classname func_door model "*1" origin "1 2 3" angle 90 }
{ classname misc_model model "models/statue.glb" origin "5 6 7" angles "1 2 3" frame 4 skin 2 }
{ classname func_rotating model "*1" angles "0 45 0" })");
    Models models;
    const LevelEntities level(bsp, models.function());
    ASSERT_EQ(level.entities().size(), 3u);
    const refresh::Entity& door = level.entities()[0];
    EXPECT_EQ(door.number, 1);
    EXPECT_EQ(door.origin, glm::vec3(1, 2, 3));
    EXPECT_EQ(door.angles, glm::vec3(0)); // a door's angle is where it moves
    const refresh::Entity& statue = level.entities()[1];
    EXPECT_EQ(statue.origin, glm::vec3(5, 6, 7));
    EXPECT_EQ(statue.angles, glm::vec3(1, 2, 3));
    EXPECT_EQ(statue.frame, 4);
    EXPECT_EQ(statue.skin, 2);
    EXPECT_EQ(level.entities()[2].angles, glm::vec3(0, 45, 0));
    EXPECT_EQ(models.names, (std::vector<std::string>{"*1", "models/statue.glb", "*1"}));
}

TEST(LevelEntities, LeavesOutWhatIsNotSeen) {
    const Bsp bsp = level_with(std::string(world) + R"({ classname trigger_once model "*1" }
{ classname func_areaportal model "*1" }
{ classname func_wall model "*1" spawnflags 1 }
{ classname func_wall model "*1" spawnflags 5 }
{ classname func_explosive model "*1" spawnflags 1 }
{ classname misc_model model "models/broken.md2" }
{ classname monster_ogre model "models/ogre.md2" }
{ classname func_wall model "" })");
    Models models;
    const LevelEntities level(bsp, models.function());
    ASSERT_EQ(level.entities().size(), 3u);
    // What waits for a trigger is there, but nothing is drawn.
    EXPECT_EQ(level.entities()[0].number, 3);
    EXPECT_EQ(level.entities()[0].model, -1);
    EXPECT_EQ(level.entities()[1].number, 4); // triggered, but starts on
    EXPECT_GE(level.entities()[1].model, 0);
    EXPECT_EQ(level.entities()[2].model, -1);
}

TEST(LevelEntities, ShowsAndHidesByNumber) {
    const Bsp bsp =
        level_with(std::string(world) + R"({ classname func_wall model "*1" spawnflags 1 }
{ classname func_wall model "*1" origin "1 2 3" })");
    Models models;
    LevelEntities level(bsp, models.function());
    EXPECT_TRUE(level.place(1, {4, 5, 6}, {0, 90, 0}, true));
    EXPECT_FALSE(level.place(1, {4, 5, 6}, {0, 90, 0}, true)); // as it was
    EXPECT_EQ(level.entities()[0].model, 0);
    EXPECT_EQ(level.entities()[0].origin, glm::vec3(4, 5, 6));
    EXPECT_TRUE(level.place(2, {1, 2, 3}, {}, false));
    EXPECT_EQ(level.entities()[1].model, -1);
    EXPECT_FALSE(level.place(7, {}, {}, true));
}

TEST(LevelEntities, TurnsByTargetName) {
    const Bsp bsp = level_with(std::string(world) +
                               R"({ classname func_wall model "*1" targetname lamp }
{ classname func_wall model "*1" targetname lamp }
{ classname func_wall model "*1" targetname other })");
    Models models;
    LevelEntities level(bsp, models.function());
    EXPECT_EQ(level.targets(), (std::vector<std::string>{"lamp", "other"}));
    level.turn("lamp", {0, 30, 0});
    EXPECT_EQ(level.entities()[0].angles.y, 30.0f);
    EXPECT_EQ(level.entities()[1].angles.y, 30.0f);
    EXPECT_EQ(level.entities()[2].angles.y, 0.0f);
    EXPECT_THROW(level.turn("nobody", {}), Error);
}

TEST(FindStart, PrefersThePlayerStart) {
    const std::string deathmatch = "{ classname info_player_deathmatch origin \"9 9 9\" }\n";
    const std::string player = "{ classname info_player_start origin \"1 2 3\" angle 90 }\n";
    const StartPlace single = find_start(level_with(std::string(world) + deathmatch + player));
    EXPECT_EQ(single.origin, glm::vec3(1, 2, 25));
    EXPECT_EQ(single.angles, glm::vec3(0, 90, 0));
    EXPECT_EQ(find_start(level_with(std::string(world) + deathmatch)).origin, glm::vec3(9, 9, 31));
}

TEST(FindStart, FallsBackToAPlaceInsideTheLevel) {
    const Bsp bsp = level_with(world);
    const StartPlace start = find_start(bsp);
    bool inside = false;
    for (const BspLeaf& leaf : bsp.leafs) {
        inside |= leaf.cluster >= 0 && glm::all(glm::lessThanEqual(leaf.mins, start.origin)) &&
                  glm::all(glm::lessThanEqual(start.origin, leaf.maxs));
    }
    EXPECT_TRUE(inside);
}

TEST(LightStyles, FlickerTenTimesASecond) {
    LightStyles styles;
    styles.set_pattern(5, "amz");
    EXPECT_EQ(styles.values_at(0.0)[5], 0.0f);
    EXPECT_EQ(styles.values_at(0.1)[5], 1.0f);
    EXPECT_EQ(styles.values_at(0.199)[5], 1.0f);
    EXPECT_NEAR(styles.values_at(0.2)[5], 25.0f / 12.0f, 1e-6f);
    EXPECT_EQ(styles.values_at(0.3)[5], 0.0f);
    EXPECT_EQ(styles.values_at(1e7)[0], 1.0f);
    // The clock of a headless run reaches each tenth after six frames exactly.
    EXPECT_EQ(styles.values_at(6 * (1.0 / 60.0))[5], 1.0f);
}

TEST(LightStyles, SwitchedLightsStartAsTheirEntitiesSay) {
    const Bsp bsp = level_with(std::string(world) + R"({ classname light style 33 spawnflags 1 }
{ classname light style 34 }
{ classname light_spot style 35 spawnflags 1 }
{ classname func_wall style 36 spawnflags 1 }
{ classname light style 7 spawnflags 1 }
{ classname light style 4711 spawnflags 1 })");
    const LightStyles styles(bsp.entities);
    const auto values = styles.values_at(0.0);
    EXPECT_EQ(values[33], 0.0f);
    EXPECT_EQ(values[34], 1.0f);
    EXPECT_EQ(values[35], 0.0f);
    EXPECT_EQ(values[36], 1.0f);
    EXPECT_EQ(values[63], 0.0f);
    EXPECT_EQ(values[255], 1.0f);
}

TEST(LightStyles, RefusesWhatIsNoStyle) {
    LightStyles styles;
    EXPECT_THROW(styles.set_pattern(256, "m"), Error);
    EXPECT_THROW(styles.set_pattern(-1, "m"), Error);
    EXPECT_THROW(styles.set_pattern(1, "m2"), Error);
    EXPECT_THROW(styles.set_value(1, -0.5f), Error);
    styles.set_value(1, 0.25f);
    EXPECT_EQ(styles.values_at(12.3)[1], 0.25f);
    EXPECT_EQ(styles.text(1), "0.25");
}

} // namespace
} // namespace vigil::client
