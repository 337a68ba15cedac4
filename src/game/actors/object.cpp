// SPDX-License-Identifier: GPL-2.0-or-later
// func_object: falls when what holds it up is gone, from the first moments of the level on; with
// flag 1 it is not there until it is used. It rests on the world and on other movers by its bounds,
// and hurts (`dmg`, 100 by default) the player it cannot push aside.
#include "game/actors/spawn_table.h"
#include "game/game.h"
#include "game/mover.h"

#include <algorithm>

namespace vigil {

namespace {

constexpr float release_s = 0.2f;
/// From the drawn bounds, which are a unit wider, to those that it rests by: a hair narrower than
/// it is, so that it falls through the hole that it fills.
constexpr float inset = 1.25f;

class Object : public Mover {
    static constexpr uint32_t trigger_spawn = 1; // of the flags

public:
    Object(Game& game, const Entity& keys, int number)
        : Mover(game, keys, number), damage_(number_key("dmg", 100.0f, 0.0f, 1e6f)) {
        const Box drawn =
            drawn_bounds(game.bsp().models[game.collision().obstacle(obstacle()).model]);
        const glm::vec3 middle = 0.5f * (drawn.mins + drawn.maxs);
        box_ = {glm::min(drawn.mins + inset, middle), glm::max(drawn.maxs - inset, middle)};
        if (has_flag(trigger_spawn)) show(false);
    }

    void begin() override {
        if (shown()) think_in(release_s);
    }
    void use() override {
        if (shown()) return;
        show(true);
        released_ = true;
    }
    void think() override { released_ = true; }

    void tick() override {
        if (!released_ || removed()) return;
        speed_ = std::min(speed_ + player::gravity * player::tick_s, player::fastest);
        const Placement old = place();
        const glm::vec3 down(0.0f, 0.0f, -speed_ * player::tick_s);
        const Trace way = game().collision().trace_without(obstacle(), old.origin,
                                                           old.origin + down, box_, mask_shot);
        if (way.hit()) speed_ = 0.0f;
        if (way.start_solid || way.end == old.origin) return;
        if (game().push(obstacle(), {way.end, old.angles})) return;
        speed_ = 0.0f;
        game().hurt_player(damage_);
    }

private:
    float damage_;
    Box box_;
    float speed_ = 0.0f; ///< downwards
    bool released_ = false;
};

} // namespace

std::unique_ptr<Actor> spawn_object(Game& game, const Entity& keys, int number) {
    return std::make_unique<Object>(game, keys, number);
}

} // namespace vigil
