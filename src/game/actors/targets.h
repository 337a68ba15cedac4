// SPDX-License-Identifier: GPL-2.0-or-later
// What has no brushes and does something when it is used: relays, counters, timers, lights,
// bursts, area portals.
#pragma once

#include "common/ascii_case.h"
#include "common/error.h"
#include "game/game.h"
#include "game/mover.h"

#include <algorithm>
#include <cmath>

namespace vigil::actors {

/// func_areaportal: closed at first; each use opens or closes the portal of its `style`. Doors that
/// target one open and close it themselves, and do not use it.
class AreaPortal : public Actor {
public:
    using Actor::Actor;
    void use() override {
        const auto portal = static_cast<uint32_t>(keys().get_int("style"));
        AreaPortals& portals = game().area_portals();
        portals.set_open(portal, !portals.is_open(portal));
    }
};

/// trigger_relay: passes on what fires it.
class Relay : public Actor {
public:
    using Actor::Actor;
    void use() override { use_targets(); }
};

/// trigger_counter: passes on the `count`th time only (2 by default).
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

/// trigger_always: fires when the level starts.
class Always : public Actor {
public:
    using Actor::Actor;
    void begin() override { think_in(0.2f); }
    void think() override { use_targets(); }
};

/// func_timer: fires its targets every `wait` seconds (1 by default), give or take `random`. Flag 1
/// starts on, after `pausetime` and `delay` more; each use switches it. What is random here is a
/// function of the entity and of how often it has fired: the same level runs the same way.
class Timer : public Actor {
    static constexpr uint32_t start_on = 1; // of the flags
    static constexpr float tenth_s = 0.1f;  // a frame of the original

public:
    Timer(Game& game, const Entity& keys, int number)
        : Actor(game, keys, number), wait_s_(number_key("wait", 1.0f, 0.0f, 1e6f)),
          delay_s_(number_key("delay", 0.0f, 0.0f, 1e6f)),
          // As the original: a range as wide as the wait would fire at once.
          random_s_(std::clamp(keys.get_float("random"), 0.0f, std::max(0.0f, wait_s_ - tenth_s))) {
    }

    void begin() override {
        if (has_flag(start_on))
            think_in(1.0f + number_key("pausetime", 0.0f, 0.0f, 1e6f) + delay_s_ + next_wait());
    }
    void use() override {
        if (is_thinking())
            forget_thought();
        else
            think_after(delay_s_);
    }
    void think() override {
        // First: a target may switch it off. Its `delay` is that of its start only.
        think_in(next_wait());
        game().use_targets_now(keys());
    }

private:
    float next_wait() {
        // A step of Weyl's sequence by the golden ratio: even, and different for each timer.
        constexpr uint32_t golden = 0x9e3779b9u;
        const uint32_t step = golden * (static_cast<uint32_t>(number()) + ++fired_);
        const float even = static_cast<float>(step >> 8) / static_cast<float>(1u << 24);
        return wait_s_ + random_s_ * (2.0f * even - 1.0f);
    }

    float wait_s_, delay_s_, random_s_;
    uint32_t fired_ = 0;
};

/// target_explosion: bursts at its place when it is used, after its `delay`, and then fires its
/// targets. `dmg` hurts the player nearby; without it there is light alone.
class TargetExplosion : public Actor {
public:
    TargetExplosion(Game& game, const Entity& keys, int number)
        : Actor(game, keys, number), damage_(number_key("dmg", 0.0f, 0.0f, 1e6f)),
          delay_s_(number_key("delay", 0.0f, 0.0f, 1e6f)) {}

    void use() override { think_after(delay_s_); }
    void think() override {
        game().explode(origin_of(keys()), damage_);
        // The delay has passed; use_targets would wait for it once more.
        game().use_targets_now(keys());
    }

private:
    float damage_, delay_s_;
};

/// Styles of lights that can be switched; those below are the game's own.
inline bool is_switched_style(int style) {
    return style >= 32 && style < 256;
}

/// light: one with a style of its own (32 and up) goes on and off when it is used; flag 1 starts
/// off.
class Light : public Actor {
    static constexpr uint32_t start_off = 1; // of the flags

public:
    Light(Game& game, const Entity& keys, int number)
        : Actor(game, keys, number), style_(keys.get_int("style")), on_(!has_flag(start_off)) {}

    void use() override {
        if (!is_switched_style(style_)) return;
        on_ = !on_;
        game().set_light_style(style_, on_ ? "m" : "a");
    }

private:
    int style_;
    bool on_;
};

/// target_lightramp: brings the lights that its `target` names from one letter of `message` to the
/// other in `speed` seconds, ten steps a second; flag 1: and back at the next use.
class LightRamp : public Actor {
    static constexpr uint32_t toggle = 1; // of the flags
    static constexpr float step_s = 0.1f;

public:
    LightRamp(Game& game, const Entity& keys, int number)
        : Actor(game, keys, number), seconds_(number_key("speed", 1.0f, step_s, 1e6f)) {
        const std::string letters = keys.get_string("message");
        const auto is_letter = [](char c) { return c >= 'a' && c <= 'z'; };
        if (letters.size() != 2 || !is_letter(letters[0]) || !is_letter(letters[1]) ||
            letters[0] == letters[1])
            fail("its message is not two different letters a to z");
        from_ = letters[0];
        to_ = letters[1];
    }

    void use() override {
        begun_at_ = game().ticks();
        think();
    }
    void think() override {
        const float gone =
            static_cast<float>(game().ticks() - begun_at_) * player::tick_s / seconds_;
        const float letter =
            static_cast<float>(from_) + std::min(1.0f, gone) * static_cast<float>(to_ - from_);
        set(static_cast<char>(std::lround(letter)));
        if (gone < 1.0f)
            think_in(step_s);
        else if (has_flag(toggle))
            std::swap(from_, to_);
    }

private:
    void set(char letter) const {
        const std::string target = keys().get_string("target");
        if (target.empty()) return;
        for (const Entity& entity : game().bsp().entities) {
            if (!starts_nocase(entity.classname(), "light")) continue;
            if (entity.get_string("targetname") != target) continue;
            const int style = entity.get_int("style");
            if (is_switched_style(style)) game().set_light_style(style, std::string(1, letter));
        }
    }

    float seconds_;
    char from_ = 'a', to_ = 'm';
    int64_t begun_at_ = 0;
};

} // namespace vigil::actors
