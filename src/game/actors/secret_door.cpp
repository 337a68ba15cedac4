// SPDX-License-Identifier: GPL-2.0-or-later
// func_door_secret: goes aside (flag 2: to the left, flag 4: down) by its width, waits a second,
// goes on along its angle by its length, and comes back the same way after `wait` (5 s by default;
// -1: stays). Opened by a shot, or, with a name and without flag 1, by use alone. Speed 50, as in
// the original.
#include "game/actors/spawn_table.h"
#include "game/game.h"
#include "game/mover.h"
#include "game/view_axes.h"

#include <glm/glm.hpp>

namespace vigil {

namespace {

constexpr float pause_s = 1.0f;

class SecretDoor : public Mover {
    enum Flag : uint32_t { always_shoot = 1, first_left = 2, first_down = 4 };

public:
    SecretDoor(Game& game, const Entity& keys, int number)
        : Mover(game, keys, number), closed_(place()), aside_(place()), open_(place()),
          wait_s_(number_key("wait", 5.0f, -1.0f, 1e6f)) {
        const Box box =
            drawn_bounds(game.bsp().models[game.collision().obstacle(obstacle()).model]);
        const ViewAxes axes =
            view_axes(keys.has("angles") ? keys.get_vec3("angles")
                                         : glm::vec3(0.0f, keys.get_float("angle"), 0.0f));
        const auto along = [&box](const glm::vec3& axis) {
            return axis * glm::abs(glm::dot(axis, box.maxs - box.mins));
        };
        if (has_flag(first_down))
            aside_.origin -= along(axes.up);
        else
            aside_.origin += has_flag(first_left) ? -along(axes.right) : along(axes.right);
        open_.origin = aside_.origin + along(axes.forward);
    }

    void use() override {
        if (state_ != State::Closed) return;
        game().set_portals_of(keys(), true);
        go(State::GoesAside, aside_);
    }
    void hurt(float damage) override {
        if (damage > 0.0f && (targetname().empty() || has_flag(always_shoot))) use();
    }
    void think() override {
        switch (state_) {
        case State::GoesAside:
            go(State::Opens, open_);
            break;
        case State::Opens:
            go(State::Closes, aside_);
            break;
        case State::Closes:
            go(State::GoesBack, closed_);
            break;
        default:
            break;
        }
    }

protected:
    void arrived() override {
        switch (state_) {
        case State::Opens:
            if (wait_s_ >= 0.0f) think_in(wait_s_);
            break;
        case State::GoesBack:
            state_ = State::Closed;
            game().set_portals_of(keys(), false);
            break;
        default:
            think_in(pause_s);
        }
    }

private:
    enum class State { Closed, GoesAside, Opens, Closes, GoesBack };

    void go(State state, const Placement& place) {
        state_ = state;
        glide_to(place, {50.0f});
    }

    Placement closed_, aside_, open_;
    float wait_s_;
    State state_ = State::Closed;
};

} // namespace

std::unique_ptr<Actor> spawn_secret_door(Game& game, const Entity& keys, int number) {
    return std::make_unique<SecretDoor>(game, keys, number);
}

} // namespace vigil
