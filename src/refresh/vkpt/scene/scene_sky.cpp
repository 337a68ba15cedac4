// SPDX-License-Identifier: GPL-2.0-or-later
// The sky and the sun of a scene, and the windows through which they are lights.
#include "level/level.h"
#include "refresh/vkpt/scene/scene.h"
#include "refresh/vkpt/scene/sky_windows.h"

#include <algorithm>
#include <cmath>

namespace vigil::vkpt {

namespace {

/// What a level says of its sun by "_sun_angle": two numbers are yaw and pitch of its light, as
/// other compilers have it, one is the angular diameter of its disc, as "_sunlight_penumbra" is.
struct SunAngle {
    float yaw = 0.0f, pitch = -90.0f, degrees = 1.0f;
};

SunAngle sun_angle(const vigil::Entity& world) {
    SunAngle angle;
    angle.degrees = world.get_float("_sunlight_penumbra", angle.degrees);
    if (const auto yaw_pitch = world.get_vec2("_sun_angle"))
        angle.yaw = yaw_pitch->x, angle.pitch = yaw_pitch->y;
    else
        angle.degrees = world.get_float("_sun_angle", angle.degrees);
    angle.degrees = std::clamp(angle.degrees, 0.0f, 180.0f);
    return angle;
}

} // namespace

void Scene::read_sky() {
    const vigil::Entity& world = level_->bsp.worldspawn();
    sky_.name = world.get_string("sky");
    find_sky_pictures();
    const float strength = world.get_float("_sun_light", 0.0f) * radiance_per_light_value;
    sky_.sun_irradiance =
        std::max(strength, 0.0f) * glm::max(world.get_vec3("_sun_color", glm::vec3(1.0f)), 0.0f);
    // "_sun_mangle" is yaw pitch roll; both point where the light goes.
    const SunAngle angle = sun_angle(world);
    sky_.sun_degrees = angle.degrees;
    const glm::vec3 mangle = world.get_vec3("_sun_mangle", glm::vec3(angle.yaw, angle.pitch, 0.0f));
    const glm::vec3 along = rotation_from_angles(glm::vec3(-mangle.y, mangle.x, 0.0f))[0];
    sky_.sun_direction = -glm::normalize(along);
}

void Scene::measure_sky() {
    ++sky_revision_;
    sky_brightness_ = sky_.texture ? SkyBrightness(*textures_, *sky_.texture, sky_.radiance,
                                                   sky_.degrees_per_second != 0.0f)
                                   : SkyBrightness(sky_.radiance);
}

void Scene::cut_windows(Placed& placed) {
    placed.lights.resize(placed.lamps);
    std::vector<shader::BvhTriangle> faces;
    std::vector<uint32_t> slots;
    for (uint32_t slot = placed.first_triangle;
         slot < placed.first_triangle + placed.triangle_count; ++slot) {
        const uint32_t material = primitives_[slot].material;
        if ((materials_->materials()[material].flags & shader::MATERIAL_SKY) == 0) continue;
        faces.push_back(triangles_[slot]);
        slots.push_back(slot);
    }
    if (faces.empty()) return;
    const SkyWindows windows = make_sky_windows(faces, most_sky_lights_);
    const auto first = static_cast<uint32_t>(placed.lamps);
    for (size_t i = 0; i < slots.size(); ++i)
        primitives_[slots[i]].light = windows.first_lights[i] == shader::NONE
                                          ? shader::NONE
                                          : first + windows.first_lights[i];
    placed.lights.insert(placed.lights.end(), windows.lights.begin(), windows.lights.end());
}

void Scene::restart_lights() {
    const std::span<const LightSource> world = lights_of(placed_.front());
    sun_area_ = 0.0f;
    for (const LightSource& light : world) {
        if ((light.flags & shader::LIGHT_SKY) == 0) continue;
        const glm::vec3 twice = glm::cross(light.v1 - light.v0, light.v2 - light.v0);
        sun_area_ += 0.5f * light.coverage * std::max(-glm::dot(twice, sky_.sun_direction), 0.0f);
    }
    const bool has_sun = environment_on_ && sky_.sun_irradiance != glm::vec3(0.0f) &&
                         placed_.front().lights.size() > placed_.front().lamps;
    lights_ = LightSet({world.begin(), world.end()}, has_sun);
    uploaded_light_revision_ = seen_light_revision_ = 0;
}

bool Scene::follow_environment(const refresh::Settings& settings) {
    const bool on = settings.pt_env_nee != 0;
    const auto most = static_cast<uint32_t>(settings.pt_sky_lights);
    if (on == environment_on_ && most == most_sky_lights_) return false;
    environment_on_ = on;
    if (most != most_sky_lights_) {
        most_sky_lights_ = most;
        for (Placed& placed : placed_)
            cut_windows(placed);
        static_dirty_ = true;
    }
    restart_lights();
    return true;
}

Environment Scene::environment(const refresh::Settings& settings) const {
    const Sun sun = sky_.sun(settings);
    // A wide sun shines in where its middle does not.
    const float area = std::max(sun_area_, sun.half_angle > 0.0f ? 1.0f : 0.0f);
    return {&sky_brightness_, sky_revision_, settings.pt_sky_scale, sun_light(sun, area),
            std::sin(sun.half_angle)};
}

void Scene::find_sky_pictures() {
    sky_.texture.reset();
    if (!sky_.name.empty()) sky_.texture = textures_->sky_box(sky_.name);
    // Without pictures: an even grey-blue sky, or the colour the level asks for.
    const glm::vec3 plain =
        level_->bsp.worldspawn().get_vec3("_sky_color", glm::vec3(0.25f, 0.35f, 0.5f));
    sky_.radiance = sky_.texture ? glm::vec3(1.0f) : plain;
    measure_sky();
}

void Scene::set_sky(std::string_view name, float degrees_per_second, const glm::vec3& axis) {
    const bool turned = sky_.degrees_per_second != 0.0f;
    const bool turns = degrees_per_second != 0.0f && glm::length(axis) > 0.0f;
    sky_.degrees_per_second = turns ? degrees_per_second : 0.0f;
    if (turns) sky_.axis = glm::normalize(axis);
    if (name != sky_.name) {
        sky_.name = name;
        find_sky_pictures();
        static_dirty_ = true;
    } else if (turns != turned) {
        measure_sky();
    }
}

} // namespace vigil::vkpt
