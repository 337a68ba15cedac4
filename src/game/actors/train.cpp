// SPDX-License-Identifier: GPL-2.0-or-later
// func_train: goes from path_corner to path_corner; its lowest corner touches them. A corner's
// `wait` holds it up (-1: until it is used), its `pathtarget` is fired, its flag 1 lets it jump
// there. Units per second, 100 by default.
#include "common/log.h"
#include "game/actors/spawn_table.h"
#include "game/game.h"
#include "game/mover.h"

#include <glm/glm.hpp>

namespace vigil {

namespace {

constexpr uint32_t teleport = 1; // of a corner
/// Corners that jump to each other in a circle would never end.
constexpr int most_jumps = 64;

class Train : public Mover {
    enum Flag : uint32_t { start_on = 1, toggle = 2 };

public:
    Train(Game& game, const Entity& keys, int number)
        : Mover(game, keys, number), speed_{number_key("speed", 100.0f, 1.0f, 1e5f)} {
        const uint32_t model = game.collision().obstacle(obstacle()).model;
        corner_to_origin_ = -drawn_bounds(game.bsp().models[model]).mins - 1.0f;
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

} // namespace

std::unique_ptr<Actor> spawn_train(Game& game, const Entity& keys, int number) {
    return std::make_unique<Train>(game, keys, number);
}

} // namespace vigil
