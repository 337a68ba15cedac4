// SPDX-License-Identifier: GPL-2.0-or-later
// Many frames in a row, with samples placed where surfaces are, as the path tracer does: trees grow
// towards the samples, follow them, come to rest, and agree with the oracle all the way.
#include "guiding_fixture.h"
#include "numerics/record.h"
#include "refresh/vkpt/gpu/commands.h"
#include "shared/octree.h"

#include <functional>
#include <limits>

namespace vigil::test {
namespace {

class GuidingFrames : public GuidingTest {
protected:
    using Surface = std::function<glm::vec3(Dice&)>;

    /// Frames with samples at random points of a surface. Each stretch of 100 map units sees lights
    /// of its own.
    void frames(int count, int samples, const Surface& surface) {
        for (int i = 0; i < count && !HasFatalFailure(); ++i) {
            for (int s = 0; s < samples; ++s) {
                const glm::vec3 position = surface(dice_);
                const uint32_t region = cell_of(position).x >> 9;
                place(position, random_light_sample(dice_, {}, 20 * region + 40, 40));
            }
            frame();
        }
    }

    Dice dice_{21};
};

/// The floor around a place.
glm::vec3 floor_at(Dice& dice, glm::vec3 centre) {
    return centre + glm::vec3(dice.between(-300, 300), dice.between(-300, 300), 0.0f);
}

TEST_F(GuidingFrames, TreesFollowTheSamples) {
    start(settings_with(16), 128);
    const glm::vec3 first(100.0f, 50.0f, -10.0f);
    const glm::vec3 second(-3000.0f, 2500.0f, 900.0f);
    const auto depth_at = [&](glm::vec3 position) {
        return leaf_with(state_.inner, glm::ivec3(cell_of(position))).value().size();
    };
    for (int round = 0; round < 2; ++round) {
        const glm::vec3 here = round == 0 ? first : second;
        const glm::vec3 elsewhere = round == 0 ? second : first;
        frames(14, 8000, [&](Dice& dice) { return floor_at(dice, here); });
        if (HasFatalFailure()) return;
        EXPECT_GT(state_.inner.size(), 100u);
        EXPECT_GT(depth_at(here), 6u);
        EXPECT_LT(depth_at(elsewhere), 4u);
    }
}

// Before the first frame there are no samples to follow, but places that expect them. The first
// frame has the leaves, and room for its samples in them.
TEST_F(GuidingFrames, TheFirstTreeFollowsThePlaces) {
    // A pixel's surface: equal angles see more of what is far. Two samples for each pixel.
    const auto seen = [](Dice& dice) {
        const glm::vec3 eye(100.0f, 50.0f, 54.0f);
        while (true) {
            const glm::vec3 position(dice.between(-2040, 2040), dice.between(-2040, 2040), -10.0f);
            const glm::vec3 to_eye = eye - position;
            if (dice.chance(64.0 * 64.0 / static_cast<double>(glm::dot(to_eye, to_eye))))
                return position;
        }
    };
    Dice dice(17);
    std::vector<glm::vec3> places;
    for (int i = 0; i < 1 << 14; ++i)
        places.push_back(seen(dice));
    start_with(settings_with(16), places, 128);
    if (HasFatalFailure()) return;
    const auto depth_at = [&](glm::vec3 position) {
        return leaf_with(state_.inner, glm::ivec3(cell_of(position))).value().size();
    };
    EXPECT_GT(state_.inner.size(), 200u);
    EXPECT_GT(depth_at({100.0f, 50.0f, -10.0f}), depth_at({1900.0f, 1900.0f, -10.0f}) + 2);
    EXPECT_EQ(statistics_.nodes, state_.inner.size());
    EXPECT_EQ(statistics_.splits + statistics_.collapses, 0u);

    frames(1, 2 * 128 * 128, seen);
    EXPECT_LT(statistics_.dropped, 2 * 128 * 128 / 8);
    EXPECT_LT(statistics_.splits, state_.inner.size() / 4);
    frames(3, 2 * 128 * 128, seen);
}

TEST_F(GuidingFrames, AllSamplesAtOnePointEndAtTheDeepestLevel) {
    start(settings_with(32), 128);
    frames(20, 500, [](Dice&) { return glm::vec3(17.3f, -1000.1f, 333.3f); });
    EXPECT_EQ(statistics_.depth, shader::OCTREE_MAX_DEPTH);
    EXPECT_EQ(state_.inner.size(), shader::OCTREE_MAX_DEPTH);
    EXPECT_EQ(tree_.splits + tree_.splits_refused + tree_.collapses, 0u);
    EXPECT_EQ(statistics_.sampled_leaves, 1u);
    record("octree", "all samples at one point, frame after frame",
           "one chain of nodes to the deepest level, and no further");
}

TEST_F(GuidingFrames, CellBordersAndPlacesFarOutside) {
    start(settings_with(32), 128);
    const float inf = std::numeric_limits<float>::infinity();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    frames(12, 4000, [&](Dice& dice) {
        const glm::vec3 border =
            256.0f * glm::vec3(glm::ivec3(dice.between(-16, 17), dice.between(-16, 17),
                                          dice.between(-8, 25)));
        switch (dice.below(8)) {
        case 0:
            return glm::vec3(1e30f, -1e30f, 0.0f);
        case 1:
            return glm::vec3(inf, border.y, -inf);
        case 2:
            return glm::vec3(border.x, nan, 1e9f);
        case 3: // beyond one face
            return glm::vec3(border.x, border.y, 10000.0f);
        default:
            return border;
        }
    });
    EXPECT_GT(state_.inner.size(), 50u);
    record("octree", "positions on cell borders, far outside, infinite, NaN",
           "octree and caches of the plain implementation");
}

TEST_F(GuidingFrames, EverySampleHasRoomOnceTheTreeIsAtRest) {
    start(settings_with(32), 128);
    const auto wall = [](Dice& dice) {
        return glm::vec3(dice.between(0, 800), 77.0f, dice.between(0, 200));
    };
    frames(14, 128 * 128, wall);
    if (HasFatalFailure()) return;
    EXPECT_LT(statistics_.dropped, statistics_.samples / 100);
}

TEST_F(GuidingFrames, SettingsChangeBetweenFrames) {
    start(settings_with(32), 128);
    const auto here = [](Dice& dice) { return floor_at(dice, glm::vec3(0.0f)); };
    frames(8, 6000, here);
    for (const uint32_t small_bucket : {1u, 32u, 24u}) {
        settings_.small_bucket = small_bucket;
        settings_.merge_faces = 0x3f - settings_.merge_faces;
        settings_.split += 7;
        settings_.persist = small_bucket / 4;
        ASSERT_FALSE(guiding().prepare({glm::uvec2(128), settings_}));
        frames(2, 6000, here);
    }
}

TEST_F(GuidingFrames, FramesInFlight) {
    start(settings_with(32, 3), 128);
    const auto here = [](Dice& dice) { return floor_at(dice, glm::vec3(0.0f)); };
    for (int i = 0; i < 8; ++i) {
        frames(3, 8000, here);
        if (HasFatalFailure()) return;
        for (int s = 0; s < 3000; ++s)
            place(here(dice_), random_light_sample(dice_, {}, 100, 40));
        two_frames_in_flight();
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(state_.inner.size(), 10u);
}

TEST_F(GuidingFrames, LightsStayWhileTheTreeChanges) {
    start(settings_with(16, 4), 128);
    for (const float x : {0.0f, 50.0f, 2000.0f}) {
        for (int i = 0; i < 8; ++i) {
            // Lower and upper neighbours take turns.
            settings_.merge_faces = i % 2 == 0 ? 0b010101 : 0b101010;
            ASSERT_FALSE(guiding().prepare({glm::uvec2(128), settings_}));
            frames(1, 3000, [&](Dice& dice) { return floor_at(dice, {x, 0.0f, 0.0f}); });
            if (HasFatalFailure()) return;
        }
        uint32_t oldest = 0;
        for (const auto& [path, cache] : caches_.by_leaf)
            for (const auto& [light, age] : cache.ages)
                oldest = std::max(oldest, age);
        EXPECT_EQ(oldest, 4u);
    }
}

TEST_F(GuidingFrames, AnotherBucketSizeStartsAnew) {
    start(settings_with(16, 4), 128);
    frames(6, 6000, [](Dice& dice) { return floor_at(dice, glm::vec3(0.0f)); });
    if (HasFatalFailure()) return;
    ASSERT_GT(state_.inner.size(), 9u);
    start_anew(settings_with(24, 4));
}

TEST_F(GuidingFrames, RestartForgetsEverything) {
    start(settings_with(32), 128);
    frames(8, 6000, [](Dice& dice) { return floor_at(dice, glm::vec3(0.0f)); });
    if (HasFatalFailure()) return;
    ASSERT_GT(state_.inner.size(), 50u);
    ASSERT_GT(statistics_.cached_leaves, 0u);
    start(settings_with(32), 128); // expects eight leaves without caches
    // From the other one of both trees, too.
    frames(1, 6000, [](Dice& dice) { return floor_at(dice, glm::vec3(0.0f)); });
    start(settings_with(32), 128);
    start(settings_with(32), 64); // other buffers
    frames(3, 2000, [](Dice& dice) { return floor_at(dice, glm::vec3(0.0f)); });
}

} // namespace
} // namespace vigil::test
