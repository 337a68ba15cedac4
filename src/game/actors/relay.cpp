// SPDX-License-Identifier: GPL-2.0-or-later
// trigger_relay passes on what fires it; trigger_counter the `count`th time only (2 by default).
#include "game/actors/spawn_table.h"
#include "game/game.h"

namespace vigil {

namespace {

class Relay : public Actor {
public:
    using Actor::Actor;
    void use() override { use_targets(); }
};

class Counter : public Actor {
public:
    Counter(Game& game, const Entity& keys, int number)
        : Actor(game, keys, number), left_(number_key("count", 2.0f, 1.0f, 1e6f)) {}
    void use() override {
        if (left_ <= 0.0f) return;
        left_ -= 1.0f;
        if (left_ <= 0.0f) use_targets();
    }

private:
    float left_;
};

} // namespace

std::unique_ptr<Actor> spawn_relay(Game& game, const Entity& keys, int number) {
    return std::make_unique<Relay>(game, keys, number);
}

std::unique_ptr<Actor> spawn_counter(Game& game, const Entity& keys, int number) {
    return std::make_unique<Counter>(game, keys, number);
}

} // namespace vigil
