// SPDX-License-Identifier: GPL-2.0-or-later
// func_button: pressed by who runs into it, or by a shot where it has `health`; goes in, fires, and
// comes back after `wait`. The original's defaults: speed 40, wait 3 s, lip 4.
#include "game/actors/spawn_table.h"
#include "game/game.h"
#include "game/mover.h"

namespace vigil {

namespace {

class Button : public Mover {
public:
    Button(Game& game, const Entity& keys, int number)
        : Mover(game, keys, number), out_(place()),
          in_(place()), speed_{number_key("speed", 40.0f, 1.0f, 1e5f)},
          wait_s_(number_key("wait", 3.0f, -1.0f, 1e6f)), health_(keys.get_float("health")) {
        constexpr float usual_lip = 4.0f;
        const uint32_t model = game.collision().obstacle(obstacle()).model;
        in_.origin += sliding_way(game.bsp().models[model], keys, usual_lip);
    }

    void bump() override {
        if (keys().get_float("health") <= 0.0f && targetname().empty()) press();
    }
    void use() override { press(); }
    void hurt(float damage) override {
        if (health_ <= 0.0f) return;
        health_ -= damage;
        if (health_ <= 0.0f) press();
    }
    void think() override {
        glide_to(out_, speed_);
        health_ = keys().get_float("health");
    }

protected:
    void arrived() override {
        if (!pressed_) return;
        if (place().origin != in_.origin) {
            pressed_ = false;
            return;
        }
        use_targets();
        if (wait_s_ >= 0.0f) think_in(wait_s_);
    }

private:
    void press() {
        if (pressed_) return;
        pressed_ = true;
        glide_to(in_, speed_);
    }

    Placement out_, in_;
    GlideSpeed speed_;
    float wait_s_;
    float health_;
    bool pressed_ = false; ///< until it is out again
};

} // namespace

std::unique_ptr<Actor> spawn_button(Game& game, const Entity& keys, int number) {
    return std::make_unique<Button>(game, keys, number);
}

} // namespace vigil
