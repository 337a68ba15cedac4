// SPDX-License-Identifier: GPL-2.0-or-later
// func_explosive: gone once it is shot (`health`, 100 by default) or, with a name, used; then it
// fires its targets. With `dmg` it bursts with light and hurts the player nearby. With the flag for
// it, it is not there until the first use.
#include "game/actors/spawn_table.h"
#include "game/game.h"
#include "game/mover.h"

namespace vigil {

namespace {

class Explosive : public Mover {
    static constexpr uint32_t trigger_spawn = 1; // of the flags

public:
    Explosive(Game& game, const Entity& keys, int number)
        : Mover(game, keys, number), health_(number_key("health", 100.0f, 1.0f, 1e9f)),
          damage_(number_key("dmg", 0.0f, 0.0f, 1e6f)) {
        if (has_flag(trigger_spawn)) show(false);
    }
    void use() override {
        if (shown())
            explode();
        else
            show(true);
    }
    void hurt(float damage) override {
        // One with a name only falls to what targets it.
        if (!targetname().empty() && !has_flag(trigger_spawn)) return;
        health_ -= damage;
        if (health_ <= 0.0f) explode();
    }

private:
    void explode() {
        const Box box = game().collision().bounds(obstacle());
        remove(); // first: its targets may name it
        if (damage_ > 0.0f) game().explode(0.5f * (box.mins + box.maxs), damage_);
        use_targets();
    }

    float health_, damage_;
};

} // namespace

std::unique_ptr<Actor> spawn_explosive(Game& game, const Entity& keys, int number) {
    return std::make_unique<Explosive>(game, keys, number);
}

} // namespace vigil
