// SPDX-License-Identifier: GPL-2.0-or-later
// Light lists: where lights are placed, what their lists promise (nothing that could shine is left
// out), and that real levels come out right and fast. Small levels are built by hand, real ones are
// skipped where missing.
#include "refresh/vkpt/light/light_lists.h"

#include "../formats/real_levels.h"
#include "formats/bsp.h"
#include "formats/bsp_query.h"
#include "level/pvs.h"
#include "refresh/vkpt/scene/bounds.h"
#include "shared/random.h"
#include "shared/sampling.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <functional>
#include <limits>
#include <malloc.h>
#include <new>
#include <numeric>

namespace {

// What lies on the heap now, and the most that did.
std::atomic<int64_t> heap_bytes = 0, heap_peak = 0;

} // namespace

// This program's own new and delete, which count.
void* operator new(size_t bytes, const std::nothrow_t&) noexcept {
    void* const memory = std::malloc(bytes);
    if (memory == nullptr) return nullptr;
    heap_bytes += static_cast<int64_t>(malloc_usable_size(memory));
    heap_peak = std::max(heap_peak.load(), heap_bytes.load());
    return memory;
}
void* operator new(size_t bytes) {
    void* const memory = operator new(bytes, std::nothrow);
    if (memory == nullptr) throw std::bad_alloc();
    return memory;
}
void operator delete(void* memory) noexcept {
    heap_bytes -= static_cast<int64_t>(malloc_usable_size(memory));
    std::free(memory);
}
void operator delete(void* memory, size_t) noexcept {
    operator delete(memory);
}

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

/// The most memory taken from the heap at one time since it was made, beyond what was there.
class PeakMemory {
public:
    PeakMemory() : before_(heap_bytes) { heap_peak = before_; }
    int64_t peak() const { return heap_peak - before_; }

private:
    int64_t before_;
};

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

/// Cells in a row along x, one unit wide each, and their rows of visibility.
Bsp make_corridor(const std::vector<std::vector<uint8_t>>& rows) {
    Bsp bsp;
    const auto count = static_cast<uint32_t>(rows.size());
    bsp.models.resize(1);
    bsp.cluster_count = count;
    bsp.leafs.resize(count);
    for (uint32_t c = 0; c < count; ++c) {
        bsp.leafs[c].cluster = static_cast<int32_t>(c);
        bsp.visibility_offsets.push_back(
            {static_cast<uint32_t>(bsp.visibility.size()), uint32_t{0}});
        for (const uint8_t byte : rows[c]) {
            bsp.visibility.push_back(byte);
            if (byte == 0) bsp.visibility.push_back(1); // a run of one zero byte
        }
    }
    for (uint32_t wall = 1; wall < count; ++wall) {
        bsp.planes.push_back({vec3(1, 0, 0), static_cast<float>(wall), 0});
        BspNode node;
        node.plane = wall - 1;
        const auto next = static_cast<int32_t>(wall);
        node.children = {wall + 1 < count ? next : -1 - next, -next};
        bsp.nodes.push_back(node);
    }
    return bsp;
}

TEST(LightLists, SightGoesBothWaysInLongRows) {
    constexpr uint32_t count = 150; // three words, the last one not full
    shader::Random random = shader::random_begin(glm::uvec2(0, 0), 0, 1);
    std::vector<std::vector<uint8_t>> rows(count, std::vector<uint8_t>((count + 7) / 8));
    for (auto& row : rows)
        for (uint8_t& byte : row)
            for (uint32_t bit = 0; bit < 8; ++bit)
                byte |= static_cast<uint8_t>((shader::random_next(random) < 0.05f) << bit);
    const Bsp bsp = make_corridor(rows);
    const Pvs pvs(bsp);
    std::vector<LightTriangle> lights;
    for (uint32_t c = 0; c < count; ++c)
        lights.push_back(speck({static_cast<float>(c) + 0.5f, 0, 0}, {0, 0, 1}, c, 0.1f));
    const LightLists lists = LightLister(bsp, pvs).build(lights);
    for (int32_t c = 0; c < static_cast<int32_t>(count); ++c) {
        Ids seen;
        for (int32_t light = 0; light < static_cast<int32_t>(count); ++light)
            if (pvs.visible(c, light) || pvs.visible(light, c))
                seen.push_back(static_cast<uint32_t>(light));
        EXPECT_EQ(list(lists, static_cast<size_t>(c)), seen) << "cluster " << c;
    }
}

