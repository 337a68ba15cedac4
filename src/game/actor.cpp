// SPDX-License-Identifier: GPL-2.0-or-later
#include "game/actor.h"

#include "game/game.h"

#include <algorithm>

namespace vigil {

Actor::Actor(Game& game, const Entity& keys, int number)
    : game_(game), keys_(keys), number_(number),
      flags_(static_cast<uint32_t>(keys.get_int("spawnflags"))),
      targetname_(keys.get_string("targetname")) {}

void Actor::think_in(float seconds) {
    think_at_ = game_.ticks() + ticks_of(seconds);
}

void Actor::think_after(float seconds) {
    if (seconds > 0.0f)
        think_in(seconds);
    else
        think();
}

bool Actor::is_thinking() const {
    return think_at_ > game_.ticks();
}

void Actor::use_targets() {
    game_.use_targets(keys_);
}

float Actor::number_key(std::string_view key, float fallback, float low, float high) const {
    const float value = keys_.get_float(key);
    return value == 0.0f ? fallback : std::clamp(value, low, high);
}

} // namespace vigil
