// SPDX-License-Identifier: GPL-2.0-or-later
// Two techniques in one picture (pt_compare): each side is what the technique draws by itself,
// wherever the line is.
#include "render_test.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <fmt/format.h>

namespace vigil::test {
namespace {

constexpr int width = 48, height = 32;

class Compare : public RenderTest {
protected:
    void SetUp() override {
        RenderTest::SetUp();
        shot_.view = {{290, 20, 96}, {5, 55, 0}, 90};
        set_size(width, height);
    }

    /// Radiance of the third frame of the level; all random numbers start anew.
    std::vector<float> picture(std::string_view row, std::string_view compared = "none",
                               double at = 0.5) {
        const TechniqueRow left = find_technique_row(row).value();
        set("pt_nee", technique_infos[static_cast<size_t>(left.technique)].name);
        set("pt_guide", guider_infos[static_cast<size_t>(left.guide)].name);
        set("pt_compare", compared);
        set("pt_compare_at", fmt::format("{}", at));
        load("rooms");
        render(2);
        return radiance(shot_).rgb;
    }
    void render(int frames) {
        for (int i = 0; i < frames; ++i)
            renderer().render(shot_.frame());
    }
    /// Pixels of columns [first, end) that are not the same to the last bit.
    static int differences(const std::vector<float>& a, const std::vector<float>& b, int first,
                           int end) {
        int count = 0;
        for (int y = 0; y < height; ++y)
            for (int x = first; x < end; ++x) {
                const size_t pixel = 3 * static_cast<size_t>(y * width + x);
                count += !std::equal(&a[pixel], &a[pixel] + 3, &b[pixel]);
            }
        return count;
    }
    static int bright_pixels(const refresh::Picture& picture, int first, int end) {
        int count = 0;
        for (int y = 0; y < picture.height; ++y)
            for (int x = first; x < end; ++x)
                count += glm::any(glm::greaterThan(color_at(picture, x, y), glm::uvec3(8)));
        return count;
    }
    static glm::uvec3 color_at(const refresh::Picture& picture, int x, int y) {
        const size_t i = 4 * static_cast<size_t>(y * picture.width + x);
        return {picture.rgba[i], picture.rgba[i + 1], picture.rgba[i + 2]};
    }

