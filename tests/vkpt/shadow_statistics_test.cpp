// SPDX-License-Identifier: GPL-2.0-or-later
// What light lists learn about shadows (pt_sll_stats): fewer shadow rays are wasted, a frame does
// not read what it writes, what is known outlives lights that come and go, and is forgotten when
// asked.
#include "refresh/vkpt/gpu/commands.h"
#include "refresh/vkpt/light/shadow_statistics.h"
#include "render_test.h"

#include <bit>
#include <cmath>
#include <fmt/format.h>
#include <iostream>

namespace vigil::test {
namespace {

class ShadowStatistics : public RenderTest {
protected:
    void SetUp() override {
        RenderTest::SetUp();
        set_size(96, 64);
        set("pt_nee", "sll");
        set("pt_sll_max", "64"); // no stride: what is left is the choice
        load("rooms");
        shot_.view = {{290, 20, 96}, {5, 55, 0}, 90};
    }

    /// Share of the last frame's light samples at primary hits that added nothing.
    static double wasted() {
        const std::vector<shader::PrimaryHit> surfaces = primary_hits();
        const std::vector<uint32_t> flags = pixel_flags();
        double hits = 0.0, unlit = 0.0;
        for (size_t i = 0; i < surfaces.size(); ++i) {
            if (surfaces[i].primitive == shader::NONE) continue;
            hits += 1.0;
            unlit += (flags[i] & shader::PIXEL_UNLIT) != 0 ? 1.0 : 0.0;
        }
        return unlit / hits;
    }
    double wasted_after(int frames) {
        for (int i = 0; i < frames; ++i)
            renderer().render(shot_.frame());
        return wasted();
    }

    Shot shot_;
};

/// Standard errors of a share of the 6,144 hits, at most.
constexpr double share_error = 0.5 / 78.4;

TEST_F(ShadowStatistics, WasteFewerRays) {
    const double before = wasted_after(4);
    set("pt_sll_stats", "1");
    const double first = wasted_after(1), learned = wasted_after(8);
    std::cout << fmt::format("wasted: {:.1f}%, first frame {:.1f}%, then {:.1f}%\n", 100 * before,
                             100 * first, 100 * learned);
    EXPECT_LT(std::abs(first - before), score_limit * std::sqrt(2.0) * share_error);
    EXPECT_LT(learned, before - 10 * share_error);
    // Forgotten: the next frame knows nothing.
    renderer().reset_guiding();
    EXPECT_LT(std::abs(wasted_after(1) - before), score_limit * std::sqrt(2.0) * share_error);
    // So it is when it was off for a while.
    EXPECT_LT(wasted_after(8), before - 10 * share_error);
    set("pt_sll_stats", "0");
    wasted_after(1);
    set("pt_sll_stats", "1");
    EXPECT_LT(std::abs(wasted_after(1) - before), score_limit * std::sqrt(2.0) * share_error);
}

TEST_F(ShadowStatistics, AreNotReadInTheFrameThatWritesThem) {
    set("pt_sll_stats", "1");
    learn(shot_, frames_to_learn);
    const std::vector<float> first = trace(params(shot_), 2);
    EXPECT_EQ(trace(params(shot_), 2), first);
    // They are in the next.
    gpu::FrameCommands commands(renderer().device());
    adapt(commands);
    EXPECT_NE(trace(params(shot_), 2), first);
}

TEST_F(ShadowStatistics, OutliveLightsThatComeAndGo) {
    // A light that is too dark to matter, far from all: it changes the lists, not the choice.
    const refresh::DynamicLight faint{5, {40, 40, 60}, 1.0f, glm::vec3(1e-6f)};
    const double before = wasted_after(4);
    set("pt_sll_stats", "1");
    const double learned = wasted_after(8);
    for (int frame = 0; frame < 4; ++frame) {
        shot_.dynamic_lights.clear();
        if (frame % 2 == 0) shot_.dynamic_lights = {faint};
        const double now = wasted_after(1);
        EXPECT_LT(now, before - 8 * share_error) << frame;
        EXPECT_LT(std::abs(now - learned), score_limit * std::sqrt(2.0) * share_error) << frame;
    }
}

TEST_F(ShadowStatistics, TablesFollowTheListsWithinBounds) {
    using vkpt::ShadowStatistics;
    EXPECT_EQ(ShadowStatistics::slots_for(0), 4096u);
    EXPECT_GE(ShadowStatistics::slots_for(10000), 6u * 10000u);
    EXPECT_EQ(ShadowStatistics::slots_for(uint64_t{1} << 40), 1u << 21);
    for (uint64_t pairs = 1; pairs < 1000000; pairs *= 3)
        EXPECT_TRUE(std::has_single_bit(ShadowStatistics::slots_for(pairs)));
}

} // namespace
} // namespace vigil::test
