// SPDX-License-Identifier: GPL-2.0-or-later
// What happens on a scripted walk through a level, tick by tick and without a renderer: where it
// ends, which doors it opens, and what a walk must not do: stand in a wall, leave the level, get
// stuck, die.
#pragma once

#include "client/play/walk.h"
#include "game/player_movement.h"
#include "level/level.h"

#include <memory>
#include <string>

namespace vigil::walks {

struct WalkReport {
    PlayerState end;
    int ticks = 0;
    int doors_opened = 0;     ///< that were closed when the level started; each once
    int longest_in_solid = 0; ///< ticks in a row; rounding alone makes one or two
    int outside = 0;          ///< ticks with the eye outside of the level
    int longest_stuck = 0;    ///< ticks in a row with keys pressed and no way made
    int longest_rest = 0;     ///< ticks in a row at one place, keys or none
    int deaths = 0;
    double way = 0.0;      ///< map units, without jumps from place to place
    double distance = 0.0; ///< the farthest from the start

    std::string text() const;
};

/// The origin of a player who starts this level: as the program has it.
glm::vec3 start_origin(const Bsp& bsp);

WalkReport report_walk(const std::shared_ptr<const Level>& level, const client::Walk& walk);

/// What the first comment of a walk says about its end, written and read by the two below.
struct WalkGoal {
    glm::vec3 place{0.0f};
    int doors = 0;
};
std::string goal_text(const WalkGoal& goal);
/// Throws Error where `text` has no such comment.
WalkGoal read_goal(std::string_view name, const std::string& text);

} // namespace vigil::walks
