// SPDX-License-Identifier: GPL-2.0-or-later
// Brush models that glide between places: func_button, func_plat, func_train, func_door_secret.
#pragma once

#include "common/log.h"
#include "game/game.h"
#include "game/mover.h"
#include "game/view_axes.h"

#include <glm/glm.hpp>

namespace vigil::actors {

/// func_button: pressed by who runs into it, or by a shot where it has `health`; goes in, fires,
/// and comes back after `wait`. The original's defaults: speed 40, wait 3 s, lip 4.
class Button : public Mover {
public:
    Button(Game& game, const Entity& keys, int number)
        : Mover(game, keys, number), out_(place()),
          in_(place()), speed_{number_key("speed", 40.0f, 1.0f, 1e5f)},
          wait_s_(number_key("wait", 3.0f, -1.0f, 1e6f)) {
        constexpr float usual_lip = 4.0f;
        in_.origin += sliding_way(model(), keys, usual_lip);
    }

    void bump() override {
        if (!is_breakable() && targetname().empty()) press();
    }
    void use() override { press(); }
    void hurt(float damage) override {
        if (breaks(damage)) press();
    }
    void think() override {
        glide_to(out_, speed_);
        mend();
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
    bool pressed_ = false; ///< until it is out again
};

/// func_plat: a lift drawn at its top. It waits below, goes up with who steps on it, and comes down
/// three seconds later. One with a name waits above until it is used. The original's `speed` is in
/// units per tenth of a second (20 by default, keys a tenth of what they say), so are `accel` and
/// `decel` (5).
class Plat : public Mover {
    static constexpr uint32_t low_trigger = 1; // of the flags
    static constexpr float top_wait_s = 3.0f, stay_s = 1.0f;
    static constexpr float usual_speed = 200.0f, usual_acceleration = 500.0f, usual_lip = 8.0f;

public:
    Plat(Game& game, const Entity& keys, int number)
        : Mover(game, keys, number), top_(place()), bottom_(place()),
          speed_{number_key("speed", usual_speed, 1.0f, 1e5f),
                 // A key counts as a tenth per frame: ten times as much in a second squared.
                 10.0f * number_key("accel", 0.1f * usual_acceleration, 0.1f, 1e5f),
                 10.0f * number_key("decel", 0.1f * usual_acceleration, 0.1f, 1e5f)} {
        const Box box = drawn_bounds(model());
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

/// func_door_secret: goes aside (flag 2: to the left, flag 4: down) by its width, waits a second,
/// goes on along its angle by its length, and comes back the same way after `wait` (5 s by default;
/// -1: stays). Opened by a shot, or, with a name and without flag 1, by use alone. Speed 50, as in
/// the original.
class SecretDoor : public Mover {
    enum Flag : uint32_t { always_shoot = 1, first_left = 2, first_down = 4 };
    static constexpr float pause_s = 1.0f;

public:
    SecretDoor(Game& game, const Entity& keys, int number)
        : Mover(game, keys, number), closed_(place()), aside_(place()), open_(place()),
          wait_s_(number_key("wait", 5.0f, -1.0f, 1e6f)) {
        const Box box = drawn_bounds(model());
        const ViewAxes axes = view_axes(keys.get_angles());
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

/// func_train: goes from path_corner to path_corner; its lowest corner touches them. A corner's
/// `wait` holds it up (-1: until it is used), its `pathtarget` is fired, its flag 1 lets it jump
/// there. Units per second, 100 by default.
class Train : public Mover {
    enum Flag : uint32_t { start_on = 1, toggle = 2 };
    static constexpr uint32_t teleport = 1; // of a corner
    /// Corners that jump to each other in a circle would never end.
    static constexpr int most_jumps = 64;

public:
    Train(Game& game, const Entity& keys, int number)
        : Mover(game, keys, number), speed_{number_key("speed", 100.0f, 1.0f, 1e5f)} {
        corner_to_origin_ = -drawn_bounds(model()).mins - 1.0f;
    }

    void begin() override {
        next_ = game().find_entity(keys().get_string("target"));
        if (next_ == nullptr) {
            log_warning("entity {} (func_train) stands still: its target is not there", number());
            return;
        }
        put(at(*next_));
        next_ = game().find_entity(next_->get_string("target"));
        if (targetname().empty() || has_flag(start_on)) think_in(0.0f);
    }
    void think() override { leave(); }
    void use() override {
        if (running_ && !has_flag(toggle)) return;
        if (running_ && (gliding() || is_thinking())) {
            running_ = false;
            stop_gliding();
            forget_thought();
        } else if (goal_ != nullptr) {
            running_ = true;
            glide_to(at(*goal_), speed_);
        } else {
            leave();
        }
    }

protected:
    void arrived() override {
        const Entity& corner = *goal_;
        goal_ = nullptr;
        if (const std::string* fired = corner.find("pathtarget")) {
            for (Actor* target : game().find_actors(*fired))
                target->use();
        }
        const float wait = corner.get_float("wait");
        if (wait < 0.0f)
            running_ = false;
        else
            think_in(wait); // at least a tick: a corner at the same place must not end in a loop
    }

private:
    Placement at(const Entity& corner) const {
        return {origin_of(corner) + corner_to_origin_, place().angles};
    }

    void leave() {
        running_ = true;
        for (int jumps = 0; next_ != nullptr; ++jumps) {
            const Entity& corner = *next_;
            next_ = game().find_entity(corner.get_string("target"));
            const bool jump = (static_cast<uint32_t>(corner.get_int("spawnflags")) & teleport) != 0;
            if (!jump || jumps >= most_jumps) {
                goal_ = &corner;
                glide_to(at(corner), speed_);
                return;
            }
            put(at(corner));
        }
        running_ = false; // the end of the line
    }

    GlideSpeed speed_;
    glm::vec3 corner_to_origin_{0.0f};
    const Entity* next_ = nullptr; ///< the corner after the one it goes to
    const Entity* goal_ = nullptr; ///< the corner it goes to, null at one
    bool running_ = false;
};

} // namespace vigil::actors
