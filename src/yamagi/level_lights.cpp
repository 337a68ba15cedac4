// SPDX-License-Identifier: GPL-2.0-or-later
#include "yamagi/level_lights.h"

#include "common/ascii_case.h"
#include "formats/bsp_query.h"

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

struct ShiningFace {
    glm::vec3 center{0.0f};
    float radius = 0.0f; // from there to its farthest corner
    int32_t cluster = -1;
};

bool shines(const BspTexInfo& info, const MaterialTable& materials) {
    if ((info.flags & SURF_SKY) != 0) return true;
    if ((info.flags & SURF_NODRAW) != 0) return false;
    const auto row = materials.find(ascii_lower(info.texture));
    if (row != materials.end() && row->second.light) return *row->second.light > 0.0f;
    return is_emissive(info);
}

std::vector<ShiningFace> shining_faces(const Bsp& bsp, const MaterialTable& materials) {
    std::vector<ShiningFace> faces;
    for (const BspFace& face : bsp.faces) {
        if (!shines(bsp.texinfos[face.texinfo], materials)) continue;
        const std::vector<glm::vec3> corners = face_polygon(bsp, face);
        if (corners.empty()) continue;
        ShiningFace& shining = faces.emplace_back();
        for (const glm::vec3& corner : corners)
            shining.center += corner / static_cast<float>(corners.size());
        for (const glm::vec3& corner : corners)
            shining.radius = std::max(shining.radius, glm::distance(corner, shining.center));
        shining.cluster = cluster_at(bsp, shining.center + face_normal(bsp, face));
    }
    return faces;
}

/// Classes of lights are `light` and, in levels from Quake, light_flame and others. Mines are
/// models.
bool is_light(std::string_view classname) {
    return classname.starts_with("light") && !classname.starts_with("light_mine");
}

std::vector<LevelLight> all_lights(const Bsp& bsp) {
    std::vector<LevelLight> lights;
    for (const Entity& entity : bsp.entities) {
        if (!is_light(entity.classname())) continue;
        const float light = std::min(entity.get_float("light", default_light), brightest_light);
        const glm::vec3 color = glm::max(entity.get_vec3("_color", glm::vec3(1.0f)), 0.0f);
        const float most = std::max({color.x, color.y, color.z});
        if (!(light > 0.0f) || !(most > 0.0f)) continue;
        const int style = std::clamp(entity.get_int("style"), 0, refresh::light_style_count - 1);
        lights.push_back(
            {entity.get_vec3("origin"), radiance_of(light) * color / most, style, light});
    }
    return lights;
}

} // namespace

std::vector<LevelLight> entity_lights(const Level& level, const MaterialTable& materials,
                                      EntityLights wanted) {
    if (wanted == EntityLights::None) return {};
    const Bsp& bsp = level.bsp;
    const std::vector<ShiningFace> faces = shining_faces(bsp, materials);
    std::vector<LevelLight> lights = all_lights(bsp);
    if (wanted == EntityLights::WhereNothingShines && !faces.empty())
        std::erase_if(lights, [&](const LevelLight& light) {
            const int32_t cluster = cluster_at(bsp, light.origin);
            return std::ranges::any_of(faces, [&](const ShiningFace& face) {
                return glm::distance(light.origin, face.center) - face.radius < light.reach &&
                       level.pvs.visible(cluster, face.cluster);
            });
        });
    if (!lights.empty() || !faces.empty()) return lights;
    for (const Entity& entity : bsp.entities)
        if (entity.classname().starts_with("info_player_"))
            lights.push_back({entity.get_vec3("origin") + glm::vec3(0.0f, 0.0f, over_a_start),
                              glm::vec3(radiance_of(start_light)), 0, start_light});
    return lights;
}

} // namespace vigil::yamagi
