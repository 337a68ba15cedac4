// SPDX-License-Identifier: GPL-2.0-or-later
// Spaces that do something with the player who is in them: trigger_multiple and _once,
// trigger_hurt, trigger_push, trigger_teleport, misc_teleporter.
#pragma once

#include "common/error.h"
#include "common/log.h"
#include "game/game.h"
#include "game/mover.h"

#include <glm/glm.hpp>

namespace vigil::actors {

/// An actor whose brush model is a space that nobody sees.
class Volume : public Actor {
public:
    /// Throws Error where the level has no such model.
    Volume(Game& game, const Entity& keys, int number) : Actor(game, keys, number) {
        const int model = brush_model_of(keys, game.bsp().models.size());
        if (model < 0) fail("it has no brush model of the level");
        const Box box = drawn_bounds(game.bsp().models[static_cast<size_t>(model)]);
        bounds_ = {box.mins + origin_of(keys), box.maxs + origin_of(keys)};
    }
    std::optional<Box> volume() const override { return bounds_; }

private:
    Box bounds_;
};

enum class Times { Once, Many };

/// trigger_multiple and trigger_once: fire when the player is in them, at most every `wait` seconds
/// (0.2 by default, once: never again).
class Trigger : public Volume {
    enum Flag : uint32_t { not_player = 2, triggered = 4 };

public:
    Trigger(Game& game, const Entity& keys, int number, Times times)
        : Volume(game, keys, number),
          wait_s_(times == Times::Once ? -1.0f : number_key("wait", 0.2f, -1.0f, 1e7f)),
          enabled_(!has_flag(triggered)),
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

/// trigger_hurt: takes `dmg` health (5 by default) from who is in it, ten times a second, or once a
/// second with the flag for it. Flag 1 starts off; with flag 2 each use switches it, without it
/// uses switch it on or off once.
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

/// trigger_push: throws who is in it along its direction, with ten times `speed` (1000 by default);
/// with the flag for it only once.
class Push : public Volume {
    static constexpr uint32_t once = 1; // of the flags

public:
    Push(Game& game, const Entity& keys, int number)
        : Volume(game, keys, number),
          velocity_(10.0f * number_key("speed", 1000.0f, -1e5f, 1e5f) * travel_direction(keys)) {}

    void touch() override {
        // No faster than anything may be.
        const float length = glm::length(velocity_);
        const float scale = length > player::fastest ? player::fastest / length : 1.0f;
        game().player().velocity = scale * velocity_;
        if (has_flag(once)) remove();
    }

private:
    glm::vec3 velocity_;
};

/// To stand at the entity that `target` names, to look where that looks, and to stay for a moment.
inline void send_player(Game& game, const Entity& keys, int number) {
    constexpr float over_pad = 10.0f, hold_s = 0.16f;
    const Entity* goal = game.find_entity(keys.get_string("target"));
    if (goal == nullptr) return;
    const PlayerState arrived =
        place_player(origin_of(*goal) + glm::vec3(0.0f, 0.0f, over_pad), game.collision());
    if (!game.collision().is_free(arrived.origin, player::standing_box, mask_player_solid)) {
        log_warning("entity {} ({}) has no room where it leads", number, keys.classname());
        return;
    }
    PlayerState& player = game.player();
    player.velocity = glm::vec3(0.0f);
    player.hold = PlayerState::Hold::Teleported;
    player.hold_ticks = static_cast<int>(ticks_of(hold_s));
    game.place_player_at(arrived.origin);
    game.turn_view(goal->get_angles());
}

/// misc_teleporter: who touches its pad is sent.
class Pad : public Actor {
public:
    Pad(Game& game, const Entity& keys, int number)
        : Actor(game, keys, number), bounds_{origin_of(keys) + glm::vec3(-8, -8, 8),
                                             origin_of(keys) + glm::vec3(8, 8, 24)} {}
    std::optional<Box> volume() const override { return bounds_; }
    void touch() override { send_player(game(), keys(), number()); }

private:
    Box bounds_;
};

/// trigger_teleport: the same of a space. One with a name works for two tenths of a second after
/// each use.
class TeleportTrigger : public Volume {
public:
    using Volume::Volume;
    void use() override {
        constexpr float open_s = 0.2f;
        think_in(open_s);
    }
    void touch() override {
        if (targetname().empty() || is_thinking()) send_player(game(), keys(), number());
    }
};

} // namespace vigil::actors
