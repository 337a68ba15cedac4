// SPDX-License-Identifier: GPL-2.0-or-later
// func_plat: a lift drawn at its top. It waits below, goes up with who steps on it, and comes down
// three seconds later. One with a name waits above until it is used. The original's `speed` is in
// units per tenth of a second (20 by default, keys a tenth of what they say), so are `accel` and
// `decel` (5).
#include "game/actors/spawn_table.h"
#include "game/game.h"
#include "game/mover.h"

#include <glm/glm.hpp>

namespace vigil {

namespace {

constexpr uint32_t low_trigger = 1;
constexpr float top_wait_s = 3.0f, stay_s = 1.0f;
constexpr float usual_speed = 200.0f, usual_acceleration = 500.0f;
constexpr float usual_lip = 8.0f;

class Plat : public Mover {
public:
    Plat(Game& game, const Entity& keys, int number)
        : Mover(game, keys, number), top_(place()), bottom_(place()),
          speed_{number_key("speed", usual_speed, 1.0f, 1e5f),
                 // A key counts as a tenth per frame: ten times as much in a second squared.
                 10.0f * number_key("accel", 0.1f * usual_acceleration, 0.1f, 1e5f),
                 10.0f * number_key("decel", 0.1f * usual_acceleration, 0.1f, 1e5f)} {
        const uint32_t model = game.collision().obstacle(obstacle()).model;
        const Box box = drawn_bounds(game.bsp().models[model]);
        lip_ = number_key("lip", usual_lip, -1e5f, 1e5f);
        bottom_.origin.z -= number_key("height", box.maxs.z - box.mins.z - lip_, -1e5f, 1e5f);
        trigger_ = trigger_over({box.mins + top_.origin, box.maxs + top_.origin});
        if (targetname().empty()) {
            put(bottom_);
            state_ = State::Bottom;
        }
    }

    std::optional<Box> volume() const override {
        return targetname().empty() || state_ != State::Waiting ? std::optional(trigger_)
                                                                : std::nullopt;
    }
    void touch() override {
        if (state_ == State::Bottom)
            go(State::Up);
        else if (state_ == State::Top)
            think_in(stay_s); // not yet
    }
    void use() override {
        if (state_ == State::Waiting || state_ == State::Top) go(State::Down);
    }
    void think() override { go(State::Down); }

protected:
    void arrived() override {
        state_ = state_ == State::Up ? State::Top : State::Bottom;
        if (state_ == State::Top) think_in(top_wait_s);
    }
    void blocked() override { go(state_ == State::Up ? State::Down : State::Up); }

private:
    enum class State { Waiting, Up, Top, Down, Bottom };

    void go(State state) {
        forget_thought();
        state_ = state;
        glide_to(state == State::Up ? top_ : bottom_, speed_);
    }

    /// From below its lowest place to a little over its top, a step inside its edges.
    Box trigger_over(const Box& box) const {
        constexpr float inset = 25.0f, over = 8.0f;
        Box trigger{box.mins + inset, box.maxs - inset};
        trigger.maxs.z = box.maxs.z + over;
        trigger.mins.z = trigger.maxs.z - (top_.origin.z - bottom_.origin.z + lip_);
        if (has_flag(low_trigger)) trigger.maxs.z = trigger.mins.z + over;
        for (size_t axis = 0; axis < 2; ++axis) {
            if (trigger.mins[axis] < trigger.maxs[axis]) continue;
            trigger.mins[axis] = 0.5f * (box.mins[axis] + box.maxs[axis]);
            trigger.maxs[axis] = trigger.mins[axis] + 1.0f;
        }
        return trigger;
    }

    Placement top_, bottom_;
    GlideSpeed speed_;
    float lip_ = usual_lip;
    Box trigger_;
    State state_ = State::Waiting;
};

} // namespace

std::unique_ptr<Actor> spawn_plat(Game& game, const Entity& keys, int number) {
    return std::make_unique<Plat>(game, keys, number);
}

} // namespace vigil
