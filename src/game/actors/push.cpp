// SPDX-License-Identifier: GPL-2.0-or-later
// trigger_push: throws who is in it along its direction, with ten times `speed` (1000 by default);
// with the flag for it only once.
#include "game/actors/spawn_table.h"
#include "game/actors/volume.h"

#include <glm/glm.hpp>

namespace vigil {

namespace {

constexpr uint32_t once = 1;

class Push : public Volume {
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

} // namespace

std::unique_ptr<Actor> spawn_push(Game& game, const Entity& keys, int number) {
    return std::make_unique<Push>(game, keys, number);
}

} // namespace vigil
