// SPDX-License-Identifier: GPL-2.0-or-later
#include "yamagi/level_view.h"

#include "formats/game_palette.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace vigil::yamagi {

namespace {

using refresh::particle_radiance;

/// Sparks are drawn with this part of full brightness: more would be white, whatever their colour.
constexpr float spark_brightness = 0.2f;
constexpr float spark_size = 0.7f; // map units

/// The engine's client moves the eye, though not the weapon before it, so that it lies on no plane
/// of the level.
constexpr float client_shift = 1.0f / 16.0f;

/// A flash is beside its weapon and lasts a frame or two. As small as game_light_size has it, it
/// burns out what is near, and few pixels find it in time. So the ball is of the game's radius /
/// 16, with the same light in all.
constexpr float effect_size = 1.0f / 16.0f;
constexpr float effect_radiance = refresh::game_light_radiance *
                                  (refresh::game_light_size / effect_size) *
                                  (refresh::game_light_size / effect_size);

constexpr float smallest_beam = 0.5f;

/// Of lights that belong to the level; matched ones count from 1.
constexpr uint32_t first_level_id = 0x80000000u;

glm::vec3 vec(const float (&values)[3]) {
    return {values[0], values[1], values[2]};
}

template <typename T> std::span<const T> list(const T* first, int count) {
    return {first, first != nullptr && count > 0 ? static_cast<size_t>(count) : 0};
}

bool has(const ViewEntity& entity, uint32_t flags) {
    return (static_cast<uint32_t>(entity.flags) & flags) != 0;
}

/// The game's colours of what surrounds a body.
glm::vec3 shell_color(const ViewEntity& entity) {
    glm::vec3 color(0.0f);
    if (has(entity, flag_shell_half_damage)) color = {0.56f, 0.59f, 0.45f};
    if (has(entity, flag_shell_double)) color = glm::max(color, glm::vec3(0.9f, 0.7f, 0.0f));
    if (has(entity, flag_shell_red)) color.x = 1.0f;
    if (has(entity, flag_shell_green)) color.y = 1.0f;
    if (has(entity, flag_shell_blue)) color.z = 1.0f;
    return color;
}

glm::vec3 glow_of(const ViewEntity& entity, const EngineView& view) {
    const bool sprite = entity.model->name.ends_with(".sp2");
    if (sprite || has(entity, flag_full_bright)) return glm::vec3(particle_radiance);
    if ((view.flags & view_infrared) != 0 && has(entity, flag_infrared_visible))
        return {particle_radiance, 0.0f, 0.0f};
    return glm::vec3(refresh::game_glow(has(entity, flag_min_light), has(entity, flag_glow),
                                        static_cast<double>(view.time_s)));
}

/// Things with other values are never the same: model, skin and what they are drawn as.
uint64_t kind_of(const ViewEntity& entity) {
    constexpr uint32_t ways = flag_viewer_model | flag_weapon_model | flag_depth_hack | flags_shell;
    const auto model = reinterpret_cast<uintptr_t>(entity.model);
    const auto skin = reinterpret_cast<uintptr_t>(entity.skin);
    constexpr uint64_t mix = 0x9e3779b97f4a7c15u;
    return (model * mix ^ skin) * mix ^ (static_cast<uint32_t>(entity.flags) & ways);
}

Sighting sighting_of(const ViewEntity& entity) {
    return {kind_of(entity), vec(entity.origin), std::nullopt, entity.frame, entity.old_frame};
}

float tangent_of_half(float degrees) {
    return std::tan(0.5f * glm::radians(std::clamp(degrees, 1.0f, 170.0f)));
}

refresh::Beam beam_of(const ViewEntity& entity, const Screen& colors) {
    refresh::Beam beam;
    beam.from = vec(entity.origin);
    beam.to = vec(entity.old_origin);
    beam.radius = std::max(0.5f * static_cast<float>(entity.frame), smallest_beam);
    beam.radiance = particle_radiance * colors.linear_color(entity.skin_number);
    return beam;
}

refresh::Entity entity_of(const ViewEntity& source, const EngineView& view, Models& models) {
    refresh::Entity entity;
    entity.model = models.handle_of(*source.model);
    entity.origin = vec(source.origin);
    entity.angles = vec(source.angles);
    // The game's renderers roll models, though not parts of a level, the other way round.
    if (!source.model->name.starts_with('*')) entity.angles.z = -entity.angles.z;
    entity.skin = source.skin_number;
    entity.custom_skin = models.skin_of(source.skin);
    entity.frame = source.frame;
    entity.old_frame = source.old_frame;
    entity.backlerp = std::clamp(source.backlerp, 0.0f, 1.0f);
    if (has(source, flag_translucent)) entity.alpha = std::clamp(source.alpha, 0.0f, 1.0f);
    if (has(source, flag_viewer_model)) entity.flags |= refresh::entity_hidden_from_camera;
    if (has(source, flag_weapon_model | flag_depth_hack)) entity.flags |= refresh::entity_weapon;
    entity.glow = glow_of(source, view);
    if (has(source, flags_shell)) entity.shell = shell_color(source);
    return entity;
}

} // namespace

