// SPDX-License-Identifier: GPL-2.0-or-later
// func_wall: a part of the world, or one that triggers bring and take away.
#include "game/actors/spawn_table.h"
#include "game/mover.h"

namespace vigil {

namespace {

class Wall : public Mover {
    enum Flag : uint32_t { trigger_spawn = 1, toggle = 2, start_on = 4, any = 7 };

public:
    Wall(Game& game, const Entity& keys, int number) : Mover(game, keys, number) {
        if (has_flag(any) && !has_flag(start_on)) show(false);
    }
    void use() override {
        if (!has_flag(any)) return;
        if (shown() && !has_flag(toggle)) return;
        show(!shown());
    }
};

} // namespace

std::unique_ptr<Actor> spawn_wall(Game& game, const Entity& keys, int number) {
    return std::make_unique<Wall>(game, keys, number);
}

} // namespace vigil
