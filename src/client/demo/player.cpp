// SPDX-License-Identifier: GPL-2.0-or-later
// From a demo's frames to what is rendered.
#include "client/demo/player.h"

#include "common/error.h"
#include "common/game_path.h"
#include "common/log.h"
#include "common/printable.h"
#include "formats/dm2_protocol.h"

#include <algorithm>
#include <cmath>
#include <fmt/ranges.h>

namespace vigil::client {

namespace {

// Farther in a tenth of a second is a jump: nothing is interpolated (limits of the game).
constexpr float farthest_player_step = 256.0f, farthest_entity_step = 512.0f;
/// Longer pauses between frames, in frames, are shortened.
constexpr int longest_pause = 10;
/// Glow of a player is above the head: inside the body nothing would see it.
constexpr float player_glow_height = 40.0f;
constexpr uint8_t player_model_index = 255;
constexpr float translucent_alpha = 0.7f; // as in the game
constexpr int weapon_entity = 4 * dm2::most_entities;

bool jumps(const glm::vec3& from, const glm::vec3& to, float farthest) {
    return glm::any(glm::greaterThan(glm::abs(to - from), glm::vec3(farthest)));
}

/// Degrees, the short way round.
glm::vec3 mix_angles(const glm::vec3& from, const glm::vec3& to, float part) {
    glm::vec3 angles;
    for (int i = 0; i < 3; ++i)
        angles[i] = from[i] + part * std::remainder(to[i] - from[i], 360.0f);
    return angles;
}

std::string_view without_line_end(std::string_view text) {
    while (text.ends_with('\n'))
        text.remove_suffix(1);
    return text;
}

/// Number of the frame that an effect shows of itself, or -1.
int automatic_frame(uint32_t effects, double time_s) {
    const int half = static_cast<int>(2.0 * time_s);
    if ((effects & dm2::EF_ANIM01) != 0) return half & 1;
    if ((effects & dm2::EF_ANIM23) != 0) return 2 + (half & 1);
    if ((effects & dm2::EF_ANIM_ALL) != 0) return half;
    if ((effects & dm2::EF_ANIM_ALLFAST) != 0) return static_cast<int>(10.0 * time_s);
    return -1;
}

/// Radiance that the flags of a model ask for.
float glow_of(const dm2::EntityState& entity, double time_s) {
    const auto has = [&](uint32_t flag) { return (entity.render_flags & flag) != 0; };
    if (has(dm2::RF_FULLBRIGHT)) return refresh::particle_radiance;
    return refresh::game_glow(has(dm2::RF_MINLIGHT), has(dm2::RF_GLOW), time_s);
}

} // namespace

DemoPlayer::DemoPlayer(std::string name, std::vector<uint8_t> bytes)
    : reader_(std::move(name), std::move(bytes)) {}

void DemoPlayer::start(Session& session) {
    next_ = reader_.next();
    if (!next_) {
        if (!fault().empty()) fail("{}", fault());
        fail("{}: there is no frame in this demo", name());
    }
    take(*std::exchange(next_, std::nullopt), session);
    part_ = 1.0f;
    show(session);
}

bool DemoPlayer::at_level_change() const {
    return next_ && std::ranges::any_of(next_->messages, [](const dm2::Message& message) {
               return std::holds_alternative<dm2::ServerData>(message);
           });
}

void DemoPlayer::step(Session& session) {
    if (!next_) return;
    take(*std::exchange(next_, std::nullopt), session);
    part_ = 1.0f;
    show(session);
}

void DemoPlayer::advance(double seconds, Session& session) {
    part_ += static_cast<float>(seconds * dm2::frames_per_second);
    while (part_ > 1.0f && next_) {
        const int64_t frames = int64_t{next_->frame.number} - now_.number;
        part_ -= static_cast<float>(std::clamp<int64_t>(frames, 1, longest_pause));
        take(*std::exchange(next_, std::nullopt), session);
    }
    if (part_ > 1.0f) {
        part_ = 1.0f;
        finished_ = true;
    }
    show(session);
}

void DemoPlayer::take(DemoStep step, Session& session) {
    for (const dm2::Message& message : step.messages)
        take_message(message, session);
    follows_ = !level_wanted_ && frames_ > 0;
    if (level_wanted_) start_level(session);
    last_ = std::move(now_);
    now_ = std::move(step.frame);
    ++frames_;
    if (styles_changed_) follow_light_styles(session);

    // What begins in this frame begins when the one before it ends.
    const double begin_s = level_time(0.0f);
    for (const dm2::Message& message : step.messages) {
        if (const auto* effect = std::get_if<dm2::TempEntity>(&message)) {
            effects_.add(*effect, begin_s);
        } else if (const auto* flash = std::get_if<dm2::MuzzleFlash>(&message)) {
            const dm2::EntityState* holder = dm2::find_entity(now_.entities, flash->entity);
            if (holder != nullptr) effects_.add(*flash, holder->origin, holder->angles, begin_s);
        }
    }
    for (const dm2::EntityState& entity : now_.entities) {
        const dm2::EntityState* old = before(entity);
        if (old != nullptr && old->origin != entity.origin)
            effects_.add_trail(entity.effects, old->origin, entity.origin, begin_s);
    }
    next_ = reader_.next();
}

void DemoPlayer::take_message(const dm2::Message& message, Session& session) {
    if (const auto* data = std::get_if<dm2::ServerData>(&message)) {
        strings_.clear();
        models_.clear();
        effects_ = {};
        player_ = data->player_number;
        level_wanted_ = true;
        const std::string& folder = data->game_folder;
        if (!folder.empty() && folder != "baseq2")
            log_info("{}: recorded with the game \"{}\". `game` names the folder of its files.",
                     name(), printable(folder));
        if (log_texts_ && !data->level_title.empty())
            log_info("{}: {}", name(), printable(data->level_title));
    } else if (const auto* string = std::get_if<dm2::ConfigString>(&message)) {
        strings_[string->index] = string->text;
        styles_changed_ |= string->index >= dm2::CS_LIGHTS && string->index < dm2::CS_ITEMS;
        const bool is_model = string->index > dm2::CS_MODELS && string->index < dm2::CS_SOUNDS;
        if (is_model && !level_wanted_) model_named(string->text, session);
    } else if (const auto* print = std::get_if<dm2::Print>(&message)) {
        if (log_texts_) log_info("{}", printable(without_line_end(print->text)));
    } else if (const auto* center = std::get_if<dm2::CenterPrint>(&message)) {
        if (log_texts_) log_info("{}", printable(without_line_end(center->text)));
    }
}

void DemoPlayer::start_level(Session& session) {
    level_wanted_ = false;
    const std::string& map = strings_[dm2::CS_MODELS + 1];
    if (map.empty()) fail("{}: the demo does not say which level it plays in", name());
    try {
        session.load_map(map);
    } catch (const Error& error) {
        fail("{}: its level cannot be shown: {}", name(), error.what());
    }
    now_ = {};
    styles_changed_ = true;

    // Models are loaded before anything moves. Brush models are loaded when they appear: a demo
    // names all, also those that are never seen.
    std::vector<std::string> missing;
    for (uint32_t i = 2; i < dm2::model_count; ++i) {
        const std::string& model = strings_[dm2::CS_MODELS + i];
        if (model.empty() || model.starts_with('*') || model.starts_with('#')) continue;
        if (model_named(model, session) < 0) missing.push_back(printable(model));
    }
    if (!missing.empty())
        log_info("{}: {} models cannot be shown: {}", name(), missing.size(),
                 fmt::join(missing, ", "));
}

void DemoPlayer::follow_light_styles(Session& session) {
    styles_changed_ = false;
    LightStyles styles;
    for (uint32_t i = 0; i < dm2::light_style_count; ++i) {
        const auto string = strings_.find(dm2::CS_LIGHTS + i);
        try {
            styles.set_pattern(static_cast<int>(i),
                               string != strings_.end() ? string->second : std::string());
        } catch (const Error& error) {
            log_warning("{}: light style {}: {}", name(), i, printable(error.what()));
        }
    }
    session.set_light_styles(styles);
}

double DemoPlayer::level_time(float part) const {
    // Frame 1 is time 0.
    return std::max(0.0, (now_.number - 2.0 + static_cast<double>(part)) / dm2::frames_per_second);
}

const dm2::EntityState* DemoPlayer::before(const dm2::EntityState& entity) const {
    if (!follows_) return nullptr;
    const dm2::EntityState* old = dm2::find_entity(last_.entities, entity.number);
    const bool teleports =
        entity.event == dm2::EV_PLAYER_TELEPORT || entity.event == dm2::EV_OTHER_TELEPORT;
    if (old == nullptr || teleports || old->models != entity.models ||
        jumps(old->origin, entity.origin, farthest_entity_step))
        return nullptr;
    return old;
}

void DemoPlayer::show(Session& session) {
    PlayedScene scene;
    show_player(scene, session);
    for (const dm2::EntityState& entity : now_.entities)
        show_entity(entity, scene, session);
    const double time_s = level_time(std::clamp(part_, 0.0f, 1.0f));
    effects_.show(time_s, scene);
    session.play(std::move(scene), time_s);
}

void DemoPlayer::show_player(PlayedScene& scene, Session& session) {
    const dm2::PlayerState& now = now_.player;
    const bool smooth = follows_ && !jumps(last_.player.origin, now.origin, farthest_player_step);
    const dm2::PlayerState& old = smooth ? last_.player : now;
    const float part = std::clamp(part_, 0.0f, 1.0f);
    const glm::vec3 eye =
        glm::mix(old.origin + old.view_offset, now.origin + now.view_offset, part);
    const glm::vec3 angles = mix_angles(old.view_angles, now.view_angles, part) +
                             mix_angles(old.kick_angles, now.kick_angles, part);
    session.camera().set(eye, angles);
    const float fov = glm::mix(static_cast<float>(old.fov), static_cast<float>(now.fov), part);
    scene.fov = fov >= 1.0f ? std::min(fov, 170.0f) : 90.0f;

    if (now.weapon_model == 0) return;
    refresh::Entity weapon;
    weapon.number = weapon_entity;
    weapon.model = model(now.weapon_model, {}, session);
    if (weapon.model < 0) return;
    const bool same = old.weapon_model == now.weapon_model;
    weapon.origin = eye + glm::mix(old.weapon_offset, now.weapon_offset, part);
    weapon.angles = angles + mix_angles(old.weapon_angles, now.weapon_angles, part);
    weapon.frame = now.weapon_frame;
    weapon.old_frame = same ? old.weapon_frame : now.weapon_frame;
    weapon.backlerp = 1.0f - part;
    // As the game's client: it reaches into walls, is never quite dark, and rolls the other way.
    weapon.angles.z = -weapon.angles.z;
    weapon.flags = refresh::entity_weapon;
    weapon.glow = glm::vec3(refresh::game_glow(true, false, 0.0));
    scene.entities.push_back(weapon);
}

void DemoPlayer::show_entity(const dm2::EntityState& entity, PlayedScene& scene, Session& session) {
    const float part = std::clamp(part_, 0.0f, 1.0f);
    const double time_s = level_time(part);
    const dm2::EntityState* found = before(entity);
    const dm2::EntityState& old = found != nullptr ? *found : entity;
    const glm::vec3 origin = glm::mix(old.origin, entity.origin, part);
    const auto number = static_cast<int>(entity.number);

    if ((entity.render_flags & dm2::RF_BEAM) != 0) {
        const glm::vec3 end = glm::mix(found != nullptr ? old.old_origin : entity.old_origin,
                                       entity.old_origin, part);
        scene.beams.push_back({entity.number, origin, end, 0.5f * static_cast<float>(entity.frame),
                               refresh::particle_radiance * laser_color(entity.skin)});
        return;
    }
    const bool is_player = entity.models[0] == player_model_index;
    uint32_t light_id = 8 * entity.number;
    for (const EffectLight& light : entity_lights(entity)) {
        const glm::vec3 above(0.0f, 0.0f, is_player ? player_glow_height : 0.0f);
        scene.dynamic_lights.push_back(dynamic_light(light_id++, origin + above, light));
    }
    if (number == player_ + 1) return; // whose eyes we see through

    refresh::Entity shown;
    shown.origin = origin;
    shown.angles = mix_angles(old.angles, entity.angles, part);
    const auto turned = static_cast<float>(std::fmod(time_s, 3600.0));
    if ((entity.effects & dm2::EF_ROTATE) != 0)
        shown.angles = {0.0f, std::fmod(100.0f * turned, 360.0f), 0.0f};
    else if ((entity.effects & dm2::EF_SPINNINGLIGHTS) != 0)
        shown.angles = {0.0f, std::fmod(500.0f * turned, 360.0f) + entity.angles.y, 180.0f};
    shown.frame = entity.frame;
    shown.old_frame = old.frame;
    shown.backlerp = 1.0f - part;
    if (const int frame = automatic_frame(entity.effects, time_s); frame >= 0)
        shown.frame = shown.old_frame = frame;
    // 256 and more are colours of other things than skins.
    shown.skin = is_player || entity.skin > 0xff ? 0 : static_cast<int>(entity.skin);
    const float glow = glow_of(entity, time_s);
    if ((entity.render_flags & dm2::RF_TRANSLUCENT) != 0) shown.alpha = translucent_alpha;
    for (size_t slot = 0; slot < entity.models.size(); ++slot) {
        // A second model 255 is the player's weapon, whose file his own model names.
        if (entity.models[slot] == 0 || (slot > 0 && entity.models[slot] == player_model_index))
            continue;
        shown.number = number + static_cast<int>(slot * dm2::most_entities);
        shown.model = model(entity.models[slot], entity, session);
        const auto name = strings_.find(dm2::CS_MODELS + entity.models[slot]);
        const bool sprite = name != strings_.end() && name->second.ends_with(".sp2");
        shown.glow = glm::vec3(sprite ? refresh::particle_radiance : glow);
        if (shown.model >= 0) scene.entities.push_back(shown);
    }
}

refresh::ModelHandle DemoPlayer::model(uint8_t index, const dm2::EntityState& entity,
                                       Session& session) {
    if (index == player_model_index) return model_named(player_model(entity.skin), session);
    const auto name = strings_.find(dm2::CS_MODELS + index);
    return name != strings_.end() ? model_named(name->second, session) : -1;
}

refresh::ModelHandle DemoPlayer::model_named(const std::string& name, Session& session) {
    const auto known = models_.find(name);
    if (known != models_.end()) return known->second;
    refresh::ModelHandle handle = -1;
    try {
        if (!name.empty() && !name.starts_with('#'))
            handle = session.renderer().register_model(name);
    } catch (const Error& error) {
        if (frames_ > 0) log_warning("{}: {}", this->name(), printable(error.what()));
    }
    return models_.emplace(name, handle).first->second;
}

std::string DemoPlayer::player_model(uint32_t skin) const {
    // "name\model/skin", numbered by the low byte.
    const auto text = strings_.find(dm2::CS_PLAYERSKINS + (skin & 0xff));
    std::string model = "male";
    if (text != strings_.end()) {
        const size_t begin = text->second.find('\\'), end = text->second.find('/');
        if (begin != std::string::npos && end != std::string::npos && end > begin + 1)
            model = text->second.substr(begin + 1, end - begin - 1);
    }
    return fmt::format("players/{}/tris.md2", model);
}

} // namespace vigil::client
