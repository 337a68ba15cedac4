// SPDX-License-Identifier: GPL-2.0-or-later
// Lines of sight through a level's solid leafs, and which part of listed light they leave. The
// level is two rooms with a wall between, whose clusters see each other in the PVS.
#include "refresh/vkpt/light/list_sight.h"

#include "formats/bsp_query.h"
#include "level/pvs.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

namespace vigil {
namespace {

using glm::vec3;

/// Floors at z = 0 from x = -200 to -8 (cluster 0) and from 8 to 200 (cluster 1), 400 units deep;
/// below them, and between them if there is a wall, all is solid.
Bsp two_rooms(bool wall) {
    Bsp bsp;
    bsp.planes = {{vec3(0, 0, 1), 0.0f, 2}, {vec3(1, 0, 0), -8.0f, 0}, {vec3(1, 0, 0), 8.0f, 0}};
    BspNode floor, left, right;
    floor.plane = 0;
    floor.children = {1, -1 - 0};
    left.plane = 1;
    left.children = {2, -1 - 1};
    right.plane = 2;
    right.children = {-1 - 2, wall ? -1 - 0 : -1 - 1};
    bsp.nodes = {floor, left, right};
    bsp.leafs.resize(3);
    bsp.leafs[0].contents = CONTENTS_SOLID;
    bsp.leafs[1].cluster = 0;
    bsp.leafs[2].cluster = 1;
    bsp.cluster_count = 2;
    bsp.texinfos.resize(1);
    const float from[] = {-200.0f, 8.0f};
    for (const float x : from) {
        BspFace face;
        face.first_edge = static_cast<uint32_t>(bsp.surf_edges.size());
        face.edge_count = 4;
        const auto first = static_cast<uint32_t>(bsp.vertices.size());
        // Clockwise, seen from above.
        for (const vec3 corner :
             {vec3(x, -200, 0), vec3(x, 200, 0), vec3(x + 192, 200, 0), vec3(x + 192, -200, 0)})
            bsp.vertices.push_back(corner);
        for (uint32_t i = 0; i < 4; ++i) {
            bsp.surf_edges.push_back(static_cast<int32_t>(bsp.edges.size()));
            bsp.edges.push_back({first + i, first + (i + 1) % 4});
        }
        bsp.faces.push_back(face);
    }
    bsp.models.resize(1);
    bsp.models[0].face_count = 2;
    return bsp;
}

shader::Light lamp(vec3 place, float brightness) {
    shader::Light light{};
    light.v0 = place;
    light.e1 = {0, 4, 0};
    light.e2 = {4, 0, 0}; // lit below
    light.radiance = vec3(brightness);
    return light;
}

LightLists both_in_all_lists() {
    LightLists lists;
    lists.ranges = {{0, 2}, {0, 2}, {0, 2}};
    lists.ids = {0, 1};
    return lists;
}

TEST(ClearLine, EndsAtSolidLeafs) {
    const Bsp walled = two_rooms(true), open = two_rooms(false);
    const vec3 left(-50, 0, 30), right(50, 10, 70);
    EXPECT_TRUE(is_clear_line(walled, left, {-150, 100, 1}));
    EXPECT_FALSE(is_clear_line(walled, left, right));
    EXPECT_FALSE(is_clear_line(walled, right, left));
    EXPECT_TRUE(is_clear_line(open, left, right));
    EXPECT_FALSE(is_clear_line(open, left, {50, 0, -1})) << "through the floor";
    EXPECT_FALSE(is_clear_line(walled, left, {0, 0, 30})) << "into the wall";
    EXPECT_TRUE(is_clear_line(walled, left, left));
}

/// What a lamp brings to a place of the floor: its cosines over the squared distance.
double brings(const shader::Light& light, vec3 place) {
    const vec3 middle = light.v0 + (light.e1 + light.e2) / 3.0f - place;
    const double distance = glm::length(middle), height = middle.z;
    return static_cast<double>(light.radiance.x) * height * height / std::pow(distance, 4.0);
}

TEST(PartInSight, IsThatOfThePlacesDraws) {
    const std::vector<shader::Light> lights{lamp({-100, 0, 150}, 1.0f), lamp({40, 50, 150}, 3.0f)};
    double drawn = 0.0, seen = 0.0;
    for (float x = -199.0f; x < 200.0f; x += 2.0f)
        for (float y = -199.0f; y < 200.0f; y += 2.0f) {
            if (std::abs(x) < 8.0f) continue;
            const double left = brings(lights[0], {x, y, 1}), right = brings(lights[1], {x, y, 1});
            const double own = x < 0.0f ? left : right;
            drawn += 1.0;
            seen += own / (left + right);
        }
    const double expected = seen / drawn;
    ASSERT_GT(expected, 0.5);
    ASSERT_LT(expected, 0.95);
    EXPECT_NEAR(part_in_sight(two_rooms(true), both_in_all_lists(), lights), expected, 0.01);
    EXPECT_EQ(part_in_sight(two_rooms(false), both_in_all_lists(), lights), 1.0);

    // So often that not all are asked.
    LightLists longer;
    longer.ranges = {{0, 400}, {0, 400}, {0, 400}};
    for (uint32_t i = 0; i < 400; ++i)
        longer.ids.push_back(i % 2);
    EXPECT_NEAR(part_in_sight(two_rooms(true), longer, lights), expected, 0.02);
}

TEST(PartInSight, IsWholeWhereNothingIsOutOfSight) {
    // The first lamp is dark, or faces up: nothing draws it.
    for (const bool dark : {true, false}) {
        std::vector<shader::Light> lights{lamp({-100, 0, 150}, dark ? 0.0f : 1.0f),
                                          lamp({100, 0, 150}, 1.0f)};
        if (!dark) std::swap(lights[0].e1, lights[0].e2);
        LightLists lists = both_in_all_lists();
        lists.ranges[0] = {0, 1}; // the second lamp is in the list of its own room only
        EXPECT_EQ(part_in_sight(two_rooms(true), lists, lights), 1.0);
    }
    EXPECT_EQ(
        part_in_sight(two_rooms(true), both_in_all_lists(),
                      std::vector<shader::Light>{lamp({0, 0, 150}, 0.0f), lamp({0, 0, 150}, 0.0f)}),
        1.0)
        << "no light at all";
}

} // namespace
} // namespace vigil
