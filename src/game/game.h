// SPDX-License-Identifier: GPL-2.0-or-later
// A level that lives: the player in it, and the entities that move, open, push and switch. It
// advances in ticks of player::tick_s; from the same level, the same commands lead to the same
// state, bit by bit. It knows nothing of pictures: who shows it asks for placements before and
// after the last tick, and for the light styles that have changed.
#pragma once

#include "game/actor.h"
#include "game/area_portals.h"
#include "game/bolts.h"
#include "game/collision_world.h"
#include "game/glows.h"
#include "game/player_movement.h"
#include "level/level.h"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vigil {

class Mover;

/// Whole ticks that `seconds` last, at least one, at most some months.
int64_t ticks_of(float seconds);

/// A brush model before and after the last tick.
struct MovedModel {
    int number = 0; ///< of the entity
    Placement before, now;
    bool shown = true;

    /// Between the two, `fraction` in 0..1.
    Placement at(float fraction) const;
};

class Game {
public:
    /// The level as it starts, with the player at `start` (an origin, not the eye). What cannot be
    /// spawned, or is not known, is logged once and left out.
    Game(std::shared_ptr<const Level> level, const glm::vec3& start);
    ~Game();
    Game(const Game&) = delete;
    Game& operator=(const Game&) = delete;

    /// One tick. While the level stands, only the player moves.
    void tick(const PlayerCommand& command, bool level_stands = false);
    int64_t ticks() const { return ticks_; }

    const Bsp& bsp() const { return level_->bsp; }
    CollisionWorld& collision() { return collision_; }
    const CollisionWorld& collision() const { return collision_; }
    AreaPortals& area_portals() { return area_portals_; }
    const AreaPortals& area_portals() const { return area_portals_; }

    const PlayerState& player() const { return player_; }
    PlayerState& player() { return player_; }
    /// Without a player nothing is touched or pushed (free flight).
    void set_player_present(bool present) { player_present_ = present; }
    /// Puts the player somewhere else; pictures do not show the way.
    void place_player_at(const glm::vec3& origin);
    /// The eye, `fraction` of the way from the last tick but one to the last.
    glm::vec3 eye_at(float fraction) const;
    /// Degrees by which something turned the view since the last call: pitch, yaw and roll to look
    /// along, or none.
    std::optional<glm::vec3> take_view();
    /// Degrees by which something that is stood on turned since the last call.
    float take_view_turn();

    std::vector<MovedModel> moved_models() const;
    const Bolts& bolts() const { return bolts_; }
    /// What has burst a moment ago; ids count from 0 in the level.
    const Glows& explosions() const { return explosions_; }

    /// A player has 100; at 0 it starts anew at the start of the level.
    static constexpr float full_health = 100.0f;
    float health() const { return health_; }
    /// How often it did.
    int deaths() const { return deaths_; }

    /// Letters a to z as in a light style, of the styles that anything has set.
    const std::map<int, std::string>& light_styles() const { return light_styles_; }
    void set_light_style(int style, std::string letters);

    // What actors ask for.

    /// Puts an obstacle at a new place with whoever is in the way or rides on it. False, and
    /// nothing has changed, where the player has no room.
    bool push(size_t obstacle, const Placement& place);
    /// Fires as an entity's keys say, after its `delay`.
    void use_targets(const Entity& keys);
    /// Without the delay.
    void use_targets_now(const Entity& keys) { fire(keys); }
    /// Opens or closes the area portals that a door's `target` names.
    void set_portals_of(const Entity& door, bool open);
    /// Takes health from the player, if there is one; negative damage heals up to full_health.
    void hurt_player(float damage);
    /// A burst with its light. The player loses `damage` less half its distance in map units, if
    /// nothing solid stands between.
    void explode(const glm::vec3& place, float damage);
    void turn_view(const glm::vec3& angles) { view_ = angles; }
    /// Actors with this `targetname`.
    std::vector<Actor*> find_actors(std::string_view targetname) const;
    /// Any entity of the level with this `targetname`, or null.
    const Entity* find_entity(std::string_view targetname) const;
    Actor* actor(int number) const;
    const std::vector<std::unique_ptr<Actor>>& actors() const { return actors_; }

    /// What a shot on this way hits first takes the damage.
    Trace shoot(const glm::vec3& from, const glm::vec3& to, float damage);

private:
    struct Delayed {
        int64_t at;
        const Entity* keys;
    };

    void spawn();
    void fire(const Entity& keys);
    void run_delayed();
    void move_player_one_tick(const PlayerCommand& command, bool level_stands);
    void touch_volumes();

    std::shared_ptr<const Level> level_;
    CollisionWorld collision_;
    AreaPortals area_portals_;
    std::vector<std::unique_ptr<Actor>> actors_;
    std::vector<Mover*> movers_;
    std::vector<Placement> before_; ///< of movers_
    std::vector<Delayed> delayed_;
    std::map<int, std::string> light_styles_;
    Bolts bolts_;
    Glows explosions_;
    uint32_t explosion_count_ = 0;
    glm::vec3 start_;
    float health_ = full_health;
    int deaths_ = 0;
    PlayerState player_, player_before_;
    bool player_present_ = true;
    std::optional<glm::vec3> view_;
    float view_turn_ = 0.0f;
    int64_t ticks_ = 0;
    int uses_ = 0;  ///< in this tick
    int depth_ = 0; ///< of targets that fire targets now
    bool uses_reported_ = false;
};

} // namespace vigil