TEST(LightLists, BeyondTheirLimitsAllClustersShareOne) {
    // Left and right do not see each other: eight ids in two lists, and four in that of all.
    const Bsp bsp = make_level({0b0101, 0b1010, 0b0101, 0b1010});
    const LightLister lister(bsp, Pvs(bsp));
    std::vector<LightTriangle> lights;
    for (uint32_t id = 0; id < 4; ++id)
        lights.push_back(speck({0, 50, 90}, down, id));
    LightListLimits limits;
    limits.ids = 12;
    const LightLists fitting = lister.build(lights, limits);
    EXPECT_EQ(fitting.refused, "");
    EXPECT_EQ(fitting.ids.size(), 8u) << "all clusters see all lights: one list, and that of all";

    lights[0] = speck({50, 50, 90}, down, 0); // seen from the right only
    const LightLists two = lister.build(lights, limits);
    EXPECT_EQ(two.refused, "");
    EXPECT_EQ(two.ids.size(), 11u);
    limits.ids = 10;
    const LightLists shared = lister.build(lights, limits);
    EXPECT_EQ(shared.refused, "would have more than 10 entries");
    ASSERT_EQ(shared.ranges.size(), 5u);
    for (size_t cluster = 0; cluster < 5; ++cluster)
        EXPECT_EQ(list(shared, cluster), (Ids{0, 1, 2, 3}));
    EXPECT_EQ(shared.ids.size(), 4u);
    EXPECT_EQ(shared.pair_count, 16u);

    limits = {};
    limits.steps = two.steps;
    EXPECT_EQ(lister.build(lights, limits).refused, "");
    --limits.steps;
    const LightLists late = lister.build(lights, limits);
    EXPECT_EQ(late.refused, "would take too long to make");
    for (size_t cluster = 0; cluster < 5; ++cluster)
        EXPECT_EQ(list(late, cluster), (Ids{0, 1, 2, 3}));
}

