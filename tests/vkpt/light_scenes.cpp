// SPDX-License-Identifier: GPL-2.0-or-later
#include "light_scenes.h"

#include <algorithm>
#include <random>

namespace vigil::test {

namespace {

/// A switched style, as Quake II's compilers give them out from 32 on.
constexpr uint8_t dark_style = 33;

struct Triangle {
    glm::vec3 v0, v1, v2; // counter-clockwise as seen from the lit side
    uint8_t style = 0;
};

/// Hangs triangles of light into the level, in turn red, green and blue: a colour that is off
/// points to its lights.
void hang(Level& level, const std::vector<Triangle>& triangles, int value) {
    Bsp& bsp = level.bsp;
    const auto first_info = static_cast<uint32_t>(bsp.texinfos.size());
    for (const char* texture : {"test/lamp_red", "test/lamp_green", "test/blue"}) {
        BspTexInfo info;
        info.s = {1, 0, 0, 0};
        info.t = {0, 1, 0, 0};
        info.flags = SURF_LIGHT;
        info.value = value;
        info.texture = texture;
        bsp.texinfos.push_back(info);
    }
    for (const Triangle& triangle : triangles) {
        const glm::vec3 across = glm::cross(triangle.v1 - triangle.v0, triangle.v2 - triangle.v0);
        const glm::vec3 normal =
            glm::length(across) > 0.0f ? glm::normalize(across) : glm::vec3(0, 0, -1);
        BspFace face;
        face.plane = static_cast<uint32_t>(bsp.planes.size());
        bsp.planes.push_back({normal, glm::dot(normal, triangle.v0), 3});
        face.first_edge = static_cast<uint32_t>(bsp.surf_edges.size());
        face.edge_count = 3;
        face.texinfo = first_info + static_cast<uint32_t>(bsp.faces.size() % 3);
        face.styles = {triangle.style, 255, 255, 255};
        // The file walks a face clockwise.
        const auto corner = static_cast<uint32_t>(bsp.vertices.size());
        bsp.vertices.insert(bsp.vertices.end(), {triangle.v0, triangle.v2, triangle.v1});
        for (uint32_t i = 0; i < 3; ++i) {
            bsp.surf_edges.push_back(static_cast<int32_t>(bsp.edges.size()));
            bsp.edges.push_back({corner + i, corner + (i + 1) % 3});
        }
        bsp.faces.push_back(face);
    }
    bsp.models[0].face_count += static_cast<uint32_t>(triangles.size());
}

/// Puts out the lamps that the level came with.
void put_out(Level& level) {
    for (BspTexInfo& info : level.bsp.texinfos)
        info.value = 0;
}

/// Triangles of the given size in a box, turned anyhow.
std::vector<Triangle> scattered(int count, float size, glm::vec3 low, glm::vec3 high,
                                uint32_t seed) {
    std::mt19937 random(seed);
    const auto between = [&](float a, float b) {
        return std::uniform_real_distribution<float>(a, b)(random);
    };
    std::vector<Triangle> triangles;
    while (triangles.size() < static_cast<size_t>(count)) {
        const auto direction = [&] {
            return glm::vec3(between(-1, 1), between(-1, 1), between(-1, 1));
        };
        const glm::vec3 at(between(low.x, high.x), between(low.y, high.y), between(low.z, high.z));
        const glm::vec3 e1 = size * direction(), e2 = size * direction();
        if (glm::length(glm::cross(e1, e2)) < 0.05f * size * size) continue; // too thin to matter
        triangles.push_back({at, at + e1, at + e2});
    }
    return triangles;
}

/// The hall of the level `lamp`, its lamp put out, seen from the side: a floor at z = 0.
LightScene hall(std::string name, std::vector<Triangle> triangles, int value) {
    LightScene scene;
    scene.name = std::move(name);
    scene.level = "lamp";
    scene.edit = [triangles = std::move(triangles), value](Level& level) {
        put_out(level);
        hang(level, triangles, value);
    };
    scene.shot.view = {{-192, 0, 64}, {50, 0, 0}, 60};
    return scene;
}

constexpr glm::vec3 under_the_roof_low(-200, -200, 90), under_the_roof_high(200, 200, 240);

LightScene one_light() {
    return hall("OneLight", {{{-150, -20, 100}, {-110, 30, 90}, {-90, -30, 110}}}, 200);
}

LightScene no_light() {
    LightScene scene = hall("NoLight", {}, 0);
    scene.dark = true;
    return scene;
}

LightScene behind_the_surface() {
    // Below the floor and turned to it, in no cluster, so in everybody's list; and above it, but
    // turned away.
    std::vector<Triangle> triangles = scattered(20, 12, {-200, -200, -60}, {0, 200, -20}, 1);
    for (Triangle& triangle : triangles) {
        if (glm::cross(triangle.v1 - triangle.v0, triangle.v2 - triangle.v0).z < 0.0f)
            std::swap(triangle.v1, triangle.v2);
        if (triangle.v0.y < 0.0f) continue;
        const float height = triangle.v0.z + 160.0f;
        for (glm::vec3* corner : {&triangle.v0, &triangle.v1, &triangle.v2})
            corner->z = height;
    }
    LightScene scene = hall("BehindTheSurface", triangles, 200);
    scene.dark = true;
    return scene;
}

LightScene ten_thousand() {
    LightScene scene =
        hall("TenThousand", scattered(10000, 3, under_the_roof_low, under_the_roof_high, 2), 50);
    scene.size = {8, 8};
    scene.bounds = {0.15, 0.15, 0.4}; // most draws are of lights that matter little
    return scene;
}

LightScene half_of_them_black() {
    std::vector<Triangle> triangles =
        scattered(120, 12, under_the_roof_low, under_the_roof_high, 3);
    for (size_t i = 0; i < triangles.size(); i += 2)
        triangles[i].style = dark_style;
    LightScene scene = hall("HalfOfThemBlack", triangles, 100);
    scene.shot.dark_styles = {dark_style};
    scene.bounds = {0.1, 0.15, 0.4};
    return scene;
}

LightScene in_the_plane() {
    std::vector<Triangle> triangles = scattered(40, 12, {-180, -150, 0}, {100, 150, 0}, 4);
    for (Triangle& triangle : triangles) {
        for (glm::vec3* corner : {&triangle.v1, &triangle.v2})
            corner->z = 0.0f;
        if (glm::cross(triangle.v1 - triangle.v0, triangle.v2 - triangle.v0).z < 0.0f)
            std::swap(triangle.v1, triangle.v2);
    }
    // And some that do shine on it, so that there is something to get wrong.
    for (const Triangle& triangle : scattered(8, 24, under_the_roof_low, under_the_roof_high, 5))
        triangles.push_back(triangle);
    return hall("InThePlane", triangles, 100);
}

LightScene rooms() {
    LightScene scene;
    scene.name = "RoomsWithManyLamps";
    scene.level = "rooms";
    scene.shot.view = {{290, 20, 96}, {5, 55, 0}, 90};
    return scene;
}

LightScene moving() {
    LightScene scene;
    scene.name = "MovingAndDynamic";
    scene.level = "rooms";
    scene.shot.view = {{40, 40, 60}, {0, 35, 0}, 90};
    refresh::Entity door;
    door.number = 1;
    door.origin = {-40, -20, 20};
    scene.shot.entities = {door};
    scene.door = true;
    scene.shot.dynamic_lights = {{7, {120, 120, 40}, 16.0f, {20, 10, 5}},
                                 {8, {200, 60, 100}, 2.0f, {5, 20, 40}}};
    return scene;
}

LightScene many_brightnesses() {
    LightScene scene =
        hall("ManyBrightnesses", scattered(16, 12, under_the_roof_low, under_the_roof_high, 11), 1);
    float radiance = 1e-12f;
    for (uint32_t id = 0; id < 9; ++id, radiance *= 1000.0f) {
        const glm::vec3 at(-160.0f + 40.0f * static_cast<float>(id), 30.0f, 150.0f);
        scene.shot.dynamic_lights.push_back({100 + id, at, 6.0f, glm::vec3(radiance)});
    }
    scene.spread = false; // the brightest is all that is drawn
    scene.extreme = "radiance from 1e-12 to 1e12 in one room";
    return scene;
}

LightScene needles_and_specks() {
    std::vector<Triangle> triangles =
        scattered(24, 1e-4f, under_the_roof_low, under_the_roof_high, 12);
    for (Triangle triangle : scattered(24, 20, under_the_roof_low, under_the_roof_high, 13)) {
        // A needle of 20 by a thousandth of a unit, and the same without any width.
        const glm::vec3 along = triangle.v1 - triangle.v0, across = triangle.v2 - triangle.v0;
        triangle.v2 = triangle.v0 + 0.5f * along + 5e-5f * across;
        triangles.push_back(triangle);
        triangle.v2 = triangle.v0 + 0.5f * along;
        triangles.push_back(triangle);
    }
    for (const Triangle& triangle : scattered(8, 24, under_the_roof_low, under_the_roof_high, 14))
        triangles.push_back(triangle);
    LightScene scene = hall("NeedlesAndSpecks", triangles, 100);
    scene.spread = false;
    scene.extreme = "areas of 1e-8, needles of 20 by 0.001 units, no width at all, beside lamps";
    return scene;
}

LightScene through_the_floor() {
    // Upright, standing on the floor, and reaching through it by a third.
    std::vector<Triangle> triangles;
    for (int i = 0; i < 24; ++i) {
        const float x = -140.0f + 10.0f * static_cast<float>(i), low = i % 2 == 0 ? 0.0f : -6.0f;
        const float y = 8.0f * static_cast<float>(i % 5) - 16.0f;
        triangles.push_back({{x, y - 8, low}, {x, y, low + 18.0f}, {x, y + 8, low}});
    }
    LightScene scene = hall("ThroughTheFloor", triangles, 100);
    scene.bounds = {0.1, 0.15, 0.4};
    scene.extreme = "lamps that touch the surface and cross its horizon";
    return scene;
}

LightScene behind_the_roof() {
    // Above the roof, turned to the floor: all of them might shine, and none does.
    std::vector<Triangle> triangles = scattered(40, 30, {-150, -150, 600}, {150, 150, 700}, 15);
    for (Triangle& triangle : triangles)
        if (glm::cross(triangle.v1 - triangle.v0, triangle.v2 - triangle.v0).z > 0.0f)
            std::swap(triangle.v1, triangle.v2);
    LightScene scene = hall("BehindTheRoof", triangles, 200);
    scene.dark = true;
    scene.extreme = "every light hidden";
    return scene;
}

LightScene all_black() {
    std::vector<Triangle> triangles =
        scattered(40, 12, under_the_roof_low, under_the_roof_high, 16);
    for (Triangle& triangle : triangles)
        triangle.style = dark_style;
    LightScene scene = hall("AllBlack", triangles, 100);
    scene.shot.dark_styles = {dark_style};
    scene.dark = true;
    scene.extreme = "every light black";
    return scene;
}

LightScene far_away() {
    LightScene scene =
        hall("FarAway", scattered(24, 12, under_the_roof_low, under_the_roof_high, 17), 100);
    // The farthest corner: all of the level lies within the coordinates of the format.
    const glm::vec3 by(32000.0f, -32000.0f, 32000.0f);
    scene.edit = [before = scene.edit, by](Level& level) {
        before(level);
        Bsp& bsp = level.bsp;
        for (glm::vec3& vertex : bsp.vertices)
            vertex += by;
        for (BspPlane& plane : bsp.planes)
            plane.dist += glm::dot(plane.normal, by);
        const auto move = [&](auto& boxed) {
            boxed.mins += by;
            boxed.maxs += by;
        };
        std::ranges::for_each(bsp.nodes, move);
        std::ranges::for_each(bsp.leafs, move);
        std::ranges::for_each(bsp.models, move);
    };
    scene.shot.view.origin += by;
    scene.extreme = "a room at coordinates of 32,000";
    return scene;
}

using Entries = std::vector<std::pair<const char*, const char*>>;

/// The court of the level `opensky` with these entries in its worldspawn: walls, floor and what
/// stands there.
LightScene court(std::string name, const Entries& entries) {
    LightScene scene;
    scene.name = std::move(name);
    scene.level = "opensky";
    scene.edit = [entries](Level& level) {
        for (const auto& [key, value] : entries)
            level.bsp.entities[0].set(key, value);
    };
    scene.shot.view = {{-192, -64, 56}, {10, 20, 0}, 90};
    scene.size = {16, 12}; // there are many of them
    scene.effort = 2;
    scene.bounds = {0.1, 0.2, 0.6};
    return scene;
}

/// A lamp of three colours in the court. It is none that moves: with one, each technique's shaders
/// would be compiled once more.
void add_lamp(LightScene& scene, int value) {
    scene.edit = [before = scene.edit, value](Level& level) {
        before(level);
        const glm::vec3 a(-76, 30, 60), b(-44, 30, 60), c(-60, 58, 60), top(-60, 40, 84);
        hang(level, {{a, c, b}, {a, b, top}, {c, a, top}}, value);
    };
}

LightScene sky_and_sun() {
    LightScene scene = court("SkyAndSun", {});
    scene.size = {24, 16};
    scene.shot.dynamic_lights = {{7, {-60, 40, 60}, 16.0f, {10, 10, 30}}};
    return scene;
}

LightScene black_sky_and_point_sun() {
    LightScene scene =
        court("BlackSkyAndPointSun", {{"sky", ""}, {"_sky_color", "0 0 0"}, {"_sun_angle", "0"}});
    add_lamp(scene,
             1000); // so bright that it is drawn everywhere: what is never drawn shows no noise
    scene.extreme = "a sun of angle 0 in a black sky, beside a lamp";
    scene.spread = false; // it is most of the light
    return scene;
}

LightScene sun_of_180_degrees() {
    LightScene scene = court("SunOf180Degrees", {{"_sun_angle", "180"}});
    scene.effort = 4; // most of its directions are behind walls, and most draws are of it
    scene.extreme = "a sun of 180 degrees";
    return scene;
}

LightScene sun_below_the_horizon() {
    LightScene scene = court("SunBelowTheHorizon", {{"_sun_mangle", "40 55 0"}});
    scene.extreme = "a sun below the horizon";
    return scene;
}

LightScene sun_behind_walls() {
    // One degree above the horizon: it shines upon the upper rim of the walls alone.
    LightScene scene = court("SunBehindWalls", {{"_sun_mangle", "40 -1 0"}});
    scene.extreme = "a sun behind walls";
    return scene;
}

LightScene black_sky() {
    LightScene scene =
        court("BlackSky", {{"sky", ""}, {"_sky_color", "0 0 0"}, {"_sun_light", "0"}});
    scene.dark = true;
    scene.extreme = "a black sky without a sun";
    return scene;
}

LightScene turning_sky() {
    // With a sun, weak as it is, it needs no shaders of its own.
    LightScene scene = court("TurningSky", {{"_sun_light", "1"}});
    scene.sky_turns = {20.0f, 0.6f, 0.0f, 0.8f};
    scene.shot.time_s = 3.0;
    scene.extreme = "a sky that rotates";
    return scene;
}

} // namespace

std::vector<LightScene> extreme_light_scenes() {
    return {
        many_brightnesses(), needles_and_specks(), through_the_floor(),  behind_the_roof(),
        all_black(),         far_away(),           sun_of_180_degrees(), sun_below_the_horizon(),
        sun_behind_walls(),  black_sky(),          turning_sky(),        black_sky_and_point_sun()};
}

std::vector<LightScene> light_scenes() {
    return {one_light(),
            no_light(),
            behind_the_surface(),
            ten_thousand(),
            half_of_them_black(),
            in_the_plane(),
            rooms(),
            moving(),
            sky_and_sun()};
}

void hang_scattered(Level& level, int count, float size, int value) {
    hang(level, scattered(count, size, under_the_roof_low, under_the_roof_high, 18), value);
}

} // namespace vigil::test
