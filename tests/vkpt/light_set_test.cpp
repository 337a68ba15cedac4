// SPDX-License-Identifier: GPL-2.0-or-later
// Light ids: stable while a light exists, taken over when it is gone, never more than the most that
// existed at once; and the revisions that tell techniques when to look again.
#include "refresh/vkpt/scene/light_set.h"

#include "refresh/vkpt/scene/transform.h"

#include <gtest/gtest.h>
#include <map>
#include <random>
#include <set>

namespace vigil::vkpt {
namespace {

const std::vector<float> full_styles(256, 1.0f);

LightSource triangle(glm::vec3 radiance, int style = 0, float coverage = 1.0f) {
    return {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, radiance, coverage, style};
}

TEST(LightSet, WorldLightsComeFirstAndKeepTheirIds) {
    LightSet set({triangle({1, 2, 3}), triangle({4, 5, 6}, 0, 0.5f)});
    EXPECT_EQ(set.static_count(), 2u);
    set.begin_frame(full_styles, 1.0f);
    set.end_frame();
    ASSERT_EQ(set.lights().size(), 2u);
    EXPECT_EQ(set.lights()[0].radiance, glm::vec3(1, 2, 3));
    EXPECT_EQ(set.lights()[1].radiance, glm::vec3(2, 2.5, 3))
        << "a translucent lamp lets half of its own light through";
    EXPECT_EQ(set.lights()[0].e2, glm::vec3(0, 1, 0));
}

TEST(LightSet, StylesAndScaleDimAndOnlyThenChangeTheRevision) {
    LightSet set({triangle({1, 1, 1}, 3), triangle({1, 1, 1})});
    set.begin_frame(full_styles, 1.0f);
    set.end_frame();
    const uint64_t before = set.revision(), moving = set.moving_revision();
    const uint64_t places = set.place_revision();
    set.begin_frame(full_styles, 1.0f);
    set.end_frame();
    EXPECT_EQ(set.revision(), before);
    std::vector<float> styles = full_styles;
    styles[3] = 0.25f;
    set.begin_frame(styles, 2.0f);
    set.end_frame();
    EXPECT_GT(set.revision(), before);
    EXPECT_EQ(set.moving_revision(), moving) << "nothing moved";
    EXPECT_EQ(set.place_revision(), places) << "nothing appeared";
    EXPECT_EQ(set.lights()[0].radiance, glm::vec3(0.5f));
    EXPECT_EQ(set.lights()[1].radiance, glm::vec3(2.0f));
    styles[3] = 0.0f;
    set.begin_frame(styles, 2.0f);
    set.end_frame();
    EXPECT_GT(set.place_revision(), places) << "a light went out";
    EXPECT_EQ(set.moving_revision(), moving);
}

// Where caches know a light already, all frames need not teach.
TEST(LightSet, APlaceIsNewOnlyAfterADarkSpell) {
    LightSet set({triangle({1, 1, 1}, 3), triangle({1, 1, 1}, 4)});
    std::vector<float> styles = full_styles;
    const auto is_new = [&](int style, float brightness) {
        styles[static_cast<size_t>(style)] = brightness;
        const uint64_t before = set.place_revision();
        set.begin_frame(styles, 1.0f);
        set.end_frame();
        return set.place_revision() != before;
    };
    EXPECT_TRUE(is_new(3, 1.0f)) << "the level begins";
    EXPECT_TRUE(is_new(3, 0.0f)) << "the first time";
    for (int i = 0; i < 10; ++i) {
        EXPECT_FALSE(is_new(3, 1.0f)) << i;
        EXPECT_FALSE(is_new(3, 0.0f)) << i;
    }
    const uint64_t appeared = set.new_revision();
    EXPECT_TRUE(is_new(4, 0.0f)) << "another light went out";
    EXPECT_EQ(set.new_revision(), appeared);
    for (uint64_t frame = 3; frame < flicker_frames; ++frame)
        EXPECT_FALSE(is_new(3, 0.0f)) << frame;
    EXPECT_FALSE(is_new(3, 1.0f)) << "dark for less than " << flicker_frames;
    EXPECT_FALSE(is_new(4, 0.0f));
    EXPECT_EQ(set.new_revision(), appeared);
    EXPECT_TRUE(is_new(4, 1.0f)) << "dark for " << flicker_frames;
    EXPECT_GT(set.new_revision(), appeared);
    EXPECT_TRUE(is_new(3, 0.0f)) << "lit since, and out " << flicker_frames << " ago";
}

TEST(LightSet, PlacedLightsMoveWithTheirModel) {
    LightSet set;
    const std::vector<LightSource> sources{triangle({1, 0, 0})};
    const auto place = [&](glm::vec3 origin, glm::vec3 angles) {
        set.begin_frame(full_styles, 1.0f);
        const uint32_t id =
            set.place(5, sources, rigid_transform(origin, angles), {2, 2, 2}).value();
        set.end_frame();
        return id;
    };
    const uint32_t id = place({10, 20, 30}, {0, 90, 0});
    EXPECT_EQ(set.lights()[id].v0, glm::vec3(10, 20, 30));
    EXPECT_NEAR(glm::distance(set.lights()[id].e1, glm::vec3(0, 1, 0)), 0.0f, 1e-6f);
    EXPECT_NEAR(glm::distance(set.lights()[id].e2, glm::vec3(-1, 0, 0)), 0.0f, 1e-6f);
    EXPECT_EQ(set.lights()[id].radiance, glm::vec3(2, 0, 0));
    const uint64_t moving = set.moving_revision(), all = set.revision();
    const uint64_t places = set.place_revision();
    EXPECT_EQ(place({10, 20, 30}, {0, 90, 0}), id);
    EXPECT_EQ(set.moving_revision(), moving);
    EXPECT_EQ(set.place_revision(), places);
    EXPECT_EQ(set.revision(), all);
    EXPECT_EQ(place({11, 20, 30}, {0, 90, 0}), id);
    EXPECT_GT(set.moving_revision(), moving);
    EXPECT_GT(set.place_revision(), places);
}

// Lists hold the lit lights alone.
TEST(LightSet, EntitiesThatFlickerAreListedAgain) {
    LightSet set;
    const std::vector<LightSource> sources{triangle({1, 0, 0})};
    for (int frame = 0; frame < 10; ++frame) {
        const uint64_t moving = set.moving_revision();
        set.begin_frame(full_styles, 1.0f);
        set.place(5, sources, glm::mat4x3(1.0f), glm::vec3(frame % 2 == 0 ? 1.0f : 0.0f));
        set.end_frame();
        EXPECT_GT(set.moving_revision(), moving) << frame;
    }
}

TEST(LightSet, VanishedLightsAreDarkAndTheirSlotsTakenOver) {
    LightSet set({triangle({1, 1, 1})});
    const std::vector<LightSource> two(2, triangle({1, 1, 1})), three(3, triangle({1, 1, 1}));
    const glm::mat4x3 identity(1.0f);
    set.begin_frame(full_styles, 1.0f);
    const uint32_t first = set.place(1, two, identity, glm::vec3(1.0f)).value();
    EXPECT_EQ(first, 1u);
    EXPECT_EQ(set.place(2, three, identity, glm::vec3(1.0f)), 3u);
    set.end_frame();
    set.begin_frame(full_styles, 1.0f);
    EXPECT_EQ(set.place(2, three, identity, glm::vec3(1.0f)), 3u);
    const uint64_t moving = set.moving_revision(), places = set.place_revision();
    set.end_frame();
    EXPECT_GT(set.moving_revision(), moving);
    EXPECT_GT(set.place_revision(), places);
    EXPECT_EQ(set.lights()[first].radiance, glm::vec3(0.0f));
    EXPECT_EQ(set.lights()[first + 1].radiance, glm::vec3(0.0f));
    EXPECT_NE(set.lights()[3].radiance, glm::vec3(0.0f));
    set.begin_frame(full_styles, 1.0f);
    EXPECT_EQ(set.place(9, two, identity, glm::vec3(1.0f)), first);
    EXPECT_EQ(set.place(2, three, identity, glm::vec3(1.0f)), 3u);
    set.end_frame();
    EXPECT_EQ(set.lights().size(), 6u);
}

// It is no flicker of the one before.
TEST(LightSet, ALightInTheSlotOfOneThatWentOutIsNew) {
    LightSet set;
    const std::vector<LightSource> sources{triangle({1, 0, 0})};
    const auto show = [&](uint64_t key, float tint) {
        set.begin_frame(full_styles, 1.0f);
        EXPECT_EQ(set.place(key, sources, glm::mat4x3(1.0f), glm::vec3(tint)), 0u);
        set.end_frame();
    };
    show(1, 1.0f);
    show(1, 0.0f);
    set.begin_frame(full_styles, 1.0f);
    set.end_frame();
    const uint64_t before = set.new_revision();
    show(2, 1.0f);
    EXPECT_GT(set.new_revision(), before);
}

TEST(LightSet, AnEntityThatChangesItsModelLeavesNoLightBehind) {
    LightSet set;
    const std::vector<LightSource> two(2, triangle({1, 1, 1})), three(3, triangle({1, 1, 1}));
    const glm::mat4x3 identity(1.0f);
    set.begin_frame(full_styles, 1.0f);
    set.place(1, three, identity, glm::vec3(1.0f));
    set.end_frame();
    set.begin_frame(full_styles, 1.0f);
    const uint32_t first = set.place(1, two, identity, glm::vec3(1.0f)).value();
    set.end_frame();
    for (uint32_t id = 0; id < set.lights().size(); ++id)
        EXPECT_EQ(set.lights()[id].radiance != glm::vec3(0.0f), id >= first && id < first + 2)
            << id;
}

TEST(LightSet, TwoHundredLightsComeAndGoWithoutLosingSlots) {
    LightSet set({triangle({1, 1, 1})});
    const std::vector<LightSource> octahedron = dynamic_light_geometry(0).lights;
    ASSERT_EQ(octahedron.size(), dynamic_light_triangles);
    std::mt19937 random(1);
    std::map<uint64_t, uint32_t> ids; // of what existed in the frame before
    for (int frame = 0; frame < 200; ++frame) {
        std::map<uint64_t, uint32_t> now;
        std::set<uint32_t> used;
        set.begin_frame(full_styles, 1.0f);
        for (uint64_t key = 0; key < 200; ++key) {
            if (random() % 3 == 0) continue;
            const glm::vec3 origin(static_cast<float>(random() % 100));
            const uint32_t first =
                set.place(key, octahedron, scale_transform(origin, 2.0f), glm::vec3(1.0f)).value();
            const auto before = ids.find(key);
            if (before != ids.end()) {
                ASSERT_EQ(before->second, first);
            }
            ASSERT_TRUE(used.insert(first).second) << "two lights share ids";
            ASSERT_EQ((first - 1) % dynamic_light_triangles, 0u);
            now[key] = first;
        }
        set.end_frame();
        // New lights take slots of lights that vanished a frame before, so up to 200 live and 200
        // stale slots exist.
        ASSERT_LE(set.lights().size(), 1 + 2 * 200 * dynamic_light_triangles);
        size_t lit = 0;
        for (const shader::Light& light : set.lights())
            lit += light.radiance != glm::vec3(0.0f) ? 1 : 0;
        ASSERT_EQ(lit, 1 + now.size() * dynamic_light_triangles);
        ids = std::move(now);
    }
    size_t size = 0;
    for (int frame = 0; frame < 50; ++frame) { // nothing grows while nothing new comes
        set.begin_frame(full_styles, 1.0f);
        for (uint64_t key = 0; key < 150; ++key)
            set.place(1000 + key, octahedron, glm::mat4x3(1.0f), glm::vec3(1.0f));
        set.end_frame();
        if (frame == 0) size = set.lights().size();
        ASSERT_EQ(set.lights().size(), size);
    }
}

// A level of a megabyte may place a model of many lights ten thousand times.
TEST(LightSet, HoldsNoMoreMovingLightsThanItsLimit) {
    const std::vector<LightSource> model(max_moving_lights / 4 + 1, triangle({1, 1, 1}));
    const std::vector<LightSource> small(1, triangle({1, 1, 1}));
    LightSet set({triangle({1, 1, 1})});
    const glm::mat4x3 identity(1.0f);
    const auto place = [&](uint64_t key, std::span<const LightSource> sources) {
        return set.place(key, sources, identity, glm::vec3(1.0f));
    };
    for (int frame = 0; frame < 2; ++frame) { // the same models find room each time
        set.begin_frame(full_styles, 1.0f);
        for (uint64_t key = 0; key < 3; ++key)
            EXPECT_EQ(place(key, model), 1 + key * model.size());
        for (uint64_t key = 3; key < 10; ++key)
            EXPECT_EQ(place(key, model), std::nullopt);
        EXPECT_TRUE(place(10, small)) << "smaller ones still fit";
        set.end_frame();
        EXPECT_EQ(set.lights().size(), 2 + 3 * model.size());
    }
}

TEST(DynamicLight, IsAClosedOctahedronWoundOutwards) {
    const ModelGeometry geometry = dynamic_light_geometry(7);
    ASSERT_EQ(geometry.triangles.size(), size_t{dynamic_light_triangles});
    glm::vec3 total(0.0f);
    for (size_t i = 0; i < geometry.triangles.size(); ++i) {
        const BvhInputTriangle& t = geometry.triangles[i];
        const glm::vec3 area = 0.5f * glm::cross(t.v1 - t.v0, t.v2 - t.v0);
        EXPECT_GT(glm::dot(area, t.v0 + t.v1 + t.v2), 0.0f) << i;
        EXPECT_NEAR(glm::length(area), std::sqrt(3.0f) / 2.0f, 1e-6f);
        total += area;
        EXPECT_EQ(geometry.primitives[i].light, i);
        EXPECT_EQ(geometry.primitives[i].material, 7u);
        const LightSource& light = geometry.lights[i];
        EXPECT_TRUE(light.v0 == t.v0 && light.v1 == t.v1 && light.v2 == t.v2);
    }
    EXPECT_EQ(total, glm::vec3(0.0f));
}

} // namespace
} // namespace vigil::vkpt
