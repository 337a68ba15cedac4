// SPDX-License-Identifier: GPL-2.0-or-later
// Turns at indirect light: who has one, and that nobody is left out.
#include "shared/indirect_turn.h"

#include <gtest/gtest.h>

#include <set>
#include <utility>

namespace vigil::shader {
namespace {

TEST(IndirectTurn, InvocationsAreThePixelsWhoseTurnItIs) {
    for (const uint turn : {INDIRECT_ALL, INDIRECT_EVEN, INDIRECT_ODD}) {
        const uint rows = turn == INDIRECT_ALL ? 16 : 8;
        std::set<std::pair<uint, uint>> traced;
        for (uint y = 0; y < rows; ++y)
            for (uint x = 0; x < 8; ++x) {
                const uvec2 pixel = indirect_pixel({x, y}, turn);
                EXPECT_TRUE(traced.insert({pixel.x, pixel.y}).second) << "once each";
            }
        for (uint y = 0; y < 16; ++y)
            for (uint x = 0; x < 8; ++x)
                EXPECT_EQ(has_indirect_turn({x, y}, turn), traced.contains({x, y}));
    }
}

TEST(IndirectTurn, NeighboursTakeTurns) {
    for (const uint turn : {INDIRECT_EVEN, INDIRECT_ODD}) {
        EXPECT_NE(has_indirect_turn({4, 7}, turn), has_indirect_turn({5, 7}, turn));
        EXPECT_NE(has_indirect_turn({4, 7}, turn), has_indirect_turn({4, 8}, turn));
    }
    EXPECT_NE(has_indirect_turn({4, 7}, INDIRECT_EVEN), has_indirect_turn({4, 7}, INDIRECT_ODD));
}

TEST(IndirectTurn, EveryPixelSeesEveryPointOnce) {
    constexpr uint points = 16;
    for (const uvec2 pixel : {uvec2(0, 0), uvec2(3, 8)}) {
        std::multiset<uint> seen;
        for (uint frame = 0; frame < 2 * points; ++frame)
            if (has_indirect_turn(pixel, indirect_turn_of_frame(frame, points)))
                seen.insert(frame % points);
        EXPECT_EQ(seen.size(), points);
        for (uint point = 0; point < points; ++point)
            EXPECT_EQ(seen.count(point), 1u);
    }
}

} // namespace
} // namespace vigil::shader
