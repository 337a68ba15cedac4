// SPDX-License-Identifier: GPL-2.0-or-later
// trigger_multiple and trigger_once: fire when the player is in them, at most every `wait` seconds
// (0.2 by default, once: never again). trigger_always: fires when the level starts.
#include "game/actors/spawn_table.h"
#include "game/actors/volume.h"
#include "game/view_axes.h"

#include <glm/glm.hpp>

namespace vigil {

namespace {

class Trigger : public Volume {
    enum Flag : uint32_t { not_player = 2, triggered = 4 };

public:
    Trigger(Game& game, const Entity& keys, int number, float wait_s)
        : Volume(game, keys, number), wait_s_(wait_s), enabled_(!has_flag(triggered)),
          has_direction_(keys.get_float("angle") != 0.0f || keys.has("angles")),
          direction_(travel_direction(keys)) {}

    void touch() override {
        if (!enabled_ || has_flag(not_player)) return;
        // One with a direction fires for who moves along it.
        if (has_direction_ && glm::dot(game().player().velocity, direction_) < 0.0f) return;
        fire();
    }
    void use() override {
        if (!enabled_)
            enabled_ = true;
        else
            fire();
    }

private:
    void fire() {
        if (is_thinking() || done_) return;
        if (wait_s_ > 0.0f)
            think_in(wait_s_);
        else
            done_ = true;
        use_targets();
    }

    float wait_s_;
    bool enabled_;
    bool has_direction_;
    glm::vec3 direction_;
    bool done_ = false;
};

class Always : public Actor {
public:
    using Actor::Actor;
    void begin() override { think_in(0.2f); }
    void think() override { use_targets(); }
};

} // namespace

std::unique_ptr<Actor> spawn_trigger_multiple(Game& game, const Entity& keys, int number) {
    const float wait = keys.get_float("wait");
    return std::make_unique<Trigger>(game, keys, number, wait == 0.0f ? 0.2f : wait);
}

std::unique_ptr<Actor> spawn_trigger_once(Game& game, const Entity& keys, int number) {
    return std::make_unique<Trigger>(game, keys, number, -1.0f);
}

std::unique_ptr<Actor> spawn_trigger_always(Game& game, const Entity& keys, int number) {
    return std::make_unique<Always>(game, keys, number);
}

} // namespace vigil
