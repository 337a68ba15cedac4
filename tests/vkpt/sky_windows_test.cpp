// SPDX-License-Identifier: GPL-2.0-or-later
// Windows to the sky: their coverage adds up to the area of the sky faces, and the arithmetic by
// which shaders find the light that a ray went through (shaders/pathtrace/environment.glsl) gives
// every point of a face one light, which holds it.
#include "refresh/vkpt/scene/sky_windows.h"

#include "shared/triangle_light.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/glm.hpp>
#include <gtest/gtest.h>
#include <limits>
#include <random>

namespace vigil::vkpt {
namespace {

using Triangles = std::vector<shader::BvhTriangle>;

shader::BvhTriangle triangle(glm::vec3 v0, glm::vec3 v1, glm::vec3 v2) {
    return {v0, 255, v1 - v0, v2 - v0};
}

/// A plane in space: a point of it, and two unit vectors whose cross product is its normal.
struct Place {
    glm::vec3 origin, along, across;
    glm::vec3 operator()(float x, float y) const { return origin + x * along + y * across; }
    glm::vec3 normal() const { return glm::cross(along, across); }
};

/// A roof: its lit side looks down.
const Place roof{{0, 0, 192}, {1, 0, 0}, {0, -1, 0}};

Place slanted(float seed) {
    const glm::vec3 normal = glm::normalize(glm::vec3(std::sin(seed), std::cos(2.0f * seed), 0.4f));
    const glm::vec3 along = glm::normalize(glm::cross(normal, glm::vec3(0.3f, 0.2f, 1.0f)));
    return {{400.0f * seed, -300.0f, 100.0f}, along, glm::cross(normal, along)};
}

/// Two triangles.
void add_rectangle(Triangles& faces, const Place& place, float x0, float y0, float x1, float y1) {
    faces.push_back(triangle(place(x0, y0), place(x1, y0), place(x1, y1)));
    faces.push_back(triangle(place(x0, y0), place(x1, y1), place(x0, y1)));
}

Triangles rectangle(const Place& place, float x0, float y0, float x1, float y1) {
    Triangles faces;
    add_rectangle(faces, place, x0, y0, x1, y1);
    return faces;
}

double area(const shader::BvhTriangle& t) {
    return 0.5 * glm::length(glm::cross(glm::dvec3(t.e1), glm::dvec3(t.e2)));
}

double area(const LightSource& light) {
    return 0.5 * glm::length(
                     glm::cross(glm::dvec3(light.v1 - light.v0), glm::dvec3(light.v2 - light.v0)));
}

double face_area(const Triangles& faces) {
    double sum = 0.0;
    for (const shader::BvhTriangle& face : faces)
        sum += area(face);
    return sum;
}

double covered_area(const SkyWindows& windows) {
    double sum = 0.0;
    for (const LightSource& light : windows.lights)
        sum += static_cast<double>(light.coverage) * area(light);
    return sum;
}

shader::Light as_light(const LightSource& source) {
    return {source.v0, source.v1 - source.v0, source.v2 - source.v0, source.radiance, source.flags};
}

glm::uvec2 cells_of(const LightSource& first) {
    return {(first.flags >> shader::LIGHT_COLUMNS_SHIFT) & shader::LIGHT_CELLS_MASK,
            (first.flags >> shader::LIGHT_ROWS_SHIFT) & shader::LIGHT_CELLS_MASK};
}

/// What `sky_light` of shaders/pathtrace/environment.glsl says of a ray that met a face of the
/// window.
uint32_t sky_light(const SkyWindows& windows, uint32_t first, glm::vec3 position,
                   glm::vec3 direction) {
    const LightSource& source = windows.lights.at(first);
    const glm::vec2 at = shader::light_plane_point(as_light(source), position, direction);
    const glm::uvec2 cells = cells_of(source);
    if (!(at.x >= 0.0f && at.y >= 0.0f && at.x < static_cast<float>(cells.x) &&
          at.y < static_cast<float>(cells.y)))
        return shader::NONE;
    const glm::vec2 place = glm::floor(at);
    const uint32_t half = (at.x - place.x) + (at.y - place.y) > 1.0f ? 1 : 0;
    return first + 2 * (static_cast<uint32_t>(place.y) * cells.x + static_cast<uint32_t>(place.x)) +
           half;
}

/// How far outside of a light's triangle a point of its plane lies, in map units; below 0: inside.
double outside(const LightSource& light, glm::dvec3 point) {
    const glm::dvec3 corners[] = {glm::dvec3(light.v0), glm::dvec3(light.v1), glm::dvec3(light.v2)};
    const glm::dvec3 normal =
        glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
    double worst = -std::numeric_limits<double>::infinity();
    for (size_t i = 0; i < 3; ++i) {
        const glm::dvec3 edge = corners[(i + 1) % 3] - corners[i];
        const glm::dvec3 outwards = glm::normalize(glm::cross(edge, normal));
        worst = std::max(worst, glm::dot(outwards, point - corners[i]));
    }
    return worst;
}

/// Points of the faces as seen from anywhere in front of them: each goes through one light, which
/// holds it and is not empty, and which no other light of the window overlaps.
void expect_one_light_each(const Triangles& faces, const SkyWindows& windows,
                           int points_per_face = 50) {
    ASSERT_EQ(windows.first_lights.size(), faces.size());
    std::mt19937 random(7);
    std::uniform_real_distribution<float> unit(0.0f, 1.0f), around(-1.0f, 1.0f);
    for (size_t i = 0; i < faces.size(); ++i) {
        const shader::BvhTriangle& face = faces[i];
        const uint32_t first = windows.first_lights[i];
        if (first == shader::NONE) {
            EXPECT_EQ(area(face), 0.0) << i;
            continue;
        }
        ASSERT_LT(first, windows.lights.size());
        const glm::uvec2 cells = cells_of(windows.lights[first]);
        ASSERT_GE(cells.x, 1u);
        ASSERT_GE(cells.y, 1u);
        const size_t count = size_t{2} * cells.x * cells.y;
        ASSERT_LE(first + count, windows.lights.size());
        const glm::vec3 normal = glm::normalize(glm::cross(face.e1, face.e2));
        const float size = glm::length(face.e1) + glm::length(face.e2);
        for (int n = 0; n < points_per_face; ++n) {
            float a = unit(random), b = unit(random);
            if (a + b > 1.0f) a = 1.0f - a, b = 1.0f - b;
            if (n < 4) { // corners and an edge, too
                a = n == 1 ? 1.0f : n == 3 ? 0.5f : 0.0f;
                b = n == 2 ? 1.0f : n == 3 ? 0.5f : 0.0f;
            }
            const glm::vec3 point = face.v0 + a * face.e1 + b * face.e2;
            const glm::vec3 beside(around(random), around(random), around(random));
            const glm::vec3 position =
                point + size * (beside - glm::dot(beside, normal) * normal + 0.3f * normal) +
                (1.0f + 300.0f * unit(random)) * normal;
            const uint32_t light =
                sky_light(windows, first, position, glm::normalize(point - position));
            // Rounding may take a point of the border out of the window.
            const LightSource edges{face.v0, face.v0 + face.e1, face.v0 + face.e2, {}, 1.0f, 0, 0};
            if (light == shader::NONE && outside(edges, glm::dvec3(point)) > -0.02) continue;
            ASSERT_NE(light, shader::NONE) << "face " << i << " point " << n;
            ASSERT_LT(light, first + count);
            // A thousandth of a unit for rounding, at coordinates of some thousands.
            EXPECT_LT(outside(windows.lights[light], glm::dvec3(point)), 0.02)
                << "face " << i << " point " << n;
            size_t holders = 0;
            for (size_t other = first; other < first + count; ++other)
                holders += outside(windows.lights[other], glm::dvec3(point)) < -0.02 ? 1 : 0;
            EXPECT_LE(holders, 1u) << "lights overlap";
            // A face that only touches a cell at its border may leave it empty.
            if (outside(windows.lights[light], glm::dvec3(point)) < -0.02 && n >= 4) {
                EXPECT_GT(windows.lights[light].coverage, 0.0f) << "face " << i << " point " << n;
            }
        }
    }
}

/// Whether lights face where faces do, are all of the sky, and tell their cells in the first alone.
void expect_well_formed(const Triangles& faces, const SkyWindows& windows) {
    for (size_t i = 0; i < faces.size(); ++i) {
        if (windows.first_lights[i] == shader::NONE) continue;
        const glm::vec3 normal = glm::normalize(glm::cross(faces[i].e1, faces[i].e2));
        const LightSource& light = windows.lights[windows.first_lights[i]];
        EXPECT_GT(glm::dot(normal, shader::light_normal(as_light(light))), 0.999f) << i;
    }
    for (size_t id = 0; id < windows.lights.size();) {
        const glm::uvec2 cells = cells_of(windows.lights[id]);
        ASSERT_GE(cells.x * cells.y, 1u) << "light " << id << " begins no window";
        const size_t count = size_t{2} * cells.x * cells.y;
        ASSERT_LE(id + count, windows.lights.size());
        const glm::vec3 normal = shader::light_normal(as_light(windows.lights[id]));
        for (size_t i = id; i < id + count; ++i) {
            const LightSource& light = windows.lights[i];
            EXPECT_EQ(light.flags & 0xffu & ~shader::LIGHT_WHOLE, shader::LIGHT_SKY);
            if (i > id) {
                EXPECT_EQ(light.flags & ~shader::LIGHT_WHOLE, shader::LIGHT_SKY);
            }
            EXPECT_GE(light.coverage, 0.0f);
            EXPECT_LE(light.coverage, 1.0f);
            EXPECT_EQ(light.radiance, glm::vec3(1.0f));
            EXPECT_GT(glm::dot(normal, shader::light_normal(as_light(light))), 0.9999f);
            // All cells of a window are of one size.
            EXPECT_NEAR(area(light), area(windows.lights[id]), 1e-3 * area(windows.lights[id]));
        }
        id += count;
    }
}

/// Lights that say so are covered: each point of them by a face in their plane, which is of their
/// window, as are all that hold it.
void expect_whole_is_whole(const Triangles& faces, const SkyWindows& windows) {
    std::mt19937 random(9);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    uint32_t first = 0;
    for (uint32_t id = 0; id < windows.lights.size(); ++id) {
        const LightSource& light = windows.lights[id];
        if (cells_of(light).x > 0) first = id;
        if ((light.flags & shader::LIGHT_WHOLE) == 0) continue;
        EXPECT_GT(light.coverage, 0.9999f) << id;
        const int points = faces.size() > 100 ? 4 : 100;
        for (int n = 0; n < points; ++n) {
            double a = unit(random), b = unit(random);
            if (a + b > 1.0) a = 1.0 - a, b = 1.0 - b;
            const glm::dvec3 v0(light.v0);
            const glm::dvec3 point =
                v0 + a * (glm::dvec3(light.v1) - v0) + b * (glm::dvec3(light.v2) - v0);
            size_t holders = 0;
            for (size_t i = 0; i < faces.size(); ++i) {
                const shader::BvhTriangle& face = faces[i];
                if (!(area(face) > 0.0)) continue;
                const glm::dvec3 normal =
                    glm::normalize(glm::cross(glm::dvec3(face.e1), glm::dvec3(face.e2)));
                const double height = glm::dot(normal, point - glm::dvec3(face.v0));
                const LightSource edges{face.v0, face.v0 + face.e1, face.v0 + face.e2, {}, 1.0f, 0,
                                        0};
                if (std::abs(height) > 0.3 || outside(edges, point) > 0.01) continue;
                if (glm::dot(normal, glm::dvec3(shader::light_normal(as_light(light)))) < 0.9)
                    continue;
                if (std::abs(height) > 0.005 && outside(edges, point) > -0.01)
                    continue; // beside it
                ++holders;
                EXPECT_LT(std::abs(height), 0.005) << "light " << id << " face " << i;
                if (outside(edges, point) < -0.01) {
                    EXPECT_EQ(windows.first_lights[i], first) << "light " << id << " face " << i;
                }
            }
            ASSERT_GT(holders, 0u) << "light " << id;
        }
    }
}

size_t whole_count(const SkyWindows& windows) {
    return static_cast<size_t>(std::ranges::count_if(windows.lights, [](const LightSource& light) {
        return (light.flags & shader::LIGHT_WHOLE) != 0;
    }));
}

size_t window_count(const SkyWindows& windows) {
    size_t count = 0;
    for (const LightSource& light : windows.lights)
        count += cells_of(light).x > 0 ? 1 : 0;
    return count;
}

SkyWindows expect_sound(const Triangles& faces, uint32_t most, int points_per_face = 50) {
    SkyWindows windows = make_sky_windows(faces, most);
    expect_well_formed(faces, windows);
    expect_one_light_each(faces, windows, points_per_face);
    expect_whole_is_whole(faces, windows);
    EXPECT_LE(windows.lights.size(), std::max(size_t{most}, 2 * window_count(windows)));
    return windows;
}

TEST(SkyWindows, OneRectangleIsOneWindowWhoseCoverageIsItsArea) {
    const Triangles faces = rectangle(roof, -256, -256, 256, 256);
    for (const uint32_t most : {2u, 3u, 8u, 64u, 1000u}) {
        SCOPED_TRACE(most);
        const SkyWindows windows = expect_sound(faces, most);
        EXPECT_EQ(window_count(windows), 1u);
        EXPECT_LE(windows.lights.size(), most);
        EXPECT_GE(windows.lights.size(), most / 3) << "the budget is there to be used";
        EXPECT_NEAR(covered_area(windows), 512.0 * 512.0, 1e-4 * 512.0 * 512.0);
        for (const LightSource& light : windows.lights)
            EXPECT_GT(light.coverage, 0.9999f);
        EXPECT_EQ(whole_count(windows), windows.lights.size());
    }
}

TEST(SkyWindows, TurnedPlanesKeepAreaAndSide) {
    for (const float seed : {0.1f, 0.7f, 1.3f, 2.9f, -1.0f}) {
        SCOPED_TRACE(seed);
        const Place place = slanted(seed);
        Triangles faces = rectangle(place, -64, -48, 200, 80);
        faces.push_back(triangle(place(200, -48), place(320, -20), place(200, 80)));
        const SkyWindows windows = expect_sound(faces, 64);
        EXPECT_EQ(window_count(windows), 1u);
        EXPECT_NEAR(covered_area(windows), face_area(faces), 1e-3 * face_area(faces));
        for (const LightSource& light : windows.lights)
            EXPECT_GT(glm::dot(shader::light_normal(as_light(light)), place.normal()), 0.9999f);
    }
}

TEST(SkyWindows, BothSidesOfAPlaneAreWindowsOfTheirOwn) {
    Triangles faces = rectangle(roof, 0, 0, 100, 100);
    const Place above{roof.origin, roof.along, -roof.across};
    add_rectangle(faces, above, 0, 0, 100, 100); // its lit side looks up
    const SkyWindows windows = expect_sound(faces, 16);
    EXPECT_EQ(window_count(windows), 2u);
    EXPECT_NE(windows.first_lights[0], windows.first_lights[2]);
    EXPECT_NEAR(covered_area(windows), 20000.0, 10.0);
}

TEST(SkyWindows, FacesApartInAPlaneAreWindowsOfTheirOwn) {
    Triangles faces = rectangle(roof, 0, 0, 100, 60);
    add_rectangle(faces, roof, 300, 0, 350, 40);
    add_rectangle(faces, roof, 0, 500, 20, 900);
    const SkyWindows windows = expect_sound(faces, 64);
    EXPECT_EQ(window_count(windows), 3u);
    EXPECT_NEAR(covered_area(windows), face_area(faces), 1e-3 * face_area(faces));
    // Those that touch, or nearly do, share one.
    Triangles near = rectangle(roof, 0, 0, 100, 60);
    add_rectangle(near, roof, 100.5f, 0, 200, 60);
    EXPECT_EQ(window_count(expect_sound(near, 64)), 1u);
}

TEST(SkyWindows, HeightsApartAreWindowsOfTheirOwn) {
    Triangles faces;
    for (int storey = 0; storey < 5; ++storey) {
        Place place = roof;
        place.origin.z += 16.0f * static_cast<float>(storey);
        add_rectangle(faces, place, 0, 0, 100, 100);
    }
    const SkyWindows windows = expect_sound(faces, 40);
    EXPECT_EQ(window_count(windows), 5u);
    EXPECT_LE(windows.lights.size(), 40u);
    EXPECT_NEAR(covered_area(windows), 50000.0, 50.0);
}

TEST(SkyWindows, CoverageOfAHalfFilledWindow) {
    // A triangle fills half of its rectangle: one half of a single cell is sky, the other is not.
    const Triangles faces{triangle(roof(0, 0), roof(160, 0), roof(0, 120))};
    const SkyWindows windows = expect_sound(faces, 64, 500);
    EXPECT_NEAR(covered_area(windows), 9600.0, 1e-3 * 9600.0);
    EXPECT_EQ(std::ranges::min(windows.lights, {}, &LightSource::coverage).coverage, 0.0f);
    EXPECT_GT(std::ranges::max(windows.lights, {}, &LightSource::coverage).coverage, 0.99f);
}

TEST(SkyWindows, LShapesAreCutWhereTheyFillLittle) {
    // Arms of 20 by 400: the rectangle around both would be sky by a tenth.
    Triangles faces = rectangle(roof, 0, 0, 400, 20);
    add_rectangle(faces, roof, 0, 20, 20, 400);
    for (const uint32_t most : {2u, 16u, 256u}) {
        const SkyWindows windows = expect_sound(faces, most, 300);
        EXPECT_GE(window_count(windows), 2u);
        EXPECT_NEAR(covered_area(windows), face_area(faces), 1e-3 * face_area(faces)) << most;
        double whole = 0.0;
        for (const LightSource& light : windows.lights)
            whole += area(light);
        // Each arm is two triangles, which may get a window each.
        EXPECT_LT(whole, 2.2 * face_area(faces)) << "windows are mostly sky";
    }
    // A thick one keeps a single window.
    Triangles thick = rectangle(roof, 0, 0, 400, 300);
    add_rectangle(thick, roof, 0, 300, 300, 400);
    const SkyWindows windows = expect_sound(thick, 64, 300);
    EXPECT_EQ(window_count(windows), 1u);
    EXPECT_NEAR(covered_area(windows), face_area(thick), 1e-3 * face_area(thick));
}

TEST(SkyWindows, FacesThatMeetInTJunctions) {
    // One long face beside three short ones, whose corners lie on its edge.
    Triangles faces = rectangle(roof, 0, 0, 300, 100);
    for (int i = 0; i < 3; ++i)
        add_rectangle(faces, roof, 100.0f * static_cast<float>(i), 100,
                      100.0f * static_cast<float>(i + 1), 180);
    const SkyWindows windows = expect_sound(faces, 64, 300);
    EXPECT_EQ(window_count(windows), 1u);
    EXPECT_NEAR(covered_area(windows), 300.0 * 180.0, 1e-3 * 300.0 * 180.0);
}

TEST(SkyWindows, OverlappingFacesCoverNoMoreThanAll) {
    Triangles faces = rectangle(roof, 0, 0, 200, 100);
    add_rectangle(faces, roof, 0, 0, 200, 100); // twice the same
    const SkyWindows windows = expect_sound(faces, 32);
    EXPECT_EQ(window_count(windows), 1u);
    EXPECT_NEAR(covered_area(windows), 20000.0, 100.0);
    Triangles partly = rectangle(roof, 0, 0, 200, 100);
    add_rectangle(partly, roof, 100, 50, 300, 150);
    const SkyWindows both = expect_sound(partly, 64, 300);
    EXPECT_GT(covered_area(both), 0.999 * 35000.0) << "no part of them is left out";
    EXPECT_LE(covered_area(both), 1.001 * face_area(partly));
}

TEST(SkyWindows, FacesThatLieOnEachOtherDoNotMakeUpForGaps) {
    // Their areas add up to that of the window, and a third of it is none of theirs.
    Triangles faces;
    for (int i = 0; i < 3; ++i)
        add_rectangle(faces, roof, 0, 0, 50, 100);
    add_rectangle(faces, roof, 90, 0, 100, 100);
    add_rectangle(faces, roof, 50, 0, 90, 2); // so that they lie together
    for (const uint32_t most : {2u, 8u, 64u}) {
        const SkyWindows windows = expect_sound(faces, most, 300);
        EXPECT_LT(whole_count(windows), windows.lights.size()) << most;
    }
}

TEST(SkyWindows, FacesALittleBesideThePlaneAreNotWhole) {
    // A ray that ends in front of the plane would stop at the lower one.
    Place lower = roof;
    lower.origin.z -= 0.05f;
    Triangles faces = rectangle(roof, 0, 0, 100, 100);
    add_rectangle(faces, lower, 100, 0, 200, 100);
    const SkyWindows windows = expect_sound(faces, 64, 100);
    EXPECT_EQ(window_count(windows), 1u);
    EXPECT_GT(whole_count(windows), 10u);
    EXPECT_LT(whole_count(windows), 40u) << "half of them";
}

TEST(SkyWindows, AThousandSmallFaces) {
    Triangles together, apart;
    for (int i = 0; i < 500; ++i) {
        const auto x = static_cast<float>(i % 25), y = static_cast<float>(i / 25);
        add_rectangle(together, roof, 16 * x, 16 * y, 16 * x + 16, 16 * y + 16);
        add_rectangle(apart, roof, 32 * x, 32 * y, 32 * x + 16, 32 * y + 16);
    }
    const SkyWindows one = expect_sound(together, 64, 10);
    EXPECT_EQ(window_count(one), 1u);
    EXPECT_LE(one.lights.size(), 64u);
    EXPECT_NEAR(covered_area(one), face_area(together), 1e-3 * face_area(together));
    // More windows than lights allowed: a cell for each.
    const SkyWindows many = expect_sound(apart, 64, 10);
    EXPECT_EQ(window_count(many), 500u);
    EXPECT_EQ(many.lights.size(), 1000u);
    EXPECT_NEAR(covered_area(many), face_area(apart), 1e-3 * face_area(apart));
}

TEST(SkyWindows, FacesWithoutAreaHaveNoLight) {
    Triangles faces{triangle(roof(0, 0), roof(10, 0), roof(20, 0)), // on a line
                    triangle(roof(5, 5), roof(5, 5), roof(5, 5))};  // a point
    const SkyWindows none = make_sky_windows(faces, 64);
    EXPECT_TRUE(none.lights.empty());
    EXPECT_EQ(none.first_lights, std::vector<uint32_t>(2, shader::NONE));
    add_rectangle(faces, roof, 0, 0, 64, 64);
    const SkyWindows windows = expect_sound(faces, 64);
    EXPECT_EQ(windows.first_lights[0], shader::NONE);
    EXPECT_EQ(windows.first_lights[1], shader::NONE);
    EXPECT_EQ(windows.first_lights[2], 0u);
    EXPECT_TRUE(make_sky_windows({}, 64).lights.empty());
}

TEST(SkyWindows, FacesThatAreNotFiniteHaveNoLight) {
    Triangles faces = rectangle(roof, 0, 0, 64, 64);
    faces.push_back({glm::vec3(0.0f), 255, glm::vec3(std::numeric_limits<float>::infinity()),
                     glm::vec3(0, 1, 0)});
    faces.push_back({glm::vec3(0.0f), 255, glm::vec3(std::numeric_limits<float>::quiet_NaN()),
                     glm::vec3(0, 1, 0)});
    const SkyWindows windows = make_sky_windows(faces, 16);
    EXPECT_EQ(windows.first_lights[2], shader::NONE);
    EXPECT_EQ(windows.first_lights[3], shader::NONE);
    for (const LightSource& light : windows.lights)
        EXPECT_TRUE(std::isfinite(light.coverage) && std::isfinite(glm::dot(light.v0, light.v1)));
}

TEST(SkyWindows, NeedlesAndSpecksKeepTheirArea) {
    for (const float width : {0.01f, 0.1f, 1.0f}) {
        const Triangles needle = rectangle(roof, 0, 0, 2000, width);
        const SkyWindows windows = expect_sound(needle, 64);
        EXPECT_NEAR(covered_area(windows), face_area(needle), 0.02 * face_area(needle)) << width;
    }
    const Triangles speck = rectangle(roof, 0, 0, 0.05f, 0.05f);
    EXPECT_NEAR(covered_area(expect_sound(speck, 64)), face_area(speck), 0.02 * face_area(speck));
}

TEST(SkyWindows, FarFromTheOriginToo) {
    Place far = roof;
    far.origin = {32000, -32000, 32000};
    const Triangles faces = rectangle(far, -256, -256, 256, 256);
    const SkyWindows windows = expect_sound(faces, 64, 500);
    EXPECT_NEAR(covered_area(windows), face_area(faces), 1e-3 * face_area(faces));
}

TEST(SkyWindows, BudgetIsSharedByArea) {
    Triangles faces = rectangle(roof, 0, 0, 400, 400);
    Place other = roof;
    other.origin.z += 100.0f;
    add_rectangle(faces, other, 0, 0, 100, 100);
    const SkyWindows windows = expect_sound(faces, 100);
    ASSERT_EQ(window_count(windows), 2u);
    const uint32_t second = windows.first_lights[2];
    ASSERT_GT(second, 0u);
    const double of_large = second, of_small = static_cast<double>(windows.lights.size()) - second;
    EXPECT_GT(of_large, 5.0 * of_small) << "sixteen times the area";
}

} // namespace
} // namespace vigil::vkpt