// A file of 1.6 MB: 32,768 clusters, each of which sees all others, and lights by the hundred
// thousand, whose faces share their corners. A bit for each light and cluster would be 800 MB.
TEST(LightLists, OfAHostileLevelTakeLittleMemory) {
    Bsp bsp = make_level();
    bsp.visibility.clear();
    bsp.visibility_offsets.clear();
    bsp.cluster_count = bsp_max_clusters;
    for (uint32_t cluster = 4; cluster < bsp_max_clusters; ++cluster) {
        BspLeaf leaf;
        leaf.cluster = static_cast<int32_t>(cluster);
        bsp.leafs.push_back(leaf); // without bounds: it may be anywhere
    }
    const LightLister lister(bsp, Pvs(bsp));
    const std::vector<LightTriangle> lights = [] {
        std::vector<LightTriangle> list;
        for (uint32_t id = 0; id < 200'000; ++id)
            list.push_back(speck({-50, -50, 90}, down, id));
        return list;
    }();
    LightListLimits limits;
    limits.steps = uint64_t{1} << 26; // an eighth: a test is in a hurry
    const PeakMemory memory;
    const LightLists lists = lister.build(lights, limits);
    EXPECT_EQ(lists.refused, "would take too long to make");
    EXPECT_LT(memory.peak(), 16 << 20);
    EXPECT_GE(memory.peak(), static_cast<int64_t>(lights.size() * sizeof(uint32_t)))
        << "nothing is counted";
    EXPECT_LE(lists.steps, limits.steps + (uint64_t{1} << 16)) << "one light too many";
    EXPECT_EQ(lists.list(12'345).size(), lights.size());
    EXPECT_EQ(lists.pair_count, uint64_t{bsp_max_clusters} * lights.size());
}

// Within the limits: lists of their own, and no more memory than the limits say.
TEST(LightLists, TakeNoMoreMemoryThanTheirLimits) {
    constexpr uint32_t count = 1024;
    std::vector<std::vector<uint8_t>> rows(count, std::vector<uint8_t>(count / 8, 0));
    for (uint32_t c = 0; c < count; ++c)
        std::fill_n(rows[c].begin(), 1 + c / 16, uint8_t{0xff}); // each sees a bit farther
    const Bsp bsp = make_corridor(rows);
    const LightLister lister(bsp, Pvs(bsp));
    std::vector<LightTriangle> lights;
    for (uint32_t id = 0; id < 8192; ++id)
        lights.push_back(speck({static_cast<float>(id % count) + 0.5f, 0, 0}, {0, 0, 1}, id, 0.1f));
    constexpr int64_t small = 1 << 19; // sets of bits for all lights would be 1 MiB
    LightListLimits limits;
    limits.kept_words = 1 << 16;
    {
        const PeakMemory memory;
        const LightLists lists = lister.build(lights, limits);
        EXPECT_EQ(lists.refused, "");
        EXPECT_GT(lists.ids.size(), size_t{1} << 18);
        EXPECT_LT(memory.peak(), static_cast<int64_t>(lists.ids.size() * sizeof(uint32_t)) + small);
    }
    limits.ids = 1 << 18;
    const PeakMemory memory;
    EXPECT_EQ(lister.build(lights, limits).refused, "would have more than 262144 entries");
    EXPECT_LT(memory.peak(), small);
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

/// Bounds of each cluster's leafs.
std::vector<Bounds> cluster_bounds(const Bsp& bsp) {
    std::vector<Bounds> bounds(bsp.cluster_count);
    for (const BspLeaf& leaf : bsp.leafs) {
        if (leaf.cluster < 0) continue;
        bounds[static_cast<size_t>(leaf.cluster)].grow(leaf.mins);
        bounds[static_cast<size_t>(leaf.cluster)].grow(leaf.maxs);
    }
    return bounds;
}

/// Whether a light's lit side has any of a box, grown by `margin`.
bool shines_into(const LightTriangle& light, const Bounds& box, double margin) {
    const glm::dvec3 v0(light.v0);
    const glm::dvec3 normal = glm::cross(glm::dvec3(light.v1) - v0, glm::dvec3(light.v2) - v0);
    double most = -std::numeric_limits<double>::infinity();
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 p((corner & 1) != 0 ? box.upper.x + margin : box.lower.x - margin,
                           (corner & 2) != 0 ? box.upper.y + margin : box.lower.y - margin,
                           (corner & 4) != 0 ? box.upper.z + margin : box.lower.z - margin);
        most = std::max(most, glm::dot(normal, p - v0));
    }
    return most > 0.0;
}

// Light by light and cluster by cluster: which ones a list must hold, and which ones it may hold.
TEST_P(RealLevelLights, ListsHoldWhatIsSeenAndLittleElse) {
    const std::vector<LightTriangle> lights = world_lights(bsp_);
    const LightLister lister(bsp_, pvs_);
    const LightLists lists = lister.build(lights);
    ASSERT_EQ(lists.ranges.size(), size_t{pvs_.cluster_count()} + 1);
    const std::vector<Bounds> bounds = cluster_bounds(bsp_);
    std::vector<Ids> least(pvs_.cluster_count()), most(pvs_.cluster_count());
    Ids clusters;
    for (const LightTriangle& light : lights) {
        lister.clusters_touched(light, clusters);
        for (uint32_t c = 0; c < pvs_.cluster_count(); ++c) {
            const auto sees = [&](uint32_t touched) {
                const auto from = static_cast<int32_t>(c), to = static_cast<int32_t>(touched);
                return pvs_.visible(from, to) || pvs_.visible(to, from);
            };
            if (!clusters.empty() && std::ranges::none_of(clusters, sees)) continue;
            if (shines_into(light, bounds[c], 0.0)) least[c].push_back(light.id);
            if (shines_into(light, bounds[c], 4.0)) most[c].push_back(light.id);
        }
    }
    uint64_t pairs = 0;
    for (uint32_t c = 0; c < pvs_.cluster_count(); ++c) {
        const Ids ids = list(lists, c);
        pairs += ids.size();
        EXPECT_TRUE(std::ranges::adjacent_find(ids, std::greater_equal<>()) == ids.end()) << c;
        EXPECT_TRUE(std::ranges::includes(ids, least[c])) << "cluster " << c << " lacks a light";
        EXPECT_TRUE(std::ranges::includes(most[c], ids)) << "cluster " << c << " has one too many";
    }
    EXPECT_EQ(lists.pair_count, pairs);
    EXPECT_GT(pairs, 0u);
    Ids all(lights.size());
    std::iota(all.begin(), all.end(), 0u);
    EXPECT_EQ(list(lists, pvs_.cluster_count()), all);
    EXPECT_EQ(lists.refused, "");
    EXPECT_LT(lists.steps, 8 * pairs) << "it looks at what it lists, and little else";
    std::printf(
        "%s: %zu lights, %u clusters, %llu pairs, %zu ids stored, %u in walls, %llu steps\n",
        GetParam(), lights.size(), pvs_.cluster_count(),
        static_cast<unsigned long long>(lists.pair_count), lists.ids.size(), lists.unplaced,
        static_cast<unsigned long long>(lists.steps));
}

TEST_P(RealLevelLights, ListsAreTheSameWithoutRoomForBitSets) {
    const std::vector<LightTriangle> lights = world_lights(bsp_);
    const LightLister lister(bsp_, pvs_);
    LightListLimits limits;
    const LightLists kept = lister.build(lights, limits);
    limits.kept_words = 0;
    const LightLists again = lister.build(lights, limits);
    ASSERT_EQ(again.ranges.size(), kept.ranges.size());
    for (size_t cluster = 0; cluster < kept.ranges.size(); ++cluster)
        EXPECT_EQ(list(again, cluster), list(kept, cluster));
    EXPECT_EQ(again.ids, kept.ids);
    EXPECT_EQ(again.unplaced, kept.unplaced);
    EXPECT_EQ(again.pair_count, kept.pair_count);
    EXPECT_EQ(again.steps, 3 * kept.steps) << "light by light, three times over";
}

INSTANTIATE_TEST_SUITE_P(All, RealLevelLights,
                         testing::Values("dm3.bsp", "e1m1.bsp", "e3m4.bsp", "e3m6.bsp", "end.bsp",
                                         "start.bsp"));

} // namespace
} // namespace vigil