void LevelView::begin_level(std::vector<LevelLight> lights) {
    level_lights_ = std::move(lights);
    entity_ids_.clear();
    beam_ids_.clear();
    light_ids_.clear();
}

glm::vec2 weapon_scale(const WeaponView& weapon, float fov_y) {
    const float own = weapon.fov_y > 0.0f ? weapon.fov_y : fov_y;
    const float scale = tangent_of_half(fov_y) / tangent_of_half(own);
    return {weapon.left_handed ? -scale : scale, scale};
}

void waver(refresh::View& view, double time_s) {
    constexpr double turns_per_s = 0.4, breath = 0.02, sway = 1.0; // degrees
    const double phase = 2.0 * std::numbers::pi * std::fmod(turns_per_s * time_s, 1.0);
    view.fov_y *= static_cast<float>(1.0 + breath * std::sin(phase));
    view.angles.z += static_cast<float>(sway * std::cos(phase));
}

void LevelView::read(const EngineView& view, glm::ivec2 screen, Models& models,
                     const Screen& colors, float light_brightness) {
    time_s_ = static_cast<double>(view.time_s);
    view_.origin = vec(view.origin) - client_shift;
    view_.angles = vec(view.angles);
    // A view smaller than the screen is the middle of one as high as the screen.
    const float half = tangent_of_half(view.fov_y);
    const float rows =
        static_cast<float>(std::max(screen.y, 1)) / static_cast<float>(std::max(view.height, 1));
    view_.fov_y = std::clamp(2.0f * glm::degrees(std::atan(half * rows)), 1.0f, 175.0f);
    if ((view.flags & view_underwater) != 0) waver(view_, time_s_);
    styles_.fill(1.0f);
    for (size_t i = 0; view.light_styles != nullptr && i < styles_.size(); ++i) {
        const float(&rgb)[3] = view.light_styles[i].rgb;
        styles_.at(i) = std::max((rgb[0] + rgb[1] + rgb[2]) / 3.0f, 0.0f);
    }
    read_entities(list(view.entities, view.entity_count), view, models, colors);
    read_lights(list(view.lights, view.light_count), time_s_, light_brightness);
    read_particles(list(view.particles, view.particle_count), colors);
}

