// SPDX-License-Identifier: GPL-2.0-or-later
#include "client/play/play.h"

#include "client/play/effect_lights.h"
#include "common/log.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vigil::client {

namespace {

/// What keys ask for, units per second; more than a player can, as in the original.
constexpr float run_speed = 400.0f, walk_speed = 150.0f;
/// A hair, so that frames of 1/60 s and the like sum up to whole ticks.
constexpr double rounding_s = 1e-6;
/// Ids of the lights of bolts, of where they hit and of explosions; those of `dlight` are below.
constexpr uint32_t first_bolt_light = 0x40000000, first_hit_light = 0x60000000,
                   first_explosion_light = 0x80000000, last_play_light = 0x9fffffff;
constexpr uint32_t light_id_mask = 0x1fffffff;
const EffectLight bolt_light{200.0f, {1.0f, 1.0f, 0.0f}}, hit_light{150.0f, {1.0f, 1.0f, 0.0f}},
    explosion_light{350.0f, {1.0f, 0.5f, 0.5f}};

} // namespace

Play::Play(const Session& session) {
    const glm::vec3 eye = find_start(session.level()->bsp).origin;
    const glm::vec3 origin = eye - glm::vec3(0.0f, 0.0f, player::standing_eye);
    game_ = std::make_unique<Game>(session.shared_level(), origin);
}

PlayerCommand Play::command_of(const FlightInput& keys, const glm::vec3& angles) const {
    const float speed = keys.fast ? walk_speed : run_speed;
    PlayerCommand command;
    command.angles = angles;
    command.forward = speed * keys.forward;
    command.side = speed * keys.right;
    command.up = run_speed * keys.up;
    command.attack = keys.attack;
    return command;
}

void Play::tick(const FlightInput& keys, bool level_stands, Session& session) {
    PlayerCommand command = command_of(keys, session.camera().angles());
    if (script_) {
        command = script_->command_at(script_tick_++);
        session.camera().set(session.camera().origin(), command.angles);
    }
    if (recording_) recording_->add(command);
    game_->tick(command, level_stands);
    if (!walking_) return;
    glm::vec3 angles = session.camera().angles();
    angles.y += game_->take_view_turn();
    if (const std::optional<glm::vec3> view = game_->take_view()) angles = *view;
    if (angles != session.camera().angles())
        session.camera().set(session.camera().origin(), angles);
}

void Play::frame(const FlightInput& keys, double seconds, bool level_stands, Session& session) {
    const auto frame_s = static_cast<float>(seconds);
    if (!script_) {
        if (walking_)
            session.camera().look(keys, frame_s);
        else
            session.camera().fly(keys, frame_s);
    }
    clock_s_ += seconds;
    constexpr double tick_s = 1.0 / player::ticks_per_second;
    while (clock_s_ >= tick_s - rounding_s) {
        clock_s_ -= tick_s;
        tick(keys, level_stands && !script_, session);
        if (script_ && script_tick_ == script_->ticks()) {
            // The rest of the frame is nobody's, so that all frame rates end with the same tick;
            // what is shown is its end.
            script_.reset();
            clock_s_ = tick_s;
            show(session);
            clock_s_ = 0.0;
            return;
        }
    }
    show(session);
}

void Play::show(Session& session) {
    const double part = clock_s_ * player::ticks_per_second;
    const float fraction = static_cast<float>(std::clamp(part, 0.0, 1.0));
    if (walking_) session.camera().set(game_->eye_at(fraction), session.camera().angles());
    show_models(session, fraction);
    show_styles(session);
    show_lights(session, fraction);
}

void Play::show_models(Session& session, float fraction) {
    const auto rests_as = [](const MovedModel& a, const MovedModel& b) {
        const auto same = [](const Placement& p, const Placement& q) {
            return p.origin == q.origin && p.angles == q.angles;
        };
        return a.shown == b.shown && same(a.before, a.now) && same(a.now, b.now) &&
               same(b.before, b.now);
    };
    std::vector<MovedModel> models = game_->moved_models();
    for (size_t i = 0; i < models.size(); ++i) {
        const MovedModel& model = models[i];
        if (i < shown_models_.size() && rests_as(model, shown_models_[i])) continue;
        const Placement place = model.at(fraction);
        session.place_entity(model.number, place.origin, place.angles, model.shown);
    }
    shown_models_ = std::move(models);
}

void Play::show_styles(Session& session) {
    if (shown_styles_ == game_->light_styles()) return;
    LightStyles styles = session.light_styles();
    for (const auto& [style, letters] : game_->light_styles()) {
        const auto shown = shown_styles_.find(style);
        if (shown == shown_styles_.end() || shown->second != letters)
            styles.set_pattern(style, letters);
    }
    shown_styles_ = game_->light_styles();
    session.set_light_styles(std::move(styles));
}

void Play::show_lights(Session& session, float fraction) const {
    session.remove_dynamic_lights(first_bolt_light, last_play_light);
    for (const Bolt& bolt : game_->bolts().flying())
        session.set_dynamic_light(dynamic_light(first_bolt_light + (bolt.id & light_id_mask),
                                                glm::mix(bolt.before, bolt.now, fraction),
                                                bolt_light));
    for (const Glow& hit : game_->bolts().hits())
        session.set_dynamic_light(
            dynamic_light(first_hit_light + (hit.id & light_id_mask), hit.place,
                          {hit_light.radius * hit.brightness(), hit_light.color}));
    for (const Glow& explosion : game_->explosions().glowing())
        session.set_dynamic_light(dynamic_light(
            first_explosion_light + (explosion.id & light_id_mask), explosion.place,
            {explosion_light.radius * explosion.brightness(), explosion_light.color}));
}

bool Play::set_walking(bool walking, Session& session) {
    if (walking == walking_) return true;
    walking_ = walking;
    bool roomy = true;
    if (walking) {
        const glm::vec3 wanted =
            session.camera().origin() - glm::vec3(0.0f, 0.0f, player::standing_eye);
        const PlayerState there = place_player(wanted, game_->collision());
        // Outside of the level there are no brushes, but its leaf is solid.
        const CollisionWorld& collision = game_->collision();
        roomy = collision.is_free(there.origin, player::standing_box, mask_player_solid) &&
                (collision.contents_at(there.origin) & CONTENTS_SOLID) == 0;
        PlayerState& player = game_->player();
        const glm::vec3 origin = roomy ? there.origin : player.origin;
        player = {};
        game_->place_player_at(origin);
        // What turned without a player does not turn the view.
        game_->take_view();
        game_->take_view_turn();
    }
    game_->set_player_present(walking);
    return roomy;
}

void Play::kill(Session& session) {
    game_->hurt_player(game_->health());
    session.camera().set(session.camera().origin(), find_start(session.level()->bsp).angles);
    show(session);
}

void Play::follow(Walk walk) {
    script_ = std::move(walk);
    script_tick_ = 0;
}

void Play::record(std::string path) {
    recording_.emplace();
    recorded_path_ = std::move(path);
}

std::optional<Walk> Play::take_recording() {
    return std::exchange(recording_, std::nullopt);
}

void Play::clear(Session& session) {
    session.remove_dynamic_lights(first_bolt_light, last_play_light);
    session.restore_level();
}

} // namespace vigil::client
