// SPDX-License-Identifier: GPL-2.0-or-later
// A level of boxes that is played.
#pragma once

#include "box_level.h"
#include "game/game.h"
#include "game/mover.h"

#include <memory>
#include <string>

namespace vigil {

inline std::shared_ptr<const Level> level_of(const BoxLevel& boxes) {
    auto level = std::make_shared<Level>();
    level->name = "boxes";
    level->bsp = boxes.build();
    return level;
}

struct Play {
    explicit Play(const BoxLevel& boxes, const glm::vec3& start = {0, 0, 24.1f})
        : game(level_of(boxes), start) {}
    void run(float seconds, const PlayerCommand& command = {}) {
        for (int64_t i = 0; i < ticks_of(seconds); ++i)
            game.tick(command);
    }
    glm::vec3 place(int number) const {
        return dynamic_cast<const Mover*>(game.actor(number))->place().origin;
    }
    glm::vec3 angles(int number) const {
        return dynamic_cast<const Mover*>(game.actor(number))->place().angles;
    }
    bool shown(int number) const { return dynamic_cast<const Mover*>(game.actor(number))->shown(); }
    Game game;
};

inline PlayerCommand ahead(float yaw = 0.0f) {
    PlayerCommand command;
    command.forward = 400.0f;
    command.angles.y = yaw;
    return command;
}

inline std::string model(uint32_t number) {
    return "*" + std::to_string(number);
}

} // namespace vigil
