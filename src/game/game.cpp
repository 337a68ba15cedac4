// SPDX-License-Identifier: GPL-2.0-or-later
#include "game/game.h"

#include "common/ascii_case.h"
#include "common/error.h"
#include "common/log.h"
#include "common/printable.h"
#include "game/actors/spawn_table.h"
#include "game/mover.h"
#include "game/view_axes.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>

namespace vigil {

namespace {

/// Targets that fire each other in a circle would never end.
constexpr int most_uses_per_tick = 4096;
constexpr int most_depth = 64;
constexpr size_t most_delayed = 65536;
constexpr int explosion_ticks = 3 * player::ticks_per_second / 2; // as the original's

} // namespace

int64_t ticks_of(float seconds) {
    constexpr float longest_s = 1e7f;
    const double clamped = static_cast<double>(std::clamp(seconds, 0.0f, longest_s));
    return std::max<int64_t>(1, std::llround(clamped * player::ticks_per_second));
}

namespace {

/// What stands still must not tremble from rounding.
glm::vec3 between(const glm::vec3& before, const glm::vec3& now, float fraction) {
    return before == now ? now : glm::mix(before, now, fraction);
}

} // namespace

Placement MovedModel::at(float fraction) const {
    return {between(before.origin, now.origin, fraction),
            between(before.angles, now.angles, fraction)};
}

Game::Game(std::shared_ptr<const Level> level, const glm::vec3& start)
    : level_(std::move(level)), collision_(level_->bsp), area_portals_(level_->bsp), start_(start) {
    spawn();
    player_ = player_before_ = place_player(start, collision_);
}

Game::~Game() = default;

void Game::spawn() {
    const std::vector<Entity>& entities = bsp().entities;
    std::map<std::string, int> unknown;
    for (size_t i = 1; i < entities.size(); ++i) {
        const int number = static_cast<int>(i);
        const std::string name = entities[i].classname();
        const SpawnRow* row = find_spawn_row(name);
        if (row == nullptr) {
            ++unknown[name];
            continue;
        }
        if (row->spawn == nullptr) continue;
        try {
            actors_.push_back(row->spawn(*this, entities[i], number));
        } catch (const Error& error) {
            log_warning("entity {} ({}) does nothing: {}", number, printable(name, 60),
                        error.what());
        }
    }
    for (const auto& actor : actors_)
        if (auto* mover = dynamic_cast<Mover*>(actor.get())) movers_.push_back(mover);
    for (const auto& actor : actors_)
        actor->begin();
    for (const Mover* mover : movers_)
        before_.push_back(mover->place());

    std::string list;
    for (const auto& [name, count] : unknown)
        list += fmt::format("{}{} ({})", list.empty() ? "" : ", ", printable(name, 60), count);
    if (!list.empty()) log_info("{}: entities that do nothing here: {}", level_->name, list);
}

Actor* Game::actor(int number) const {
    const auto found = std::ranges::lower_bound(actors_, number, {}, &Actor::number);
    return found != actors_.end() && (*found)->number() == number ? found->get() : nullptr;
}

std::vector<Actor*> Game::find_actors(std::string_view targetname) const {
    std::vector<Actor*> found;
    if (targetname.empty()) return found;
    for (const auto& actor : actors_)
        if (!actor->removed() && actor->targetname() == targetname) found.push_back(actor.get());
    return found;
}

const Entity* Game::find_entity(std::string_view targetname) const {
    if (targetname.empty()) return nullptr;
    for (const Entity& entity : bsp().entities)
        if (const std::string* name = entity.find("targetname"); name && *name == targetname)
            return &entity;
    return nullptr;
}

void Game::set_light_style(int style, std::string letters) {
    light_styles_[style] = std::move(letters);
}

void Game::use_targets(const Entity& keys) {
    const float delay = keys.get_float("delay");
    if (delay <= 0.0f) {
        fire(keys);
    } else if (delayed_.size() < most_delayed) {
        delayed_.push_back({ticks_ + ticks_of(delay), &keys});
    }
}

void Game::fire(const Entity& keys) {
    const std::string message = keys.get_string("message");
    if (!message.empty()) log_info("{}", printable(message, 400));
    for (Actor* victim : find_actors(keys.get_string("killtarget")))
        victim->remove();
    // Doors open and close their area portals themselves.
    const bool is_door = starts_nocase(keys.classname(), "func_door");
    for (Actor* target : find_actors(keys.get_string("target"))) {
        if (is_door && equal_nocase(target->keys().classname(), "func_areaportal")) continue;
        if (++uses_ > most_uses_per_tick || depth_ >= most_depth) {
            if (!uses_reported_)
                log_warning("{}: targets fire each other without end; they stop at {} a tick and "
                            "{} in a row",
                            level_->name, most_uses_per_tick, most_depth);
            uses_reported_ = true;
            return;
        }
        // Of those found, one may have removed another.
        if (target->removed()) continue;
        ++depth_;
        target->use();
        --depth_;
    }
}

void Game::run_delayed() {
    // What is fired now may add more, due later.
    for (size_t i = 0; i < delayed_.size();) {
        if (delayed_[i].at > ticks_) {
            ++i;
            continue;
        }
        const Entity& keys = *delayed_[i].keys;
        delayed_.erase(delayed_.begin() + static_cast<std::ptrdiff_t>(i));
        fire(keys);
    }
}

void Game::tick(const PlayerCommand& command, bool level_stands) {
    uses_ = 0;
    player_before_ = player_;
    for (size_t i = 0; i < movers_.size(); ++i)
        before_[i] = movers_[i]->place();
    if (!level_stands) {
        ++ticks_;
        explosions_.tick();
        run_delayed();
        for (const auto& actor : actors_) {
            if (!actor->removed() && actor->thinks_at(ticks_)) actor->think();
            if (!actor->removed()) actor->tick();
        }
    }
    if (player_present_) move_player_one_tick(command, level_stands);
    if (!level_stands)
        bolts_.tick(*this, eye_at(1.0f), command.angles, command.attack && player_present_);
}

void Game::move_player_one_tick(const PlayerCommand& command, bool level_stands) {
    std::vector<int> touched;
    player_ = move_player(player_, command, collision_, &touched);
    if (level_stands) return;
    for (const int number : touched)
        if (Actor* other = actor(number); other != nullptr && !other->removed()) other->bump();
    touch_volumes();
}

void Game::touch_volumes() {
    for (const auto& actor : actors_) {
        if (actor->removed()) continue;
        // A teleporter may move the player between two of them.
        const Box& box = player_.box();
        const Box player_bounds{player_.origin + box.mins - 1.0f, player_.origin + box.maxs + 1.0f};
        const std::optional<Box> volume = actor->volume();
        if (volume && boxes_touch(*volume, player_bounds)) actor->touch();
    }
}

void Game::set_portals_of(const Entity& door, bool open) {
    const std::string target = door.get_string("target");
    if (target.empty()) return;
    for (const Entity& entity : bsp().entities)
        if (equal_nocase(entity.classname(), "func_areaportal") &&
            entity.get_string("targetname") == target)
            area_portals_.set_open(static_cast<uint32_t>(entity.get_int("style")), open);
}

void Game::hurt_player(float damage) {
    if (!player_present_) return;
    health_ = std::min(full_health, health_ - damage);
    if (health_ > 0.0f) return;
    health_ = full_health;
    ++deaths_;
    log_info("You died. Back to the start.");
    player_ = place_player(start_, collision_);
    place_player_at(player_.origin);
}

void Game::explode(const glm::vec3& place, float damage) {
    explosions_.add(explosion_count_++, place, explosion_ticks);
    const float left = damage - 0.5f * glm::distance(place, player_.origin);
    if (left <= 0.0f || !player_present_) return;
    if (!collision_.trace(place, player_.origin, {}, mask_shot & ~CONTENTS_MONSTER).hit())
        hurt_player(left);
}

void Game::place_player_at(const glm::vec3& origin) {
    player_.origin = origin;
    player_.ground = owner_none;
    player_.step_left = 0.0f;
    player_before_ = player_;
}

glm::vec3 Game::eye_at(float fraction) const {
    const auto eye = [](const PlayerState& state) {
        return state.origin + glm::vec3(0.0f, 0.0f, state.eye_height() - state.step_left);
    };
    return between(eye(player_before_), eye(player_), fraction);
}

std::optional<glm::vec3> Game::take_view() {
    return std::exchange(view_, std::nullopt);
}

float Game::take_view_turn() {
    return std::exchange(view_turn_, 0.0f);
}

std::vector<MovedModel> Game::moved_models() const {
    std::vector<MovedModel> models;
    models.reserve(movers_.size());
    for (size_t i = 0; i < movers_.size(); ++i)
        models.push_back(
            {movers_[i]->number(), before_[i], movers_[i]->place(), movers_[i]->shown()});
    return models;
}

bool Game::push(size_t index, const Placement& place) {
    Obstacle& obstacle = collision_.obstacle(index);
    const Placement old = std::exchange(obstacle.place, place);
    if (!obstacle.solid || !player_present_) return true;
    const bool rides = player_.ground == obstacle.owner;
    const Box& box = player_.box();
    const glm::vec3 origin = player_.origin;
    if (!rides &&
        !collision_.trace_obstacle(index, origin, origin, box, mask_player_solid).start_solid)
        return true;

    // The player goes where the point of the model went that was at the player's place.
    glm::vec3 local = origin - old.origin;
    if (old.angles != place.angles)
        local = model_rotation(place.angles) * (glm::transpose(model_rotation(old.angles)) * local);
    const glm::vec3 moved = local + place.origin;
    if (collision_.is_free(moved, box, mask_player_solid)) {
        player_.origin = moved;
        if (rides) view_turn_ += place.angles.y - old.angles.y;
        return true;
    }
    // Who is held back by something else may stay behind, if it does not hurt.
    if (collision_.is_free(origin, box, mask_player_solid)) return true;
    obstacle.place = old;
    return false;
}

Trace Game::shoot(const glm::vec3& from, const glm::vec3& to, float damage) {
    const Trace hit = collision_.trace(from, to, {}, mask_shot);
    if (Actor* other = hit.owner > owner_world ? actor(hit.owner) : nullptr;
        other != nullptr && !other->removed())
        other->hurt(damage);
    return hit;
}

} // namespace vigil
