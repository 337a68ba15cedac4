// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/scene/light_set.h"

#include "common/log.h"
#include "shared/firewall.h"
#include "shared/triangle_light.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

namespace vigil::vkpt {

namespace {

bool is_finite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// Whether nothing of a light would spread: the GPU adds its radiance to means.
bool is_usable(const shader::Light& light) {
    return is_finite(light.v0) && is_finite(light.e1) && is_finite(light.e2) &&
           shader::is_finite_nonnegative(light.radiance);
}

} // namespace

ModelGeometry dynamic_light_geometry(uint32_t material) {
    ModelGeometry geometry;
    for (uint32_t octant = 0; octant < dynamic_light_triangles; ++octant) {
        const glm::vec3 sign((octant & 1) ? -1.0f : 1.0f, (octant & 2) ? -1.0f : 1.0f,
                             (octant & 4) ? -1.0f : 1.0f);
        const glm::vec3 x(sign.x, 0.0f, 0.0f), y(0.0f, sign.y, 0.0f), z(0.0f, 0.0f, sign.z);
        const bool mirrored = sign.x * sign.y * sign.z < 0.0f;
        const glm::vec3 v1 = mirrored ? z : y, v2 = mirrored ? y : z;
        geometry.add({x, v1, v2, 255}, material);
        geometry.shine(glm::vec3(1.0f));
    }
    return geometry;
}

ModelGeometry spot_geometry(uint32_t lamp_material, uint32_t tube_material) {
    // A corner is 0.495 off the axis, the rim of 12 sides at least 0.966: the whole square is seen
    // up to atan(0.471 / 2.6) = 10 degrees, none of it beyond atan(1.495 / 2.6) = 30.
    constexpr float depth = 2.6f, half = 0.35f, back = 2.7f;
    ModelGeometry geometry;
    const auto corner = [](float y, float z) { return glm::vec3(-depth, y, z); };
    for (const bool upper : {false, true}) {
        const glm::vec3 low = corner(-half, -half), high = corner(half, half);
        geometry.add(
            {low, upper ? high : corner(half, -half), upper ? corner(-half, half) : high, 255},
            lamp_material);
        geometry.shine(glm::vec3(1.0f));
    }
    constexpr int sides = 12;
    const auto rim = [](int side, float x) {
        const float angle = glm::radians(360.0f / sides * static_cast<float>(side));
        return glm::vec3(x, std::cos(angle), std::sin(angle));
    };
    for (int side = 0; side < sides; ++side) {
        const glm::vec3 behind = rim(side, -back), mouth = rim(side + 1, 0.0f);
        geometry.add({behind, rim(side + 1, -back), mouth, 255}, tube_material);
        geometry.add({behind, mouth, rim(side, 0.0f), 255}, tube_material);
    }
    return geometry;
}

LightSet::LightSet(std::vector<LightSource> world_lights, bool has_sun)
    : world_(std::move(world_lights)), lights_(world_.size() + (has_sun ? 1 : 0)),
      went_out_(lights_.size()), has_sun_(has_sun),
      static_count_(static_cast<uint32_t>(lights_.size())) {}

void LightSet::begin_frame(std::span<const float> light_styles, float emissive_scale,
                           const Environment& environment) {
    ++frame_;
    for (auto& [key, slot] : slots_)
        slot.placed = false;
    const bool same =
        scale_ == emissive_scale && environment_.sky_revision == environment.sky_revision &&
        environment_.sky_scale == environment.sky_scale &&
        std::equal(light_styles.begin(), light_styles.end(), styles_.begin(), styles_.end());
    styles_.assign(light_styles.begin(), light_styles.end());
    scale_ = emissive_scale;
    environment_ = environment;
    if (has_sun_) replace(sun(), environment_.sun);
    if (same) return;
    for (uint32_t id = 0; id < world_.size(); ++id)
        write(id, world_[id], glm::mat4x3(1.0f), glm::vec3(1.0f));
}

void LightSet::write(uint32_t id, const LightSource& source, const glm::mat4x3& world_from_object,
                     glm::vec3 tint) {
    const glm::mat3 rotation(world_from_object);
    shader::Light light;
    light.v0 = world_from_object * glm::vec4(source.v0, 1.0f);
    light.e1 = rotation * (source.v1 - source.v0);
    light.e2 = rotation * (source.v2 - source.v0);
    light.flags = source.flags;
    const size_t style = static_cast<size_t>(source.style);
    const float dim = style < styles_.size() ? styles_[style] : 1.0f;
    light.radiance = source.radiance * tint * (source.coverage * dim * scale_);
    if ((source.flags & shader::LIGHT_SKY) != 0)
        light.radiance =
            source.radiance * tint * (source.coverage * environment_.sky_scale) *
            (environment_.sky != nullptr ? environment_.sky->through(-shader::light_normal(light))
                                         : glm::vec3(0.0f));
    replace(id, light);
}

void LightSet::replace(uint32_t id, shader::Light light) {
    if (!is_usable(light)) {
        light = {};
        if (!std::exchange(reported_not_finite_, true))
            log_warning("light {}: its place or its radiance is not finite, or is negative: it "
                        "stays dark, and so do others like it",
                        id);
    }
    shader::Light& old = lights_[id];
    if (std::memcmp(&old, &light, sizeof(light)) == 0) return;
    ++revision_;
    if ((light.flags & shader::LIGHT_SUN) != 0) ++sun_revision_;
    const bool moved = old.v0 != light.v0 || old.e1 != light.e1 || old.e2 != light.e2;
    const bool went_out = old.radiance != glm::vec3(0.0f) && light.radiance == glm::vec3(0.0f);
    const bool went_on = old.radiance == glm::vec3(0.0f) && light.radiance != glm::vec3(0.0f);
    const bool flickers = frame_ - went_out_[id] < flicker_frames;
    if (moved || ((went_on || went_out) && !flickers)) ++place_revision_;
    if (went_on && !flickers) ++new_revision_;
    if (id >= static_count_ && (moved || went_on || went_out)) ++moving_revision_;
    if (went_out) went_out_[id] = frame_;
    old = light;
}

bool LightSet::sun_enters(const shader::Light& window) const {
    if (!has_sun_ || (window.flags & shader::LIGHT_SKY) == 0) return false;
    const shader::Light& light = lights_[sun()];
    return light.radiance != glm::vec3(0.0f) &&
           glm::dot(shader::light_normal(window), shader::light_normal(light)) >
               -environment_.sun_sine - 1e-4f;
}

std::optional<uint32_t> LightSet::place(uint64_t key, std::span<const LightSource> sources,
                                        const glm::mat4x3& world_from_object, glm::vec3 tint) {
    const auto count = static_cast<uint32_t>(sources.size());
    if (count == 0) return 0;
    auto known = slots_.find(key);
    if (known != slots_.end() && known->second.count != count) { // the entity changed its model
        release(known->second);
        slots_.erase(known);
        known = slots_.end();
    }
    if (known == slots_.end()) {
        Slot slot;
        const auto fitting = std::find_if(
            free_.begin(), free_.end(), [&](const Slot& unused) { return unused.count == count; });
        if (fitting != free_.end()) {
            slot = *fitting;
            free_.erase(fitting);
        } else {
            if (lights_.size() - static_count_ + sources.size() > max_moving_lights)
                return std::nullopt;
            slot.first = static_cast<uint32_t>(lights_.size());
            slot.count = count;
            lights_.resize(lights_.size() + count);
            went_out_.resize(lights_.size());
            ++revision_;
        }
        known = slots_.emplace(key, slot).first;
    }
    known->second.placed = true;
    if (!has_moving_sky_ && std::ranges::any_of(sources, [](const LightSource& source) {
            return (source.flags & shader::LIGHT_SKY) != 0;
        })) {
        has_moving_sky_ = true;
        ++sun_revision_;
    }
    for (uint32_t i = 0; i < count; ++i)
        write(known->second.first + i, sources[i], world_from_object, tint);
    return known->second.first;
}

void LightSet::release(const Slot& slot) {
    for (uint32_t i = 0; i < slot.count; ++i) {
        lights_[slot.first + i].radiance = glm::vec3(0.0f);
        went_out_[slot.first + i] = 0; // the next light here is another one
    }
    ++revision_;
    ++place_revision_;
    ++moving_revision_;
    free_.push_back(slot);
}

void LightSet::end_frame() {
    for (auto slot = slots_.begin(); slot != slots_.end();) {
        if (slot->second.placed) {
            ++slot;
            continue;
        }
        release(slot->second);
        slot = slots_.erase(slot);
    }
}

} // namespace vigil::vkpt
