// SPDX-License-Identifier: GPL-2.0-or-later
// func_timer: fires its targets every `wait` seconds (1 by default), give or take `random`. Flag 1
// starts on, after `pausetime` and `delay` more; each use switches it. What is random here is a
// function of the entity and of how often it has fired: the same level runs the same way.
#include "game/actors/spawn_table.h"
#include "game/game.h"

#include <algorithm>

namespace vigil {

namespace {

constexpr uint32_t start_on = 1;
constexpr float tenth_s = 0.1f; // a frame of the original

class Timer : public Actor {
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
        else if (delay_s_ > 0.0f)
            think_in(delay_s_);
        else
            think();
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

} // namespace

std::unique_ptr<Actor> spawn_timer(Game& game, const Entity& keys, int number) {
    return std::make_unique<Timer>(game, keys, number);
}

} // namespace vigil
