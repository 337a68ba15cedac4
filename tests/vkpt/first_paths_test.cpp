// SPDX-License-Identifier: GPL-2.0-or-later
// Paths that the host traces, in a room of a cube with solid walls, or a sky as its ceiling.
#include "refresh/vkpt/pathtrace/first_paths.h"

#include "formats/bsp.h"
#include "refresh/vkpt/frame_params.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace vigil::vkpt {
namespace {

using glm::vec3;

constexpr float half_size = 100.0f;

/// From -100 to 100 in all axes. Node i has wall i behind it, whose leaf is i + 1; leaf 0 is the
/// air.
Bsp room(bool sky) {
    Bsp bsp;
    bsp.leafs.resize(7);
    bsp.leafs[0].cluster = 0;
    for (int wall = 0; wall < 6; ++wall) {
        const int axis = wall / 2;
        vec3 inwards(0.0f);
        inwards[axis] = wall % 2 == 0 ? 2.0f : -2.0f; // of any length
        BspPlane plane;
        plane.normal = inwards;
        plane.dist = -2.0f * half_size;
        bsp.planes.push_back(plane);
        BspNode node;
        node.plane = static_cast<uint32_t>(wall);
        node.children = {wall < 5 ? wall + 1 : -1 - 0, -1 - (wall + 1)};
        bsp.nodes.push_back(node);
        bsp.leafs[static_cast<size_t>(wall) + 1].contents = CONTENTS_SOLID;
    }
    bsp.models.resize(1);
    bsp.texinfos.resize(2);
    bsp.texinfos[1].flags = SURF_SKY;
    bsp.brush_sides = {{0, 0}, {0, -1}, {0, 1}};
    bsp.brushes = {{0, 2, CONTENTS_SOLID}, {2, 1, CONTENTS_SOLID}};
    bsp.leaf_brushes = {0, 1};
    bsp.leafs[1].leaf_brush_count = 1; // x = -100: no sky
    bsp.leafs[6].first_leaf_brush = 1; // the ceiling
    bsp.leafs[6].leaf_brush_count = sky ? 1 : 0;
    return bsp;
}

/// 90 degrees wide and high.
FrameDescription camera_at(vec3 origin, float pitch = 0.0f) {
    FrameDescription camera{};
    refresh::View view;
    view.origin = origin;
    view.angles = {pitch, 0.0f, 0.0f};
    view.fov_y = 90.0f;
    set_camera(camera, view, {64, 64});
    return camera;
}

/// How far outside of the walls a place lies; negative within.
float outside(vec3 place) {
    return std::max({std::abs(place.x), std::abs(place.y), std::abs(place.z)}) - half_size;
}

TEST(FirstPaths, MeetWhatTheCameraSees) {
    const std::vector<vec3> places = first_paths(room(false), camera_at({0, 0, 0}), 1000, 0);
    ASSERT_EQ(places.size(), 1000u);
    int right = 0, up = 0;
    for (const vec3& place : places) {
        EXPECT_NEAR(place.x, half_size, 1e-2f) << "the wall ahead fills the picture";
        EXPECT_LT(outside(place), 1e-2f);
        right += place.y < 0.0f ? 1 : 0;
        up += place.z > 0.0f ? 1 : 0;
    }
    EXPECT_NEAR(right, 500, 10);
    EXPECT_NEAR(up, 500, 10);
}

TEST(FirstPaths, GoOnFromWhatTheyMeet) {
    const std::vector<vec3> places = first_paths(room(false), camera_at({0, 0, 0}), 1000, 1);
    ASSERT_EQ(places.size(), 2000u);
    int ahead = 0, floor = 0;
    for (const vec3& place : places) {
        EXPECT_NEAR(outside(place), 0.0f, 1e-2f);
        ahead += place.x > half_size - 0.1f ? 1 : 0;
        floor += place.z < 0.1f - half_size ? 1 : 0;
    }
    EXPECT_EQ(ahead, 1000) << "no wall sees itself";
    // Form factors between the walls of a cube: 0.2 each.
    EXPECT_NEAR(floor, 200, 60);
}

TEST(FirstPaths, EndInTheSky) {
    const FrameDescription up = camera_at({0, 0, 0}, -90.0f);
    EXPECT_EQ(first_paths(room(false), up, 100, 1).size(), 200u);
    EXPECT_TRUE(first_paths(room(true), up, 100, 1).empty());
    const std::vector<vec3> places = first_paths(room(true), camera_at({0, 0, 0}), 1000, 1);
    EXPECT_NEAR(static_cast<double>(places.size()), 1800.0, 60.0);
    for (const vec3& place : places)
        EXPECT_LT(place.z, half_size - 1e-3f);
}

TEST(FirstPaths, NeedACameraSomewhere) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinity = std::numeric_limits<float>::infinity();
    for (const vec3 nowhere : {vec3(200, 0, 0), vec3(nan), vec3(infinity), vec3(0, 0, -infinity)})
        EXPECT_TRUE(first_paths(room(false), camera_at(nowhere), 10, 1).empty()) << nowhere.x;
    EXPECT_TRUE(first_paths(room(false), camera_at({0, 0, 0}), 0, 1).empty());
}

} // namespace
} // namespace vigil::vkpt
