// SPDX-License-Identifier: GPL-2.0-or-later
// Flags and defaults of the original: speed 100, wait 3 s, lip 8. A door that nothing targets and
// nobody has to shoot opens by itself before who comes within 60 units.
#include "game/actors/door.h"

#include "game/game.h"

#include <glm/glm.hpp>

#include <limits>

namespace vigil {

namespace {

namespace door_flag {
enum : uint32_t {
    start_open = 1,
    reverse = 2, // of rotating ones
    crusher = 4,
    toggle = 32,
    x_axis = 64, // of rotating ones
    y_axis = 128,
};
} // namespace door_flag

constexpr float trigger_reach = 60.0f;
constexpr float touch_pause_s = 1.0f;

Box grown_to(const Box& a, const Box& b) {
    return {glm::min(a.mins, b.mins), glm::max(a.maxs, b.maxs)};
}

} // namespace

Door::Door(Game& game, const Entity& keys, int number, Opens opens)
    : Mover(game, keys, number), closed_(place()),
      open_(place()), speed_{number_key("speed", 100.0f, 1.0f, 1e5f)},
      wait_s_(number_key("wait", 3.0f, -1.0f, 1e6f)) {
    if (opens == Opens::Slides) {
        constexpr float usual_lip = 8.0f;
        open_.origin += sliding_way(model(), keys, usual_lip);
    } else {
        const float distance = number_key("distance", 90.0f, -3600.0f, 3600.0f);
        const size_t axis = has_flag(door_flag::x_axis) ? 2 : has_flag(door_flag::y_axis) ? 0 : 1;
        open_.angles[axis] = has_flag(door_flag::reverse) ? -distance : distance;
    }
    if (has_flag(door_flag::start_open)) {
        std::swap(closed_, open_);
        put(closed_);
    }
}

void Door::gather_team() {
    team_ = {this};
    const std::string name = keys().get_string("team");
    if (name.empty()) return;
    for (const auto& actor : game().actors()) {
        auto* door = dynamic_cast<Door*>(actor.get());
        if (door == nullptr || door == this || door->keys().get_string("team") != name) continue;
        if (door->number() < number()) { // it has gathered this one
            leader_ = door;
            team_.clear();
            return;
        }
        team_.push_back(door);
    }
}

void Door::begin() {
    gather_team();
    if (has_flag(door_flag::start_open)) game().set_portals_of(keys(), true);
    if (!leads()) return;

    // All of a team arrive together: the one with the shortest way has its own speed.
    const auto way = [](const Door& door) {
        const float distance = glm::length(door.open_.origin - door.closed_.origin);
        return distance > 0.0f ? distance : glm::length(door.open_.angles - door.closed_.angles);
    };
    float shortest = std::numeric_limits<float>::max();
    for (const Door* door : team_)
        shortest = std::min(shortest, way(*door));
    const float own_speed = speed_.speed;
    bool shot_open = false, named = false;
    Box bounds = game().collision().bounds(obstacle());
    for (Door* door : team_) {
        if (shortest > 0.0f) door->speed_.speed = own_speed * way(*door) / shortest;
        shot_open |= door->is_breakable();
        named |= !door->targetname().empty();
        bounds = grown_to(bounds, game().collision().bounds(door->obstacle()));
    }
    if (shot_open || named) return;
    bounds.mins -= glm::vec3(trigger_reach, trigger_reach, 1.0f);
    bounds.maxs += glm::vec3(trigger_reach, trigger_reach, 1.0f);
    trigger_ = bounds;
}

void Door::touch() {
    if (touched_at_ >= 0 && game().ticks() < touched_at_ + ticks_of(touch_pause_s)) return;
    touched_at_ = game().ticks();
    use();
}

void Door::use() {
    if (!leads()) {
        leader_->use();
        return;
    }
    const bool closes =
        has_flag(door_flag::toggle) && (state_ == State::Open || state_ == State::Opening);
    for (Door* door : team_) {
        if (closes)
            door->close();
        else
            door->open_up();
    }
}

void Door::hurt(float damage) {
    if (breaks(damage)) use();
}

void Door::open_up() {
    if (state_ == State::Opening) return;
    if (state_ == State::Open) {
        if (wait_s_ >= 0.0f) think_in(wait_s_); // stays open from now on
        return;
    }
    state_ = State::Opening;
    game().set_portals_of(keys(), true);
    if (leads()) use_targets();
    glide_to(open_, speed_);
}

void Door::close() {
    if (state_ == State::Closing || state_ == State::Closed) return;
    forget_thought();
    state_ = State::Closing;
    glide_to(closed_, speed_);
}

void Door::think() {
    close();
}

void Door::arrived() {
    if (state_ == State::Opening) {
        state_ = State::Open;
        if (!has_flag(door_flag::toggle) && wait_s_ >= 0.0f) think_in(wait_s_);
    } else {
        state_ = State::Closed;
        game().set_portals_of(keys(), false);
    }
}

void Door::blocked() {
    if (has_flag(door_flag::crusher) || wait_s_ < 0.0f) return;
    const bool opens = state_ == State::Closing;
    for (Door* door : leader_->team_) {
        if (opens)
            door->open_up();
        else
            door->close();
    }
}

} // namespace vigil
