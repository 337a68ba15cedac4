// SPDX-License-Identifier: GPL-2.0-or-later
#include "game/mover.h"

#include "common/error.h"
#include "common/printable.h"
#include "game/game.h"
#include "game/view_axes.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace vigil {

int brush_model_of(const Entity& keys, size_t model_count) {
    const std::string* model = keys.find("model");
    if (model == nullptr || !model->starts_with('*')) return -1;
    int number = -1;
    const char* end = model->data() + model->size();
    const auto [stop, error] = std::from_chars(model->data() + 1, end, number);
    if (error != std::errc() || stop != end || number < 1) return -1;
    return static_cast<size_t>(number) < model_count ? number : -1;
}

glm::vec3 travel_direction(const Entity& keys) {
    const glm::vec3 angles = keys.get_angles();
    if (angles == glm::vec3(0.0f, -1.0f, 0.0f)) return {0.0f, 0.0f, 1.0f};
    if (angles == glm::vec3(0.0f, -2.0f, 0.0f)) return {0.0f, 0.0f, -1.0f};
    return view_axes(angles).forward;
}

Box drawn_bounds(const BspModel& model) {
    const glm::vec3 limit(bsp_max_coordinate);
    return {glm::clamp(model.mins, -limit, limit) - 1.0f,
            glm::clamp(model.maxs, -limit, limit) + 1.0f};
}

glm::vec3 sliding_way(const BspModel& model, const Entity& keys, float usual_lip) {
    const float key = keys.get_float("lip");
    const float lip = key == 0.0f ? usual_lip : std::clamp(key, -1e5f, 1e5f);
    const Box box = drawn_bounds(model);
    const glm::vec3 direction = travel_direction(keys);
    return direction * (glm::dot(glm::abs(direction), box.maxs - box.mins) - lip);
}

glm::vec3 origin_of(const Entity& keys) {
    return glm::clamp(keys.get_vec3("origin"), glm::vec3(-bsp_max_coordinate),
                      glm::vec3(bsp_max_coordinate));
}

Mover::Mover(Game& game, const Entity& keys, int number, float usual_health)
    : Actor(game, keys, number),
      health_(number_key("health", usual_health, std::min(usual_health, 1.0f), 1e9f)),
      health_left_(health_) {
    const int model = brush_model_of(keys, game.bsp().models.size());
    if (model < 0)
        fail("it has no brush model of the level (\"{}\")",
             printable(keys.get_string("model"), 40));
    Obstacle obstacle;
    obstacle.model = static_cast<uint32_t>(model);
    obstacle.place.origin = origin_of(keys);
    obstacle.owner = number;
    obstacle_ = game.collision().add(obstacle);
}

const Placement& Mover::place() const {
    return game().collision().obstacle(obstacle_).place;
}

const BspModel& Mover::model() const {
    return game().bsp().models[game().collision().obstacle(obstacle_).model];
}

bool Mover::breaks(float damage) {
    if (!is_breakable()) return false;
    health_left_ -= damage;
    if (health_left_ > 0.0f) return false;
    mend();
    return true;
}

void Mover::put(const Placement& place) {
    game().collision().obstacle(obstacle_).place = place;
}

void Mover::show(bool shown) {
    shown_ = shown;
    game().collision().obstacle(obstacle_).solid = shown;
}

void Mover::remove() {
    Actor::remove();
    show(false);
}

void Mover::glide_to(const Placement& target, const GlideSpeed& speed) {
    from_ = place();
    to_ = target;
    speed_ = speed;
    gone_ = 0.0f;
    velocity_ = speed.acceleration > 0.0f ? 0.0f : speed.speed;
    length_ = glm::length(to_.origin - from_.origin);
    if (length_ == 0.0f) length_ = glm::length(to_.angles - from_.angles);
    gliding_ = length_ > 0.0f;
    if (!gliding_) arrived();
}

void Mover::advance_glide() {
    const float gone = gone_, velocity = velocity_;
    if (speed_.acceleration > 0.0f)
        velocity_ = std::min(speed_.speed, velocity_ + speed_.acceleration * player::tick_s);
    if (speed_.deceleration > 0.0f) {
        // As fast as still lets it stop at the end, but not so slow that it never gets there.
        const float brake = std::sqrt(2.0f * speed_.deceleration * (length_ - gone_));
        velocity_ = std::min(velocity_, std::max(brake, 0.05f * speed_.speed));
    }
    gone_ = std::min(length_, gone_ + velocity_ * player::tick_s);
    const bool over = gone_ >= length_;
    const float part = gone_ / length_;
    const Placement next = over ? to_
                                : Placement{glm::mix(from_.origin, to_.origin, part),
                                            glm::mix(from_.angles, to_.angles, part)};
    if (!game().push(obstacle_, next)) {
        gone_ = gone;
        velocity_ = velocity;
        blocked();
        return;
    }
    if (!over) return;
    gliding_ = false;
    arrived();
}

void Mover::tick() {
    if (gliding_) advance_glide();
    if (!spinning()) return;
    Placement next = place();
    next.angles += spin_ * player::tick_s;
    if (!game().push(obstacle_, next)) blocked();
}

} // namespace vigil