    Shot shot_;
};

TEST(TechniqueRows, HaveNamesThatFindThem) {
    for (size_t i = 0; i < std::size(technique_infos); ++i) {
        for (size_t guide = 0; guide < std::size(guider_infos); ++guide) {
            const TechniqueRow row{static_cast<Technique>(i), static_cast<Guide>(guide)};
            const std::string name = technique_row_name(row);
            EXPECT_EQ(find_technique_row(name), row) << name;
            EXPECT_GT(choice_index(compare_choices, name), 0) << name;
        }
    }
    EXPECT_FALSE(find_technique_row("none"));
    EXPECT_FALSE(find_technique_row("+cdq"));
    EXPECT_FALSE(find_technique_row("sll+cdq+cdq"));
    EXPECT_FALSE(find_technique_row("sll+brdf"));
    EXPECT_FALSE(find_technique_row("sll+"));
    EXPECT_FALSE(find_technique_row(""));
}

// Techniques that learn nothing have the same random numbers on both sides of the line as without
// it.
TEST_F(Compare, SidesAreThePicturesOfTheirTechniques) {
    constexpr std::array pairs{std::pair{"sll", "uniform"}, std::pair{"lh", "sll"},
                               std::pair{"uniform", "power"}, std::pair{"ris", "brute"},
                               std::pair{"brute", "lh"}};
    for (const auto& [left_name, right_name] : pairs) {
        const std::vector<float> left = picture(left_name), right = picture(right_name);
        ASSERT_GT(differences(left, right, 0, width / 2), 0);
        ASSERT_GT(differences(left, right, width / 2, width), 0);
        for (const int column : {0, 7, 8, 13, 47, 48}) {
            SCOPED_TRACE(fmt::format("{} | {} at column {}", left_name, right_name, column));
            const std::vector<float> both = picture(left_name, right_name, double(column) / width);
            EXPECT_EQ(renderer().split_column(), static_cast<uint32_t>(column));
            EXPECT_EQ(differences(both, left, 0, column), 0);
            EXPECT_EQ(differences(both, right, column, width), 0);
        }
    }
}

// Those that learn see other samples than without the line, but their mean is the same.
TEST_F(Compare, NeitherSideIsBiased) {
    constexpr int batch_count = 12, frames = 4, block = 4;
    set("pt_nee", "lh");
    load("rooms");
    const PictureBatches expected = batches(shot_, batch_count, 64, 1000, block);
    set("pt_nee", "vlc");
    for (const auto& [guide, compared] : {std::pair{"brdf", "vlc+cdq"}, std::pair{"cdq", "sll"}}) {
        set("pt_guide", guide);
        set("pt_compare", compared);
        PictureBatches both(width, height, block);
        for (int batch = 0; batch < batch_count; ++batch) {
            set("pt_seed", std::to_string(101 + batch));
            set("pt_accumulate", "0");
            set("pt_spp", "1");
            renderer().reset_guiding();
            render(4); // to learn
            set("pt_accumulate", "1");
            set("pt_spp", "12");
            render(frames);
            const refresh::RadiancePicture seen = renderer().read_radiance();
            EXPECT_EQ(seen.frames, frames);
            both.add(seen.rgb);
        }
        judge(fmt::format("vlc, {} | {}", guide, compared), both, expected,
              {.everywhere = 0.01, .five_blocks = 0.15});
    }
}

TEST_F(Compare, ChangesRestartTheMean) {
    set("pt_accumulate", "1");
    picture("sll", "lh");
    EXPECT_EQ(renderer().read_radiance().frames, 3);
    set("pt_compare_at", "0.75");
    EXPECT_EQ(radiance(shot_).frames, 1);
    render(4);
    EXPECT_EQ(renderer().read_radiance().frames, 5);
    set("pt_compare", "power");
    EXPECT_EQ(radiance(shot_).frames, 1);
    set("pt_compare", "none");
    EXPECT_EQ(radiance(shot_).frames, 1);
    set("pt_compare_at", "0.25"); // of no meaning now
    EXPECT_EQ(radiance(shot_).frames, 2);
}

TEST_F(Compare, ThePictureHasLineAndNames) {
    set_size(320, 180);
    picture("sll", "vlc+cdq", 0.5);
    const refresh::Picture seen = renderer().read_picture(false);
    for (int y = 30; y < seen.height; ++y) {
        ASSERT_EQ(color_at(seen, 159, y), glm::uvec3(0)) << y;
        ASSERT_EQ(color_at(seen, 160, y), glm::uvec3(255)) << y;
    }
    const auto left = renderer().side_labels().area(0), right = renderer().side_labels().area(1);
    EXPECT_GT(left.size.x, 20u);
    EXPECT_GT(right.size.x, left.size.x); // a longer name
    EXPECT_LE(left.corner.x + left.size.x, 160u);
    EXPECT_GE(right.corner.x, 160u);
    // At the ends one side is left, without a line.
    for (const double at : {0.0, 1.0}) {
        picture("sll", "vlc+cdq", at);
        const refresh::Picture whole = renderer().read_picture(false);
        const int column = at > 0.0 ? whole.width - 1 : 0;
        int white = 0;
        for (int y = 30; y < whole.height; ++y)
            white += color_at(whole, column, y) == glm::uvec3(255);
        EXPECT_LT(white, whole.height / 2);
        EXPECT_EQ(renderer().side_labels().area(at > 0.0 ? 1 : 0).size.x, 0u);
        EXPECT_GT(renderer().side_labels().area(at > 0.0 ? 0 : 1).size.x, 0u);
    }
}

// Switches that a player makes while comparing, frame after frame. The fixture demands that the
// validation layers stay silent.
TEST_F(Compare, SwitchesWhileItIsOn) {
    set_size(320, 180);
    load("rooms");
    int step = 0;
    uint64_t last = renderer().render(shot_.frame());
    constexpr std::array views{"none", "octree", "cdq", "zero"};
    for (const std::string_view compared : {"sll", "vlc+cdq", "none", "brute", "vlc"}) {
        set("pt_compare", compared);
        for (const std::string_view nee : {"vlc", "sll"}) {
            set("pt_nee", nee);
            set("pt_guide", step % 3 == 0 ? "brdf" : "cdq");
            set("pt_view", views.at(static_cast<size_t>(step) % views.size()));
            set("pt_compare_at", fmt::format("{}", 0.25 * (step % 5)));
            if (step % 4 == 0) set_size(160 + 16 * (step % 3), 90);
            if (step % 5 == 0) renderer().reset_guiding();
            // No frame is lost: the first one after a switch is a picture on both sides.
            EXPECT_EQ(renderer().render(shot_.frame()), ++last);
            const refresh::Picture seen = renderer().read_picture(false);
            for (const int begin : {0, seen.width / 2})
                EXPECT_GT(bright_pixels(seen, begin, begin + seen.width / 2),
                          seen.width * seen.height / 20)
                    << compared << " " << nee << " from column " << begin;
            last = renderer().render(shot_.frame());
            EXPECT_GT(renderer().report_scene(cvars().values()).triangles, 0u);
            const refresh::GuidingReport report = renderer().report_guiding();
            EXPECT_EQ(report.on, report.bytes > 0);
            ++step;
        }
    }
    load("lamp"); // and another level
    render(2);
}

// What the crosshair is asked about belongs to the side that it looks at.
TEST_F(Compare, ReportsAreAboutTheSideUnderTheCrosshair) {
    picture("vlc", "sll", 0.9);
    EXPECT_EQ(renderer().report_guiding().technique, Technique::vlc);
    EXPECT_TRUE(renderer().report_guiding().on);
    set("pt_compare_at", "0.1");
    render(1);
    EXPECT_EQ(renderer().report_guiding().technique, Technique::sll);
    EXPECT_FALSE(renderer().report_guiding().on);
}

TEST_F(Compare, TimesOfBothSidesAreCounted) {
    picture("vlc", "vlc+cdq", 0.5);
    const std::vector<refresh::FrameTimes> times = renderer().take_frame_times(true);
    ASSERT_FALSE(times.empty());
    if (times.back().passes.empty()) GTEST_SKIP() << "no timestamps here";
    const auto has = [&](std::string_view name) {
        return std::ranges::any_of(
            times.back().passes, [&](const refresh::PassTime& pass) { return pass.name == name; });
    };
    EXPECT_TRUE(has("guide_adapt")); // only the right side's
    EXPECT_TRUE(has("vlc_merge"));
    EXPECT_TRUE(has("direct"));
    EXPECT_FALSE(times.back().counts.empty());
}

} // namespace
} // namespace vigil::test
