// SPDX-License-Identifier: GPL-2.0-or-later
// Shadow statistics: sides of the world, what a light loses, how counts are forgotten, and how
// evenly keys fill the table.
#include "shared/shadow_statistics.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <set>
#include <vector>

namespace vigil::shader {
namespace {

TEST(ShadowStatistics, SixSidesOfTheWorld) {
    std::set<uint> seen;
    for (int axis = 0; axis < 3; ++axis) {
        for (const float sign : {1.0f, -1.0f}) {
            vec3 normal(0.2f, -0.3f, 0.1f);
            normal[axis] = sign * 2.0f;
            const uint direction = dominant_direction(normalize(normal));
            EXPECT_EQ(direction, 2u * static_cast<uint>(axis) + (sign < 0.0f ? 1u : 0u));
            seen.insert(direction);
        }
    }
    EXPECT_EQ(seen.size(), 6u);
}

TEST(ShadowStatistics, LossIsTheShareOfShadowedRays) {
    EXPECT_EQ(shadow_loss(0, 0), 0.0f) << "nothing is known";
    EXPECT_EQ(shadow_loss(3 * SHADOW_RAY, 0), 0.0f);
    EXPECT_FLOAT_EQ(shadow_loss(3 * SHADOW_RAY, SHADOW_RAY), 0.25f);
    EXPECT_EQ(shadow_loss(0, SHADOW_RAY), SHADOW_MOST_LOSS);
    EXPECT_EQ(shadow_loss(1, 0xffffffffu), SHADOW_MOST_LOSS) << "never out of reach";
}

TEST(ShadowStatistics, RaysAreForgotten) {
    uint count = SHADOW_RAY;
    for (int frame = 1; frame <= 4; ++frame) {
        const uint before = count;
        count = fade_shadow_count(count);
        EXPECT_LE(count, before * 3 / 4);
        EXPECT_GE(count + 1, before * 3 / 4);
    }
    EXPECT_GT(count, 0u);
    for (int frame = 5; frame <= 16; ++frame)
        count = fade_shadow_count(count);
    EXPECT_EQ(count, 0u);
    EXPECT_LT(fade_shadow_count(0xffffffffu), 0xc0000000u) << "no overflow";
}

TEST(ShadowStatistics, KeysSpreadOverTheTable) {
    // Neighbouring clusters, lights and directions, as many as there are slots: Poisson leaves 1 /
    // e of the slots empty.
    constexpr uint slots = 1 << 14;
    std::vector<uint> filled(slots, 0);
    uint keys = 0;
    for (uint cluster = 0; cluster < 32; ++cluster)
        for (uint light = 0; keys < slots && light < 86; ++light)
            for (uint direction = 0; keys < slots && direction < 6; ++direction, ++keys)
                ++filled[shadow_slot(cluster, light, direction, slots)];
    ASSERT_EQ(keys, slots);
    const auto empty = static_cast<double>(std::count(filled.begin(), filled.end(), 0u));
    EXPECT_NEAR(empty / slots, std::exp(-1.0), 0.01);
    // Words of different slots are different words.
    std::set<uint> words;
    for (uint slot = 0; slot < 64; ++slot) {
        words.insert(shadow_loss_word(slot));
        words.insert(shadow_count_word(slot, 64, false));
        words.insert(shadow_count_word(slot, 64, true));
    }
    EXPECT_EQ(words.size(), 64u * SHADOW_SLOT_WORDS);
    EXPECT_EQ(*words.rbegin() + 1, 64u * SHADOW_SLOT_WORDS);
}

} // namespace
} // namespace vigil::shader
