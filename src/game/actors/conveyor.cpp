// SPDX-License-Identifier: GPL-2.0-or-later
// func_conveyor: a solid that carries who stands on it along the current of its brushes, at the one
// speed that all currents have (player::conveyor_speed). Flag 1 starts on; a use switches it on or
// off, without flag 2 only once. What it looks like stays: its texture flows or does not.
#include "game/actors/spawn_table.h"
#include "game/game.h"
#include "game/mover.h"

namespace vigil {

namespace {

class Conveyor : public Mover {
    enum Flag : uint32_t { start_on = 1, toggle = 2 };

public:
    Conveyor(Game& game, const Entity& keys, int number) : Mover(game, keys, number) {
        run(has_flag(start_on));
    }
    void use() override {
        if (used_ && !has_flag(toggle)) return;
        used_ = true;
        run(!game().collision().obstacle(obstacle()).flows);
    }

private:
    void run(bool flows) { game().collision().obstacle(obstacle()).flows = flows; }

    bool used_ = false;
};

} // namespace

std::unique_ptr<Actor> spawn_conveyor(Game& game, const Entity& keys, int number) {
    return std::make_unique<Conveyor>(game, keys, number);
}

} // namespace vigil
