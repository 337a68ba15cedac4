// SPDX-License-Identifier: GPL-2.0-or-later
// Traces against what the definition of a brush says, asked point by point.
#include "box_level.h"
#include "common/error.h"
#include "formats/real_levels.h"
#include "game/collision_world.h"
#include "game/view_axes.h"

#include <glm/glm.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>

namespace vigil {
namespace {

const Box cube{glm::vec3(-16), glm::vec3(16)};

/// How deep a box's middle is inside a brush (negative: outside), by the brush's planes alone.
float depth_in(const Bsp& bsp, const BspBrush& brush, const Placement& placement,
               const glm::vec3& place, const Box& box) {
    const glm::mat3 rotation = model_rotation(placement.angles);
    const glm::vec3 middle = place + 0.5f * (box.mins + box.maxs) - placement.origin;
    const glm::vec3 half = 0.5f * (box.maxs - box.mins);
    float depth = 1e9f;
    for (uint32_t i = 0; i < brush.side_count; ++i) {
        const BspPlane& plane = bsp.planes[bsp.brush_sides[brush.first_side + i].plane];
        const glm::vec3 normal = rotation * plane.normal;
        depth = std::min(depth,
                         plane.dist + glm::dot(glm::abs(normal), half) - glm::dot(normal, middle));
    }
    return depth;
}

/// The greatest depth in any brush of the world that the mask selects.
float depth_in_world(const Bsp& bsp, const glm::vec3& place, const Box& box, uint32_t mask,
                     std::span<const uint32_t> brushes) {
    float depth = -1e9f;
    for (const uint32_t index : brushes) {
        const BspBrush& brush = bsp.brushes[index];
        if ((brush.contents & mask) == 0 || brush.side_count == 0) continue;
        depth = std::max(depth, depth_in(bsp, brush, {}, place, box));
    }
    return depth;
}

/// Brushes below a model's head node.
std::vector<uint32_t> brushes_of(const Bsp& bsp, const BspModel& model) {
    std::vector<uint32_t> found;
    std::vector<int32_t> stack{model.headnode};
    while (!stack.empty()) {
        const int32_t child = stack.back();
        stack.pop_back();
        if (child >= 0) {
            for (const int32_t next : bsp.nodes[static_cast<size_t>(child)].children)
                stack.push_back(next);
            continue;
        }
        const BspLeaf& leaf = bsp.leafs[static_cast<size_t>(-1 - child)];
        for (uint32_t i = 0; i < leaf.leaf_brush_count; ++i)
            found.push_back(bsp.leaf_brushes[leaf.first_leaf_brush + i]);
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

/// A trace is right if its way is free, if it ends before a brush, and if that brush is near.
void expect_true(const Bsp& bsp, const Trace& trace, const glm::vec3& start, const glm::vec3& end,
                 const Box& box, std::span<const uint32_t> brushes) {
    constexpr float rounding = 0.02f;
    const auto depth_at = [&](float fraction) {
        return depth_in_world(bsp, start + fraction * (end - start), box, mask_player_solid,
                              brushes);
    };
    const float at_start = depth_at(0.0f);
    if (std::abs(at_start) > rounding) {
        EXPECT_EQ(trace.start_solid, at_start > 0.0f);
    }
    if (trace.start_solid || at_start > -rounding) return;
    for (int i = 0; i <= 64; ++i)
        ASSERT_LT(depth_at(trace.fraction * static_cast<float>(i) / 64.0f), rounding)
            << "at " << i << "/64 of fraction " << trace.fraction;
    if (trace.fraction == 1.0f) return;
    // A little further there is a solid: further by the gap, measured along the normal.
    const float length = glm::length(end - start);
    const float into = -glm::dot(trace.normal, (end - start) / length);
    ASSERT_GT(into, 0.0f);
    const float further = (2.0f * trace_gap + rounding) / into / length;
    // Past the end of the way too: a trace may stop at what it would come nearer to than the gap. A
    // way along a brush's edge comes to it before that, and has left it there.
    float deepest = -1.0f;
    for (int i = 1; i <= 64; ++i)
        deepest =
            std::max(deepest, depth_at(trace.fraction + further * static_cast<float>(i) / 64.0f));
    EXPECT_GT(deepest, -rounding) << "fraction " << trace.fraction;
    EXPECT_TRUE(trace.hit());
}

TEST(Trace, StopsBeforeABox) {
    BoxLevel level;
    level.add_box({{100, -50, -50}, {200, 50, 50}}, CONTENTS_SOLID, SURF_SLICK);
    const Bsp bsp = level.build();
    const CollisionWorld world(bsp);
    const Trace trace = world.trace({0, 0, 0}, {300, 0, 0}, cube, mask_player_solid);
    EXPECT_NEAR(trace.end.x, 100 - 16 - trace_gap, 1e-3f);
    EXPECT_EQ(trace.normal, glm::vec3(-1, 0, 0));
    EXPECT_EQ(trace.owner, owner_world);
    EXPECT_EQ(trace.surface_flags, SURF_SLICK);
    EXPECT_EQ(trace.contents, CONTENTS_SOLID);
    EXPECT_FALSE(trace.start_solid);
    EXPECT_EQ(world.trace({0, 0, 0}, {300, 0, 0}, cube, CONTENTS_WINDOW).fraction, 1.0f);
    EXPECT_EQ(world.trace({0, 70, 0}, {300, 70, 0}, cube, mask_player_solid).fraction, 1.0f);
    const Trace inside = world.trace({150, 0, 0}, {151, 0, 0}, cube, mask_player_solid);
    EXPECT_TRUE(inside.all_solid);
    EXPECT_EQ(inside.fraction, 0.0f);
    const Trace out = world.trace({90, 0, 0}, {0, 0, 0}, cube, mask_player_solid);
    EXPECT_TRUE(out.start_solid);
    EXPECT_FALSE(out.all_solid);
    EXPECT_EQ(out.fraction, 1.0f);
}

TEST(Trace, AgreesWithTheDefinitionOnRandomBrushes) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
    const auto vector = [&] { return glm::vec3(unit(random), unit(random), unit(random)); };
    for (int round = 0; round < 60; ++round) {
        BoxLevel level;
        for (int i = 0; i < 8; ++i) {
            const glm::vec3 middle = 200.0f * vector();
            std::vector<glm::vec4> planes;
            for (const glm::vec3 axis : {glm::vec3(1, 0, 0), {0, 1, 0}, {0, 0, 1}})
                for (const float sign : {-1.0f, 1.0f})
                    planes.emplace_back(sign * axis, glm::dot(sign * axis, middle) + 50.0f);
            for (int side = 0; side < 5; ++side) {
                const glm::vec3 normal = glm::normalize(vector());
                planes.emplace_back(normal, glm::dot(normal, middle) + 20.0f +
                                                30.0f * std::abs(unit(random)));
            }
            level.add_brush(planes);
        }
        const Bsp bsp = level.build();
        const CollisionWorld world(bsp);
        const std::vector<uint32_t> brushes = brushes_of(bsp, bsp.models[0]);
        for (int i = 0; i < 40; ++i) {
            const glm::vec3 start = 400.0f * vector(), end = 400.0f * vector();
            const Box box = i % 2 == 0 ? Box{} : cube;
            expect_true(bsp, world.trace(start, end, box, mask_player_solid), start, end, box,
                        brushes);
        }
    }
}

TEST(Trace, AgreesWithTheDefinitionOnTurnedModels) {
    std::mt19937 random(2);
    std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
    const auto vector = [&] { return glm::vec3(unit(random), unit(random), unit(random)); };
    BoxLevel level;
    const uint32_t model = level.add_model({{-40, -20, -10}, {40, 20, 10}});
    const Bsp bsp = level.build();
    const BspBrush& brush = bsp.brushes[0];
    int hits = 0;
    for (int i = 0; i < 2000; ++i) {
        CollisionWorld world(bsp);
        const Placement place{50.0f * vector(), 180.0f * vector()};
        world.add({model, place, 7, true});
        const glm::vec3 start = 150.0f * vector(), end = 150.0f * vector();
        const Trace trace = world.trace(start, end, cube, mask_player_solid);
        const auto depth = [&](float fraction) {
            return depth_in(bsp, brush, place, start + fraction * (end - start), cube);
        };
        if (depth(0.0f) > -0.02f) continue;
        // Without bevels the planes alone say more than the brush; its bounds say it is far away.
        const Box way{glm::min(start, end) + cube.mins - 1.0f,
                      glm::max(start, end) + cube.maxs + 1.0f};
        if (!boxes_touch(world.bounds(0), way)) {
            EXPECT_EQ(trace.fraction, 1.0f);
            continue;
        }
        if (!boxes_touch(world.bounds(0), {way.mins + 1.5f, way.maxs - 1.5f})) continue;
        ASSERT_FALSE(trace.start_solid);
        for (int step = 0; step <= 100; ++step)
            ASSERT_LT(depth(trace.fraction * static_cast<float>(step) / 100.0f), 0.02f);
        if (trace.fraction == 1.0f) continue;
        ++hits;
        EXPECT_EQ(trace.owner, 7);
        EXPECT_GT(depth_in(bsp, brush, place, trace.end - 0.1f * trace.normal, cube), 0.0f);
    }
    EXPECT_GT(hits, 200);
}

TEST(Trace, ContentsOfPointsCountModelsWhereTheyStand) {
    BoxLevel level;
    level.flood(0, CONTENTS_WATER);
    const Bsp bsp = level.build();
    const CollisionWorld world(bsp);
    EXPECT_EQ(world.contents_at({0, 0, 1}), 0u);
    EXPECT_EQ(world.contents_at({0, 0, -1}), CONTENTS_WATER);
}

class LevelTraces : public testing::TestWithParam<std::filesystem::path> {};

/// Random ways through a compiled level: the tree must find what all brushes together say.
TEST_P(LevelTraces, AgreeWithAllBrushes) {
    const Bsp bsp = parse_bsp(GetParam().filename().string(), read_file(GetParam()));
    const CollisionWorld world(bsp);
    const std::vector<uint32_t> brushes = brushes_of(bsp, bsp.models[0]);
    std::vector<glm::vec3> places;
    for (const BspLeaf& leaf : bsp.leafs)
        if (leaf.cluster >= 0 && (leaf.contents & CONTENTS_SOLID) == 0)
            places.push_back(0.5f * (leaf.mins + leaf.maxs));
    std::mt19937 random(3);
    std::uniform_int_distribution<size_t> any(0, places.size() - 1);
    std::normal_distribution<float> normal;
    for (int i = 0; i < 80; ++i) {
        const glm::vec3 start = places[any(random)];
        const glm::vec3 way =
            100.0f * glm::vec3(normal(random), normal(random), 0.5f * normal(random));
        const Box box = i % 2 == 0 ? Box{{-16, -16, -24}, {16, 16, 32}} : Box{};
        expect_true(bsp, world.trace(start, start + way, box, mask_player_solid), start,
                    start + way, box, brushes);
        if (HasFatalFailure()) return;
    }
}

std::vector<std::filesystem::path> shipped_levels() {
    std::vector<std::filesystem::path> paths;
    for (const char* name : {"warehouse", "mine", "gallery", "ring", "yard", "room", "many_1000"})
        paths.push_back(std::filesystem::path(VIGIL_SOURCE_DIR) / "baseq2" / "maps" /
                        (std::string(name) + ".bsp"));
    return paths;
}

INSTANTIATE_TEST_SUITE_P(Shipped, LevelTraces, testing::ValuesIn(shipped_levels()),
                         [](const auto& level) { return level.param.stem().string(); });

TEST(Trace, AgreesWithAllBrushesOfRealLevels) {
    const auto folder = real_levels_folder();
    if (!folder) GTEST_SKIP() << "the real levels are not here";
    std::mt19937 random(4);
    std::normal_distribution<float> normal;
    for (const RealLevel& level : real_levels) {
        SCOPED_TRACE(level.name);
        const Bsp bsp = parse_bsp(level.name, read_file(*folder / "baseq2" / "maps" /
                                                        (std::string(level.name) + ".bsp")));
        const CollisionWorld world(bsp);
        const std::vector<uint32_t> brushes = brushes_of(bsp, bsp.models[0]);
        for (const Entity& entity : bsp.entities) {
            if (!entity.has("origin")) continue;
            const glm::vec3 start = entity.get_vec3("origin");
            const glm::vec3 end =
                start + 100.0f * glm::vec3(normal(random), normal(random), normal(random));
            const Box box{{-16, -16, -24}, {16, 16, 32}};
            expect_true(bsp, world.trace(start, end, box, mask_player_solid), start, end, box,
                        brushes);
            if (HasFatalFailure()) return;
        }
    }
}

} // namespace
} // namespace vigil
