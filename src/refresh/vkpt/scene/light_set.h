// SPDX-License-Identifier: GPL-2.0-or-later
// All lights of a frame under stable ids: those of the static world first (lamps, windows to the
// sky, the sun), then those of entities and dynamic lights in slots that stay theirs while they
// exist. A vanished light's slot is dark until another takes it. A light whose place or radiance is
// not finite, or negative, stays dark.
#pragma once

#include "refresh/refresh.h"
#include "refresh/vkpt/scene/model_geometry.h"
#include "refresh/vkpt/scene/sky_brightness.h"

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

namespace vigil::vkpt {

/// Triangles of a dynamic light's octahedron.
inline constexpr uint32_t dynamic_light_triangles = 8;

/// Lights beyond those of the static world that a set holds at most: a level may place a model of
/// many lights many times.
inline constexpr uint32_t max_moving_lights = 1u << 20;

/// Frames for which a light that went out is known still: `vlc` keeps a light of a cache for at
/// least as long where not every frame teaches.
inline constexpr uint64_t flicker_frames = 32;

/// The octahedron of a dynamic light of radius 1 around the origin, wound outwards.
ModelGeometry dynamic_light_geometry(uint32_t material);

/// The tube and the square of a Spot of radius 1, mouth at the origin, looking along +x.
ModelGeometry spot_geometry(uint32_t lamp_material, uint32_t tube_material);

/// Sky and sun as the lights of a frame.
struct Environment {
    const SkyBrightness* sky = nullptr; // null: windows are dark
    uint64_t sky_revision = 0;          // another one for another `sky`
    float sky_scale = 1.0f;
    shader::Light sun{};   // sun_light()
    float sun_sine = 0.0f; // of half the angle that it takes up
};

class LightSet {
public:
    LightSet() = default;
    /// Starts a level whose static world has these lights, and the sun after them if `has_sun`.
    explicit LightSet(std::vector<LightSource> world_lights, bool has_sun = false);

    /// What a frame asks of the set; call begin_frame, then place() for every model with lights,
    /// then end_frame.
    void begin_frame(std::span<const float> light_styles, float emissive_scale,
                     const Environment& environment = {});
    /// Places a model's lights; `key` names the entity or dynamic light while it exists. `tint`
    /// multiplies radiance. Returns the id of the model's light 0; nothing if there is no room.
    std::optional<uint32_t> place(uint64_t key, std::span<const LightSource> sources,
                                  const glm::mat4x3& world_from_object, glm::vec3 tint);
    /// Darkens what was not placed. Light ids are valid until the next begin_frame.
    void end_frame();

    /// Lights by id; dark slots have zero radiance.
    std::span<const shader::Light> lights() const { return lights_; }
    /// Those of the static world as they came, by id; but for the sun.
    std::span<const LightSource> world() const { return world_; }
    /// Ids below this belong to the static world: their geometry never changes, but for the sun's.
    uint32_t static_count() const { return static_count_; }
    /// Id of the sun, or shader::NONE.
    uint32_t sun() const { return has_sun_ ? static_count_ - 1 : shader::NONE; }
    /// Whether it may shine in through this light: a window to the sky that faces a part of it.
    bool sun_enters(const shader::Light& window) const;
    /// Where the sun shines in changes with this, which grows.
    uint64_t sun_revision() const { return sun_revision_; }
    /// Whether a model that may move has had a window to the sky.
    bool has_moving_sky() const { return has_moving_sky_; }
    /// Grows whenever any light differs from the frame before.
    uint64_t revision() const { return revision_; }
    /// Grows whenever a light appears, vanishes or moves; not where one dims, nor where one that
    /// went out in the last flicker_frames goes on, or out again.
    uint64_t place_revision() const { return place_revision_; }
    /// Grows whenever a light appears that was dark for flicker_frames or more.
    uint64_t new_revision() const { return new_revision_; }
    /// Grows whenever a light beyond static_count() appears, vanishes, moves, goes out or on.
    uint64_t moving_revision() const { return moving_revision_; }

private:
    struct Slot {
        uint32_t first = 0;
        uint32_t count = 0;
        bool placed = false;
    };
    void write(uint32_t id, const LightSource& source, const glm::mat4x3& world_from_object,
               glm::vec3 tint);
    /// Makes `light` that of an id, unless nothing of it can be used.
    void replace(uint32_t id, shader::Light light);
    /// Darkens a slot that nothing owns any more and keeps it for the next light.
    void release(const Slot& slot);

    std::vector<LightSource> world_;
    std::vector<shader::Light> lights_;
    uint64_t frame_ = flicker_frames;
    std::vector<uint64_t> went_out_; // in which frame, by id; 0: never
    std::map<uint64_t, Slot> slots_;
    std::vector<Slot> free_;
    bool reported_not_finite_ = false; // of a light that stays dark because it is not finite
    std::vector<float> styles_;
    float scale_ = 1.0f;
    Environment environment_;
    bool has_sun_ = false;
    bool has_moving_sky_ = false;
    uint64_t sun_revision_ = 1;
    uint32_t static_count_ = 0;
    uint64_t revision_ = 1;
    uint64_t place_revision_ = 1;
    uint64_t new_revision_ = 1;
    uint64_t moving_revision_ = 1;
};

} // namespace vigil::vkpt
