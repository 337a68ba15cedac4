// SPDX-License-Identifier: GPL-2.0-or-later
// One view of the level, from the engine's structures to the renderer's: entities, lights, beams,
// particles, light styles, and numbers that stay with them. docs/internals/front-end.md has
// what is not obvious of it.
#pragma once

#include "refresh/preview/preview.h"
#include "yamagi/identities.h"
#include "yamagi/level_lights.h"
#include "yamagi/models.h"

#include <array>
#include <vector>

namespace vigil::yamagi {

/// How the weapon in hand is shown.
struct WeaponView {
    bool shown = true;
    bool left_handed = false;
    float fov_y = 0.0f; // vertical degrees; 0 or less: those of the view
};

/// refresh::Entity::view_scale of the weapon in a view of `fov_y` vertical degrees.
glm::vec2 weapon_scale(const WeaponView& weapon, float fov_y);

class LevelView {
public:
    /// Takes over what the view shows. `screen` is the size that the engine draws for;
    /// `light_brightness` a factor on the radiance of dynamic lights.
    void read(const EngineView& view, glm::ivec2 screen, Models& models, const Screen& colors,
              float light_brightness);
    /// From the next read() on.
    void show_weapon(const WeaponView& weapon) { weapon_ = weapon; }
    /// Another level, lit by these besides: numbers begin anew.
    void begin_level(std::vector<LevelLight> lights);

    /// The frame without settings and draws; its spans are good until the next read().
    refresh::Frame frame() const;

private:
    void read_entities(std::span<const ViewEntity> entities, const EngineView& view, Models& models,
                       const Screen& colors);
    void read_lights(std::span<const ViewLight> lights, double time_s, float brightness);
    void read_particles(std::span<const ViewParticle> particles, const Screen& colors);

    refresh::View view_;
    WeaponView weapon_;
    double time_s_ = 0.0;
    std::array<float, refresh::light_style_count> styles_{};
    std::vector<refresh::Entity> entities_;
    std::vector<refresh::Beam> beams_;
    std::vector<refresh::DynamicLight> lights_;
    std::vector<LevelLight> level_lights_;
    std::vector<refresh::Particle> particles_;
    Identities entity_ids_, beam_ids_, light_ids_;
    std::vector<Sighting> seen_; // of one kind of things
};

/// Under water the picture breathes and sways: the vertical angle by 2%, the roll by a degree, two
/// times in five seconds.
void waver(refresh::View& view, double time_s);

/// How a model without a level is seen; empty where the view shows nothing.
std::vector<refresh::PreviewModel> preview_models(const EngineView& view);

} // namespace vigil::yamagi
