// SPDX-License-Identifier: GPL-2.0-or-later
#include "yamagi/level_lights.h"

#include <algorithm>

namespace vigil::yamagi {

namespace {

constexpr float default_light = 300.0f, brightest_light = 10000.0f;
constexpr float start_light = 300.0f; // over a player
constexpr float over_a_start = 40.0f; // map units

/// Light maps get L - d at the distance d, of 255; where that is L / 2, the ball of radius r lights
/// a white surface as much, 255 being a radiance of 20: r^2 * radiance = 20 / 255 * L / 2 * (L /
/// 2)^2.
float radiance_of(float light) {
    constexpr float white = refresh::particle_radiance / 255.0f;
    const float half = 0.5f * light;
    return white * half * half * half / (level_light_radius * level_light_radius);
}

} // namespace

bool has_own_light(const Bsp& bsp) {
    return std::ranges::any_of(bsp.faces, [&](const BspFace& face) {
        const BspTexInfo& info = bsp.texinfos[face.texinfo];
        return (info.flags & SURF_SKY) != 0 || ((info.flags & SURF_LIGHT) != 0 && info.value > 0);
    });
}

std::vector<LevelLight> entity_lights(const Bsp& bsp) {
    std::vector<LevelLight> lights;
    for (const Entity& entity : bsp.entities) {
        if (entity.classname() != "light") continue;
        const float light = std::min(entity.get_float("light", default_light), brightest_light);
        const glm::vec3 color = glm::max(entity.get_vec3("_color", glm::vec3(1.0f)), 0.0f);
        const float most = std::max({color.x, color.y, color.z});
        if (!(light > 0.0f) || !(most > 0.0f)) continue;
        const int style = std::clamp(entity.get_int("style"), 0, refresh::light_style_count - 1);
        lights.push_back({entity.get_vec3("origin"), radiance_of(light) * color / most, style});
    }
    if (!lights.empty()) return lights;
    for (const Entity& entity : bsp.entities)
        if (entity.classname().starts_with("info_player_"))
            lights.push_back({entity.get_vec3("origin") + glm::vec3(0.0f, 0.0f, over_a_start),
                              glm::vec3(radiance_of(start_light)), 0});
    return lights;
}

} // namespace vigil::yamagi
