// SPDX-License-Identifier: GPL-2.0-or-later
// light: one with a style of its own (32 and up) goes on and off when it is used; flag 1 starts
// off. target_lightramp: brings the lights that its `target` names from one letter of `message` to
// the other in `speed` seconds, ten steps a second; flag 1: and back at the next use.
#include "common/ascii_case.h"
#include "common/error.h"
#include "game/actors/spawn_table.h"
#include "game/game.h"

#include <algorithm>
#include <cmath>

namespace vigil {

namespace {

constexpr int first_switched = 32, style_count = 256;
constexpr float step_s = 0.1f;

class Light : public Actor {
public:
    Light(Game& game, const Entity& keys, int number)
        : Actor(game, keys, number), style_(keys.get_int("style")), on_(!has_flag(start_off)) {}

    void use() override {
        if (style_ < first_switched || style_ >= style_count) return;
        on_ = !on_;
        game().set_light_style(style_, on_ ? "m" : "a");
    }

private:
    static constexpr uint32_t start_off = 1;
    int style_;
    bool on_;
};

class LightRamp : public Actor {
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
    static constexpr uint32_t toggle = 1;

    void set(char letter) const {
        const std::string target = keys().get_string("target");
        if (target.empty()) return;
        for (const Entity& entity : game().bsp().entities) {
            if (!starts_nocase(entity.classname(), "light")) continue;
            if (entity.get_string("targetname") != target) continue;
            const int style = entity.get_int("style");
            if (style >= first_switched && style < style_count)
                game().set_light_style(style, std::string(1, letter));
        }
    }

    float seconds_;
    char from_ = 'a', to_ = 'm';
    int64_t begun_at_ = 0;
};

} // namespace

std::unique_ptr<Actor> spawn_light(Game& game, const Entity& keys, int number) {
    return std::make_unique<Light>(game, keys, number);
}

std::unique_ptr<Actor> spawn_light_ramp(Game& game, const Entity& keys, int number) {
    return std::make_unique<LightRamp>(game, keys, number);
}

} // namespace vigil
