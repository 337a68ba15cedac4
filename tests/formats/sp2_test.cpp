// SPDX-License-Identifier: GPL-2.0-or-later
// SP2 on a hand-made sprite, and every kind of refusal.
#include "fault.h"
#include "formats/sp2.h"
#include "small_models.h"

namespace vigil {
namespace {

TEST(Sp2, FramesArrive) {
    const std::vector<Sp2Frame> frames = parse_sp2("x.sp2", small_sp2());
    ASSERT_EQ(frames.size(), 2u);
    EXPECT_EQ(frames[0].size, glm::ivec2(32, 24));
    EXPECT_EQ(frames[0].origin, glm::ivec2(8, -4));
    EXPECT_EQ(frames[0].picture, "sprites/a.tga");
    EXPECT_EQ(frames[1].picture, "sprites/b.tga");
}

TEST(Sp2, DamageIsNamed) {
    const auto refuse = [](size_t at, auto value, std::string_view part) {
        Bytes file = small_sp2();
        patch(file, at, value);
        expect_fault("x.sp2", part, [&] { parse_sp2("x.sp2", file); });
    };
    refuse(0, uint8_t{'X'}, "no IDS2 signature");
    refuse(4, uint32_t{3}, "SP2 version 3");
    refuse(8, uint32_t{0}, "no frames");
    refuse(8, uint32_t{3}, "3 frames do not fit");
    refuse(8, uint32_t{0xffffffff}, "4294967295 frames do not fit");
    refuse(12, int32_t{0}, "frame 0 is 0 x 24 units");
    refuse(92 + 4, int32_t{-1}, "frame 1 is 8 x -1 units");
    refuse(92 + 4, int32_t{65537}, "frame 1 is 8 x 65537 units");
    refuse(92 + 12, int32_t{-65537}, "frame 1 has its origin at 4 -65537");
    expect_fault("x.sp2", "ends after", [] { parse_sp2("x.sp2", Bytes(3, 1)); });
}

} // namespace
} // namespace vigil
