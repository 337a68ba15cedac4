// SPDX-License-Identifier: GPL-2.0-or-later
// A brush model that may move: it glides from one placement to another, pushes the player out of
// its way and carries who stands on it. Units per second, degrees per second.
#pragma once

#include "game/actor.h"
#include "game/brush_trace.h"

namespace vigil {

/// How fast a glide is. Without acceleration it has its speed at once.
struct GlideSpeed {
    float speed = 100.0f;
    float acceleration = 0.0f; ///< 0: none
    float deceleration = 0.0f;
};

class Mover : public Actor {
public:
    /// Puts the model of the key `model` ("*N") into the world, solid, at the key `origin`. Throws
    /// Error where the level has no such model. `usual_health` is that without the key.
    Mover(Game& game, const Entity& keys, int number, float usual_health = 0.0f);

    void tick() override;
    void remove() override;

    const Placement& place() const;
    /// Drawn; what is not drawn is not solid either.
    bool shown() const { return shown_; }
    bool gliding() const { return gliding_; }
    const BspModel& model() const;
    size_t obstacle() const { return obstacle_; }

protected:
    /// Takes a shot's damage from the key `health`; true where that was the last of it, and then it
    /// is whole again. What has no health never breaks.
    bool breaks(float damage);
    void mend() { health_left_ = health_; }
    bool is_breakable() const { return health_ > 0.0f; }
    /// Jumps there; pushes nobody.
    void put(const Placement& place);
    void show(bool shown);
    /// Turns at `degrees_per_second` for ever; zero stops.
    void spin(const glm::vec3& degrees_per_second) { spin_ = degrees_per_second; }
    bool spinning() const { return spin_ != glm::vec3(0.0f); }
    /// Glides to a placement and calls arrived() there, at once where it is there.
    void glide_to(const Placement& target, const GlideSpeed& speed);
    void stop_gliding() { gliding_ = false; }

    virtual void arrived() {}
    /// The player is in the way and cannot be pushed.
    virtual void blocked() {}

private:
    void advance_glide();

    size_t obstacle_ = 0;
    float health_, health_left_;
    bool shown_ = true;
    glm::vec3 spin_{0.0f};

    bool gliding_ = false;
    Placement from_, to_;
    GlideSpeed speed_;
    float length_ = 0.0f;   ///< of the glide, units or degrees
    float gone_ = 0.0f;     ///< of it
    float velocity_ = 0.0f; ///< along it
};

/// The direction of the keys `angle` and `angles`: -1 is up, -2 is down.
glm::vec3 travel_direction(const Entity& keys);

/// Bounds of a model as it was drawn, a unit wider on all sides, as the original measures it.
Box drawn_bounds(const BspModel& model);

/// How far doors and buttons go: by their size along travel_direction(), less the key `lip`.
glm::vec3 sliding_way(const BspModel& model, const Entity& keys, float usual_lip);

/// The key `origin`, inside the world.
glm::vec3 origin_of(const Entity& keys);

/// N of the key `model` "*N" of a level with so many models, or -1.
int brush_model_of(const Entity& keys, size_t model_count);

} // namespace vigil
