// SPDX-License-Identifier: GPL-2.0-or-later
// func_rotating: turns for ever around an axis of its own, switched by use. Degrees per second, 100
// by default.
#include "game/actors/spawn_table.h"
#include "game/game.h"
#include "game/mover.h"

namespace vigil {

namespace {

class Rotating : public Mover {
    enum Flag : uint32_t {
        start_on = 1,
        reverse = 2,
        x_axis = 4,
        y_axis = 8,
        stop_if_blocked = 32
    };

public:
    Rotating(Game& game, const Entity& keys, int number) : Mover(game, keys, number) {
        const float speed = number_key("speed", 100.0f, -1e5f, 1e5f);
        const size_t axis = has_flag(x_axis) ? 2 : has_flag(y_axis) ? 0 : 1;
        velocity_[axis] = has_flag(reverse) ? -speed : speed;
        put({place().origin, drawn_angles(keys)});
    }
    void begin() override {
        if (has_flag(start_on)) spin(velocity_);
    }
    void use() override { spin(spinning() ? glm::vec3(0.0f) : velocity_); }

private:
    static glm::vec3 drawn_angles(const Entity& keys) {
        if (keys.has("angles")) return keys.get_vec3("angles");
        const float angle = keys.get_float("angle");
        return {angle == -1.0f   ? -90.0f
                : angle == -2.0f ? 90.0f
                                 : 0.0f,
                angle == -1.0f || angle == -2.0f ? 0.0f : angle, 0.0f};
    }

    glm::vec3 velocity_{0.0f};
};

} // namespace

std::unique_ptr<Actor> spawn_rotating(Game& game, const Entity& keys, int number) {
    return std::make_unique<Rotating>(game, keys, number);
}

} // namespace vigil
