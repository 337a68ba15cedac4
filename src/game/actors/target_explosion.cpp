// SPDX-License-Identifier: GPL-2.0-or-later
// target_explosion: bursts at its place when it is used, after its `delay`, and then fires its
// targets. `dmg` hurts the player nearby; without it there is light alone.
#include "game/actors/spawn_table.h"
#include "game/game.h"
#include "game/mover.h"

namespace vigil {

namespace {

class TargetExplosion : public Actor {
public:
    TargetExplosion(Game& game, const Entity& keys, int number)
        : Actor(game, keys, number), damage_(number_key("dmg", 0.0f, 0.0f, 1e6f)),
          delay_s_(number_key("delay", 0.0f, 0.0f, 1e6f)) {}

    void use() override {
        if (delay_s_ > 0.0f)
            think_in(delay_s_);
        else
            think();
    }
    void think() override {
        game().explode(origin_of(keys()), damage_);
        // The delay has passed; use_targets would wait for it once more.
        game().use_targets_now(keys());
    }

private:
    float damage_, delay_s_;
};

} // namespace

std::unique_ptr<Actor> spawn_target_explosion(Game& game, const Entity& keys, int number) {
    return std::make_unique<TargetExplosion>(game, keys, number);
}

} // namespace vigil
