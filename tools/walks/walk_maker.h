// SPDX-License-Identifier: GPL-2.0-or-later
// Makes a walk through a level: plays it, and again and again looks where one can get from here
// (reach.h), chooses what to do there (press or shoot a button, ride a lift, pass a teleporter, see
// a part of the level that it has not seen), goes there and writes down the keys. Closed doors that
// open by themselves count as open; before one it waits. Same level, same walk.
#pragma once

#include "client/play/walk.h"
#include "game/game.h"
#include "walks/reach.h"

#include <memory>
#include <set>
#include <string>
#include <vector>

namespace vigil::walks {

struct MakerOptions {
    float seconds = 60.0f; ///< about as long as the walk is to be
    int legs = 24;         ///< most goals
    bool verbose = false;  ///< prints each goal
};

class WalkMaker {
public:
    WalkMaker(std::shared_ptr<const Level> level, const MakerOptions& options);
    client::Walk make();

private:
    /// Ticks that are to come, and where the player is after each.
    struct Plan {
        std::vector<PlayerCommand> commands;
        std::vector<glm::vec3> places;
        PlayerState end;
        bool complete = false;
    };
    /// Something worth going to.
    struct Goal {
        int place = 0;  ///< of the reach
        int actor = -1; ///< number of what is there, -1: a place to see
        bool press = false;
        bool shoot = false;
        bool ride = false;
        std::string name;
    };
    enum class Outcome { Arrived, Blocked, Astray };

    CollisionWorld open_world() const;
    Reach::Verdict judge(const PlayerState& state) const;
    std::vector<Goal> goals(const Reach& reach) const;
    /// The place that lies farthest from what was seen.
    Goal farthest(const Reach& reach) const;
    Plan plan(const Reach& reach, int place, const CollisionWorld& world) const;
    bool steer(Plan& plan, const PlayerState& goal, const CollisionWorld& world) const;
    /// Lets the eye follow the way smoothly.
    void smooth(Plan& plan, const CollisionWorld& world) const;
    Outcome follow(const Plan& plan);
    bool go(const Reach& reach, const Goal& goal);
    void press(int actor);
    /// Whether a shot from here, aimed at its middle, hits it.
    bool can_shoot(const PlayerState& state, const Mover& target) const;
    void shoot(int actor);
    void ride();
    /// No keys.
    void rest(int ticks);
    void tick(const PlayerCommand& command);
    bool over() const;

    std::shared_ptr<const Level> level_;
    MakerOptions options_;
    Game game_;
    client::Walk walk_;
    float view_ = 0.0f;  ///< yaw
    std::set<int> done_; ///< actors that need no more visits
    std::vector<glm::vec3> seen_;
};

} // namespace vigil::walks
