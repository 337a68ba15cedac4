// SPDX-License-Identifier: GPL-2.0-or-later
// How many draws should look for lights in lists: the share that gives the least noise, by search,
// from what the draws of a leaf found.
#include "shared/guiding_types.h"

#include <cmath>
#include <gtest/gtest.h>

namespace vigil::shader {
namespace {

constexpr float drawn = 199.0f; // from the cache

/// Lights as a leaf sees them, per draw.
struct Leaf {
    double cached;     // C: what the lights of its cache shine
    double seen_share; // s: how many of the cache's lights are seen
    double others;     // M: second moment of the others, drawn from lists alone
};

/// The second moment of all draws if lists get a part of them (see ExploreMemory).
double second_moment(const Leaf& leaf, double lists) {
    return leaf.cached * leaf.cached / ((1.0 - lists) * leaf.seen_share) + leaf.others / lists;
}

double best_share(const Leaf& leaf) {
    double low = 1e-6, high = 1.0 - 1e-6;
    for (int i = 0; i < 200; ++i) { // a convex function
        const double a = low + (high - low) / 3.0, b = high - (high - low) / 3.0;
        if (second_moment(leaf, a) < second_moment(leaf, b))
            high = b;
        else
            low = a;
    }
    return 0.5 * (low + high);
}

/// The memory after a frame with `listed` draws from lists.
ExploreMemory after_frame(const ExploreMemory& memory, const Leaf& leaf, float listed) {
    const double estimate = leaf.cached / leaf.seen_share; // of those draws whose light is seen
    return explore_update(memory, listed, listed * static_cast<float>(leaf.others), drawn,
                          drawn * static_cast<float>(leaf.seen_share * estimate * estimate));
}

TEST(ExploreShare, IsTheOneOfLeastNoise) {
    for (const double cached : {0.01, 1.0, 300.0})
        for (const double seen_share : {0.1, 0.5, 1.0})
            for (const double odds : {0.01, 0.3, 1.0, 4.0}) {
                const double root = odds * cached;
                const Leaf leaf{cached, seen_share, root * root / seen_share};
                const ExploreMemory memory = after_frame({}, leaf, EXPLORE_DRAWS);
                EXPECT_NEAR(static_cast<double>(memory.share), best_share(leaf), 1e-4)
                    << cached << " " << seen_share << " " << odds;
            }
}

TEST(ExploreShare, IsTheSameHoweverManyDrawsThereAre) {
    const Leaf leaf{2.0, 0.5, 1.5};
    for (const float listed : {1.0f, 12.0f, 48.0f, 1000.0f}) {
        ExploreMemory memory{};
        for (int frame = 0; frame < 400; ++frame)
            memory = after_frame(memory, leaf, listed);
        EXPECT_NEAR(static_cast<double>(memory.share), best_share(leaf), 1e-4) << listed;
        // Sums are over the last hundred draws or so, at most.
        EXPECT_NEAR(memory.listed, std::max(EXPLORE_DRAWS, listed), 1e-3f * memory.listed);
    }
}

TEST(ExploreShare, NothingFoundIsNotLookedFor) {
    EXPECT_EQ(after_frame({}, {1.0, 0.5, 0.0}, 48.0f).share, 0.0f);
    // Where the cache holds nothing that shines, nearly all draws look for lights.
    EXPECT_FLOAT_EQ(explore_update({}, 48.0f, 100.0f, drawn, 0.0f).share, EXPLORE_MOST);
    // A frame without draws from the cache does not tell what the next one's lacks.
    const ExploreMemory before = after_frame({}, {1.0, 0.5, 2.0}, 48.0f);
    const ExploreMemory after = explore_update(before, 48.0f, 100.0f, 0.0f, 0.0f);
    EXPECT_EQ(after.share, 0.0f);
    EXPECT_EQ(after.listed, 0.0f);
    // One without any draws changes nothing.
    const ExploreMemory same = explore_update(before, 0.0f, 0.0f, 0.0f, 0.0f);
    EXPECT_EQ(same.share, before.share);
    EXPECT_EQ(same.found, before.found);
}

TEST(ExploreShare, DarknessIsRemembered) {
    ExploreMemory memory{};
    for (int frame = 0; frame < 20; ++frame)
        memory = explore_update(memory, 12.0f, 0.0f, 0.0f, 0.0f);
    EXPECT_GT(memory.listed, 0.9f * EXPLORE_DRAWS);
    EXPECT_EQ(memory.found, 0.0f);
}

} // namespace
} // namespace vigil::shader
