// SPDX-License-Identifier: GPL-2.0-or-later
// A few whole frames of each light sampling technique, and of guided rays: small enough that
// GPU-assisted validation, under which drivers compile for minutes, gets through all of them.
#include "render_test.h"
#include "shared/views.h"

namespace vigil::test {
namespace {

class Frames : public RenderTest {
protected:
    /// Learns in two frames, if there is anything to learn, and looks at the third.
    void expect_finite() {
        load("lamp");
        Shot shot;
        shot.view = {{-192, 0, 64}, {40, 0, 0}, 80};
        learn(shot, 2);
        const refresh::RadiancePicture seen = radiance(shot);
        EXPECT_TRUE(all_finite_nonnegative(seen.rgb));
        EXPECT_GT(sum_of(seen.rgb), 0.0);
    }
};

class TechniqueFrames : public Frames, public testing::WithParamInterface<TechniqueInfo> {};

TEST_P(TechniqueFrames, AreSound) {
    set("pt_nee", GetParam().name);
    expect_finite();
}

INSTANTIATE_TEST_SUITE_P(All, TechniqueFrames, testing::ValuesIn(technique_infos),
                         [](const auto& given) { return std::string(given.param.name); });

TEST_F(Frames, Guided) {
    set("pt_nee", "vlc"); // as people play
    set("pt_guide", "cdq");
    expect_finite();
}

TEST_F(Frames, EveryView) {
    set("pt_nee", "brute");
    set("pt_guide", "cdq");
    for (const ViewInfo& info : view_infos) {
        SCOPED_TRACE(info.name);
        set("pt_view", info.name);
        expect_finite();
    }
}

TEST_F(Frames, EveryFeature) {
    set("pt_nee", "brute");
    set("pt_features", "all");
    expect_finite();
}

} // namespace
} // namespace vigil::test
