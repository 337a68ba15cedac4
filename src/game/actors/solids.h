// SPDX-License-Identifier: GPL-2.0-or-later
// Brush models that stand in the level, turn in place, go or fall: func_wall, func_conveyor,
// func_rotating, func_explosive, func_object.
#pragma once

#include "game/game.h"
#include "game/mover.h"

#include <algorithm>

namespace vigil::actors {

/// func_wall: a part of the world, or one that triggers bring and take away.
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

/// func_conveyor: a solid that carries who stands on it along the current of its brushes, at the
/// one speed that all currents have (player::conveyor_speed). Flag 1 starts on; a use switches it
/// on or off, without flag 2 only once. What it looks like stays: its texture flows or does not.
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

/// func_rotating: turns for ever around an axis of its own, switched by use. Degrees per second,
/// 100 by default.
class Rotating : public Mover {
    enum Flag : uint32_t { start_on = 1, reverse = 2, x_axis = 4, y_axis = 8 };

public:
    Rotating(Game& game, const Entity& keys, int number) : Mover(game, keys, number) {
        const float speed = number_key("speed", 100.0f, -1e5f, 1e5f);
        const size_t axis = has_flag(x_axis) ? 2 : has_flag(y_axis) ? 0 : 1;
        velocity_[axis] = has_flag(reverse) ? -speed : speed;
        put({place().origin, keys.get_model_angles()});
    }
    void begin() override {
        if (has_flag(start_on)) spin(velocity_);
    }
    void use() override { spin(spinning() ? glm::vec3(0.0f) : velocity_); }

private:
    glm::vec3 velocity_{0.0f};
};

/// func_explosive: gone once it is shot (`health`, 100 by default) or, with a name, used; then it
/// fires its targets. With `dmg` it bursts with light and hurts the player nearby. With the flag
/// for it, it is not there until the first use.
class Explosive : public Mover {
    static constexpr uint32_t trigger_spawn = 1; // of the flags

public:
    Explosive(Game& game, const Entity& keys, int number)
        : Mover(game, keys, number, 100.0f), damage_(number_key("dmg", 0.0f, 0.0f, 1e6f)) {
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
        if (breaks(damage)) explode();
    }

private:
    void explode() {
        const Box box = game().collision().bounds(obstacle());
        remove(); // first: its targets may name it
        if (damage_ > 0.0f) game().explode(0.5f * (box.mins + box.maxs), damage_);
        use_targets();
    }

    float damage_;
};

/// func_object: falls when what holds it up is gone, from the first moments of the level on; with
/// flag 1 it is not there until it is used. It rests on the world and on other movers by its
/// bounds, and hurts (`dmg`, 100 by default) the player it cannot push aside.
class Object : public Mover {
    static constexpr uint32_t trigger_spawn = 1; // of the flags
    static constexpr float release_s = 0.2f;
    /// From the drawn bounds, which are a unit wider, to those that it rests by: a hair narrower
    /// than it is, so that it falls through the hole that it fills.
    static constexpr float inset = 1.25f;

public:
    Object(Game& game, const Entity& keys, int number)
        : Mover(game, keys, number), damage_(number_key("dmg", 100.0f, 0.0f, 1e6f)) {
        const Box drawn = drawn_bounds(model());
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

} // namespace vigil::actors
