// SPDX-License-Identifier: GPL-2.0-or-later
// Light lists: where lights are placed, what their lists promise (nothing that could shine is left
// out), and that real levels come out right and fast. Small levels are built by hand, real ones are
// skipped where missing.
#include "refresh/vkpt/light/light_lists.h"

#include "../formats/real_levels.h"
#include "formats/bsp.h"
#include "formats/bsp_query.h"
#include "shared/random.h"
#include "shared/sampling.h"
#include "world/pvs.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>

namespace vigil {
namespace {

using glm::vec3;
using Ids = std::vector<uint32_t>;

/// Four cells in a square, 100 units wide each, split at x = 0 and y = 0: cluster 0 at (-, -), 1 at
/// (+, -), 2 at (-, +), 3 at (+, +); everything above z = 100 is solid. `visible` are rows of bits.
Bsp make_level(std::array<uint8_t, 4> visible = {0xf, 0xf, 0xf, 0xf}) {
    Bsp bsp;
    bsp.planes = {{vec3(0, 0, 1), 100.0f, 2}, {vec3(1, 0, 0), 0.0f, 0}, {vec3(0, 1, 0), 0.0f, 1}};
    BspNode roof, x, negative, positive;
    roof.plane = 0;
    roof.children = {-1, 1}; // leaf 0: solid
    x.plane = 1;
    x.children = {3, 2};
    negative.plane = positive.plane = 2;
    negative.children = {-1 - 3, -1 - 1};
    positive.children = {-1 - 4, -1 - 2};
    bsp.nodes = {roof, x, negative, positive};
    bsp.leafs.resize(5);
    bsp.leafs[0].contents = CONTENTS_SOLID;
    for (int32_t cluster = 0; cluster < 4; ++cluster) {
        BspLeaf& leaf = bsp.leafs[static_cast<size_t>(cluster) + 1];
        leaf.cluster = cluster;
        leaf.mins = vec3((cluster & 1) != 0 ? 0 : -100, (cluster & 2) != 0 ? 0 : -100, 0);
        leaf.maxs = leaf.mins + 100.0f;
    }
    bsp.models.resize(1);
    bsp.cluster_count = 4;
    // Rows of one byte each, none of them zero, so nothing is compressed.
    for (uint32_t cluster = 0; cluster < 4; ++cluster) {
        bsp.visibility.push_back(visible[cluster]);
        bsp.visibility_offsets.push_back({cluster, cluster});
    }
    return bsp;
}

/// A small triangle around a point, facing `normal`.
LightTriangle speck(vec3 center, vec3 normal, uint32_t id, float size = 4.0f) {
    const shader::Basis basis = shader::make_basis(normal);
    return {center - size * basis.tangent - size * basis.bitangent,
            center + size * basis.tangent - size * basis.bitangent, center + size * basis.bitangent,
            id};
}

Ids touched(const Bsp& bsp, const LightTriangle& light) {
    Ids clusters;
    LightLister(bsp, Pvs(bsp)).clusters_touched(light, clusters);
    return clusters;
}

Ids list(const LightLists& lists, size_t cluster) {
    const auto ids = lists.list(cluster);
    return {ids.begin(), ids.end()};
}

const vec3 down(0, 0, -1);

TEST(ClustersTouched, FindsTheCellsOfThePolygonNotOfItsBox) {
    const Bsp bsp = make_level();
    EXPECT_EQ(touched(bsp, speck({-50, -50, 50}, down, 0)), (Ids{0}));
    EXPECT_EQ(touched(bsp, speck({0, -50, 50}, down, 0)), (Ids{0, 1}));
    EXPECT_EQ(touched(bsp, speck({0, 0, 50}, down, 0)), (Ids{0, 1, 2, 3}));
    // Its box reaches into cell 3, the triangle does not.
    EXPECT_EQ(touched(bsp, {{-80, -80, 50}, {20, -80, 50}, {-80, 20, 50}, 0}), (Ids{0, 1, 2}));
}

TEST(ClustersTouched, PolygonsInAPlaneBelongToTheirLitSide) {
    const Bsp bsp = make_level();
    EXPECT_EQ(touched(bsp, speck({0, -50, 50}, {1, 0, 0}, 0)), (Ids{1}));
    EXPECT_EQ(touched(bsp, speck({0, -50, 50}, {-1, 0, 0}, 0)), (Ids{0}));
    EXPECT_EQ(touched(bsp, speck({-50, -50, 100}, down, 0)), (Ids{0})) << "a lamp in the ceiling";
    EXPECT_EQ(touched(bsp, speck({-50, -50, 100}, -down, 0)), Ids{}) << "its other side is solid";
    // Off by a rounding error.
    EXPECT_EQ(touched(bsp, speck({1e-3f, -50, 50}, {-1, 0, 0}, 0)), (Ids{0}));
}

TEST(ClustersTouched, CornersOnAPlaneTouchBothSides) {
    const Bsp bsp = make_level();
    EXPECT_EQ(touched(bsp, {{0, -50, 50}, {20, -60, 50}, {20, -40, 50}, 0}), (Ids{0, 1}));
    EXPECT_EQ(touched(bsp, {{0, 0, 50}, {20, 0, 60}, {20, 20, 50}, 0}), (Ids{0, 1, 2, 3}));
    // Points and lines are placed as well.
    EXPECT_EQ(touched(bsp, {{5, 5, 5}, {5, 5, 5}, {5, 5, 5}, 0}), (Ids{3}));
    EXPECT_EQ(touched(bsp, {{-5, 5, 5}, {5, 5, 5}, {5, 5, 5}, 0}), (Ids{2, 3}));
}

TEST(LightLists, FollowThePvs) {
    // Left and right do not see each other.
    const Bsp bsp = make_level({0b0101, 0b1010, 0b0101, 0b1010});
    const LightLister lister(bsp, Pvs(bsp));
    const std::vector<LightTriangle> lights{
        speck({50, 50, 90}, down, 9), speck({-50, -50, 90}, down, 4), speck({-50, 50, 90}, down, 7),
        speck({0, 50, 90}, down, 5)};
    const LightLists lists = lister.build(lights);
    ASSERT_EQ(lists.ranges.size(), 5u);
    EXPECT_EQ(list(lists, 0), (Ids{4, 5, 7}));
    EXPECT_EQ(list(lists, 1), (Ids{5, 9}));
    EXPECT_EQ(list(lists, 2), (Ids{4, 5, 7}));
    EXPECT_EQ(list(lists, 3), (Ids{5, 9}));
    EXPECT_EQ(list(lists, 4), (Ids{4, 5, 7, 9})) << "the last list holds all";
    EXPECT_EQ(lists.pair_count, 10u);
    EXPECT_EQ(lists.ids.size(), 9u)
        << "two lists, each shared by two clusters, and the list of all";
    EXPECT_EQ(lists.unplaced, 0u);
}

TEST(LightLists, SightGoesBothWays) {
    // Cluster 0 sees 3, but the row of 3 does not say so.
    const Bsp bsp = make_level({0b1001, 0b0010, 0b0100, 0b1000});
    const LightLister lister(bsp, Pvs(bsp));
    const std::vector<LightTriangle> lights{speck({-50, -50, 90}, down, 0),
                                            speck({50, 50, 90}, down, 1)};
    const LightLists lists = lister.build(lights);
    EXPECT_EQ(list(lists, 0), (Ids{0, 1}));
    EXPECT_EQ(list(lists, 3), (Ids{0, 1}));
    EXPECT_EQ(list(lists, 1), Ids{});
}

TEST(LightLists, LeaveOutClustersBehindTheLight) {
    const Bsp bsp = make_level();
    const LightLister lister(bsp, Pvs(bsp));
    // On a wall between the halves, lit side to +x, far enough from the plane for the margin.
    const std::vector<LightTriangle> lights{speck({10, -50, 50}, {1, 0, 0}, 0)};
    const LightLists lists = lister.build(lights);
    EXPECT_EQ(list(lists, 0), Ids{});
    EXPECT_EQ(list(lists, 1), (Ids{0}));
    EXPECT_EQ(list(lists, 2), Ids{});
    EXPECT_EQ(list(lists, 3), (Ids{0}));
}

TEST(LightLists, TrianglesOfOneLightJoin) {
    const Bsp bsp = make_level({1, 2, 4, 8});
    const LightLister lister(bsp, Pvs(bsp));
    const std::vector<LightTriangle> lights{speck({50, 50, 90}, down, 3),
                                            speck({-50, -50, 90}, down, 2),
                                            speck({-50, -50, 90}, down, 3)};
    const LightLists lists = lister.build(lights);
    EXPECT_EQ(list(lists, 0), (Ids{2, 3}));
    EXPECT_EQ(list(lists, 3), (Ids{3}));
    EXPECT_EQ(list(lists, 4), (Ids{2, 3}));
}

TEST(LightLists, LightsInWallsAreListedEverywhere) {
    const Bsp bsp = make_level({1, 2, 4, 8});
    const LightLister lister(bsp, Pvs(bsp));
    const LightLists lists = lister.build(std::vector{speck({50, 50, 150}, down, 1)});
    EXPECT_EQ(lists.unplaced, 1u);
    for (size_t cluster = 0; cluster < 5; ++cluster)
        EXPECT_EQ(list(lists, cluster), (Ids{1}));
}

TEST(LightLists, NoLightsAndNoVisibility) {
    Bsp bsp = make_level();
    bsp.visibility.clear();
    bsp.visibility_offsets.clear();
    const LightLister lister(bsp, Pvs(bsp));
    const LightLists none = lister.build({});
    ASSERT_EQ(none.ranges.size(), 5u);
    for (const LightRange& range : none.ranges)
        EXPECT_EQ(range.count, 0u);
    const LightLists one = lister.build(std::vector{speck({50, 50, 90}, down, 0)});
    for (size_t cluster = 0; cluster < 5; ++cluster)
        EXPECT_EQ(list(one, cluster), (Ids{0}));
}

/// Triangles of the world's emissive faces.
std::vector<LightTriangle> world_lights(const Bsp& bsp) {
    std::vector<LightTriangle> lights;
    const BspModel& world = bsp.models.front();
    for (uint32_t f = world.first_face; f < world.first_face + world.face_count; ++f) {
        const BspFace& face = bsp.faces[f];
        if (!is_emissive(bsp.texinfos[face.texinfo])) continue;
        const std::vector<vec3> polygon = face_polygon(bsp, face);
        for (size_t i = 2; i < polygon.size(); ++i)
            lights.push_back(
                {polygon[0], polygon[i - 1], polygon[i], static_cast<uint32_t>(lights.size())});
    }
    return lights;
}

class RealLevelLights : public testing::TestWithParam<const char*> {
protected:
    void SetUp() override {
        const auto folder = real_levels_folder();
        if (!folder) GTEST_SKIP() << "no real levels: set VIGIL_SHARED to the folder of levels/";
        bsp_ = parse_bsp(GetParam(), read_file(*folder / "baseq2/maps" / GetParam()));
        pvs_ = Pvs(bsp_);
    }
    Bsp bsp_;
    Pvs pvs_;
};

TEST_P(RealLevelLights, NothingThatCouldShineIsLeftOut) {
    const std::vector<LightTriangle> lights = world_lights(bsp_);
    ASSERT_FALSE(lights.empty());
    const LightLister lister(bsp_, pvs_);
    const LightLists lists = lister.build(lights);
    shader::Random random = shader::random_begin(glm::uvec2(0, 0), 0, 1);

    // Points in the open, with their clusters.
    struct Point {
        vec3 position;
        int32_t cluster;
    };
    std::vector<Point> points;
    for (int i = 0; i < 20000 && points.size() < 300; ++i) {
        const BspModel& world = bsp_.models.front();
        const vec3 p = glm::mix(world.mins, world.maxs, shader::random_next3(random));
        const int32_t cluster = cluster_at(bsp_, p);
        if (cluster >= 0) points.push_back({p, cluster});
    }
    ASSERT_FALSE(points.empty());

    Ids clusters;
    size_t checked = 0;
    for (const LightTriangle& light : lights) {
        lister.clusters_touched(light, clusters);
        const vec3 e1 = light.v1 - light.v0, e2 = light.v2 - light.v0;
        const vec3 normal = glm::cross(e1, e2);
        if (glm::length(normal) < 1.0f) continue;
        for (int i = 0; i < 4; ++i) {
            // A point of the light, just in front of it: its cluster was found.
            const glm::vec2 w = shader::sample_triangle(shader::random_next2(random));
            const vec3 q = light.v0 + w.x * e1 + w.y * e2 + 0.06f * glm::normalize(normal);
            const int32_t home = cluster_at(bsp_, q);
            if (home < 0) continue;
            ASSERT_TRUE(
                std::binary_search(clusters.begin(), clusters.end(), static_cast<uint32_t>(home)))
                << "light " << light.id;
            // And from wherever that cluster is seen, on the lit side, the light is listed.
            for (const Point& point : points) {
                if (!pvs_.visible(point.cluster, home) ||
                    glm::dot(normal, point.position - light.v0) <= 0.0f)
                    continue;
                const auto ids = lists.list(static_cast<size_t>(point.cluster));
                ASSERT_TRUE(std::binary_search(ids.begin(), ids.end(), light.id))
                    << "light " << light.id;
                ++checked;
            }
        }
    }
    EXPECT_GT(checked, 100u);
}

TEST_P(RealLevelLights, ListsAreSortedUniqueAndQuick) {
    const std::vector<LightTriangle> lights = world_lights(bsp_);
    const LightLister lister(bsp_, pvs_);
    const auto start = std::chrono::steady_clock::now();
    const LightLists lists = lister.build(lights);
    const double ms =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    ASSERT_EQ(lists.ranges.size(), size_t{pvs_.cluster_count()} + 1);
    for (size_t cluster = 0; cluster < lists.ranges.size(); ++cluster) {
        const auto ids = lists.list(cluster);
        EXPECT_TRUE(std::adjacent_find(ids.begin(), ids.end(), std::greater_equal<>()) ==
                    ids.end());
    }
    EXPECT_EQ(lists.list(pvs_.cluster_count()).size(), lights.size());
    std::printf("%s: %zu lights, %u clusters, %llu pairs, %zu ids stored, %u in walls, %.1f ms\n",
                GetParam(), lights.size(), pvs_.cluster_count(),
                static_cast<unsigned long long>(lists.pair_count), lists.ids.size(), lists.unplaced,
                ms);
}

INSTANTIATE_TEST_SUITE_P(All, RealLevelLights,
                         testing::Values("dm3.bsp", "e1m1.bsp", "e3m4.bsp", "e3m6.bsp", "end.bsp",
                                         "start.bsp"));

} // namespace
} // namespace vigil