void LevelView::read_entities(std::span<const ViewEntity> entities, const EngineView& view,
                              Models& models, const Screen& colors) {
    entities_.clear();
    beams_.clear();
    seen_.clear();
    for (const ViewEntity& entity : entities) {
        if (has(entity, flag_beam) || entity.model == nullptr) continue;
        const bool weapon = has(entity, flag_weapon_model);
        if (weapon && !weapon_.shown) continue;
        entities_.push_back(entity_of(entity, view, models));
        if (weapon) entities_.back().view_scale = weapon_scale(weapon_, view.fov_y);
        seen_.push_back(sighting_of(entity));
    }
    const std::vector<uint32_t> numbers = entity_ids_.assign(seen_, time_s_);
    for (size_t i = 0; i < numbers.size(); ++i)
        entities_[i].number = static_cast<int>(numbers[i]);

    seen_.clear();
    for (const ViewEntity& entity : entities) {
        if (!has(entity, flag_beam)) continue;
        beams_.push_back(beam_of(entity, colors));
        // Its colour is drawn anew in each frame.
        seen_.push_back(
            {static_cast<uint64_t>(entity.frame), beams_.back().from, beams_.back().to, 0, 0});
    }
    const std::vector<uint32_t> ids = beam_ids_.assign(seen_, time_s_);
    for (size_t i = 0; i < ids.size(); ++i)
        beams_[i].id = ids[i];
}

void LevelView::read_lights(std::span<const ViewLight> lights, double time_s, float brightness) {
    lights_.clear();
    seen_.clear();
    for (const ViewLight& light : lights) {
        // The game has lights that darken; light that is less than nothing is none.
        const glm::vec3 color = glm::max(vec(light.color), glm::vec3(0.0f));
        if (!(light.intensity > 0.0f) || color == glm::vec3(0.0f)) continue;
        refresh::DynamicLight& shown = lights_.emplace_back();
        shown.origin = vec(light.origin);
        shown.radius = effect_size * light.intensity;
        shown.radiance = brightness * effect_radiance * light.intensity * color;
        shown.visible = false;
        const glm::uvec3 hue(glm::round(16.0f * glm::min(color, glm::vec3(8.0f))));
        seen_.push_back({hue.x | hue.y << 8 | hue.z << 16, shown.origin, std::nullopt, 0, 0});
    }
    const std::vector<uint32_t> ids = light_ids_.assign(seen_, time_s);
    for (size_t i = 0; i < ids.size(); ++i)
        lights_[i].id = ids[i];
    for (size_t i = 0; i < level_lights_.size(); ++i) {
        const LevelLight& light = level_lights_[i];
        // One that is dark now keeps its place, so that it can flicker.
        const float style = std::max(styles_.at(static_cast<size_t>(light.style)), 0.0f);
        lights_.push_back({first_level_id + static_cast<uint32_t>(i), light.origin,
                           level_light_radius, style * light.radiance, false});
    }
}

void LevelView::read_particles(std::span<const ViewParticle> particles, const Screen& colors) {
    particles_.clear();
    for (const ViewParticle& source : particles) {
        refresh::Particle& particle = particles_.emplace_back();
        particle.origin = vec(source.origin);
        particle.size = spark_size;
        particle.color = spark_brightness * colors.linear_color(source.color);
        particle.alpha = std::clamp(source.alpha, 0.0f, 1.0f);
    }
}

refresh::Frame LevelView::frame() const {
    refresh::Frame frame;
    frame.view = view_;
    frame.time_s = time_s_;
    frame.entities = entities_;
    frame.dynamic_lights = lights_;
    frame.beams = beams_;
    frame.particles = particles_;
    frame.light_styles = styles_;
    return frame;
}

std::vector<refresh::PreviewModel> preview_models(const EngineView& view) {
    std::vector<refresh::PreviewModel> models;
    for (const ViewEntity& entity : list(view.entities, view.entity_count)) {
        if (entity.model == nullptr || !entity.model->name.ends_with(".md2")) continue;
        refresh::PreviewModel& model = models.emplace_back();
        model.model = entity.model->name;
        if (entity.skin != nullptr) model.skin = static_cast<const Picture*>(entity.skin)->file;
        model.skin_number = entity.skin_number;
        model.origin = vec(entity.origin);
        model.angles = vec(entity.angles);
        model.frame = entity.frame;
        model.old_frame = entity.old_frame;
        model.backlerp = std::clamp(entity.backlerp, 0.0f, 1.0f);
        if (has(entity, flag_translucent)) model.alpha = std::clamp(entity.alpha, 0.0f, 1.0f);
    }
    return models;
}

} // namespace vigil::yamagi
