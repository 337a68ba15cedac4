// SPDX-License-Identifier: GPL-2.0-or-later
// trigger_hurt: takes `dmg` health (5 by default) from who is in it, ten times a second, or once a
// second with the flag for it. Flag 1 starts off; with flag 2 each use switches it, without it uses
// switch it on or off once.
#include "game/actors/spawn_table.h"
#include "game/actors/volume.h"

namespace vigil {

namespace {

class Hurt : public Volume {
    enum Flag : uint32_t { start_off = 1, toggle = 2, slow = 16 };

public:
    Hurt(Game& game, const Entity& keys, int number)
        : Volume(game, keys, number), damage_(number_key("dmg", 5.0f, -1e6f, 1e6f)),
          pause_ticks_(ticks_of(has_flag(slow) ? 1.0f : 0.1f)), on_(!has_flag(start_off)) {}

    void use() override {
        if (used_ && !has_flag(toggle)) return;
        used_ = true;
        on_ = !on_;
    }
    void touch() override {
        if (!on_ || game().ticks() < next_at_) return;
        next_at_ = game().ticks() + pause_ticks_;
        game().hurt_player(damage_);
    }

private:
    float damage_;
    int64_t pause_ticks_;
    int64_t next_at_ = 0;
    bool on_;
    bool used_ = false;
};

} // namespace

std::unique_ptr<Actor> spawn_hurt(Game& game, const Entity& keys, int number) {
    return std::make_unique<Hurt>(game, keys, number);
}

} // namespace vigil
