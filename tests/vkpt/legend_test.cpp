// SPDX-License-Identifier: GPL-2.0-or-later
// Legends and colours of the debug views, without a GPU: the colour map is even and inside sRGB,
// classes differ in lightness, every view with numbers or classes has a legend, and what is drawn
// holds its colours and its letters.
#include "refresh/vkpt/debug/legend.h"
#include "shared/view_colors.h"
#include "shared/views.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace vigil::vkpt {
namespace {

LegendSubject subject_of(int view, bool guided) {
    return {view, guided ? Technique::vlc : Technique::sll, true, guided, {1280, 720}, guided};
}

double linear_from_srgb(float value) {
    const double v = static_cast<double>(value);
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

/// CIE lightness, 0 to 100.
double lightness(const glm::vec3& srgb) {
    const double y = 0.2126 * linear_from_srgb(srgb.x) + 0.7152 * linear_from_srgb(srgb.y) +
                     0.0722 * linear_from_srgb(srgb.z);
    return y > 0.008856 ? 116.0 * std::cbrt(y) - 16.0 : 903.3 * y;
}

bool holds(const LegendPixels& pixels, const glm::vec3& color) {
    const uint32_t word = glm::packUnorm4x8(glm::vec4(color, 1.0f));
    return std::ranges::find(pixels.rgba, word) != pixels.rgba.end();
}

TEST(Views, AreNumberedInOrder) {
    for (size_t i = 0; i < std::size(view_infos); ++i)
        EXPECT_EQ(view_infos[i].number, static_cast<int>(i));
    EXPECT_EQ(view_choices.substr(0, 12), "none|octree|");
}

TEST(ColorMap, IsEvenAndInsideSrgb) {
    constexpr int steps = 64;
    double before = lightness(shader::color_map(0.0f));
    for (int i = 0; i <= steps; ++i) {
        const float t = static_cast<float>(i) / steps;
        const glm::vec3 linear = shader::linear_from_oklab(shader::color_map_oklab(t));
        for (glm::length_t c = 0; c < 3; ++c) {
            EXPECT_GT(linear[c], -1e-3f) << t; // nothing is clipped
            EXPECT_LT(linear[c], 1.001f) << t;
        }
        if (i == 0) continue;
        // Equal steps are equal distances in OKLab but for the chord of the hue's arc.
        const glm::vec3 step = shader::color_map_oklab(t) -
                               shader::color_map_oklab(t - 1.0f / static_cast<float>(steps));
        EXPECT_NEAR(glm::length(step) * steps, std::hypot(0.62f, 0.1f * 3.8397f), 1e-3f);
        // Lightness alone orders the map: it can be read without hues.
        const double now = lightness(shader::color_map(t));
        EXPECT_GT(now, before + 0.4);
        before = now;
    }
}

TEST(Classes, DifferInLightness) {
    for (const int view : {shader::VIEW_TECHNIQUE, shader::VIEW_ZERO, shader::VIEW_NONFINITE}) {
        const LegendContent content = legend_content(subject_of(view, true));
        ASSERT_GE(content.classes.size(), 2u);
        for (size_t i = 0; i < content.classes.size(); ++i) {
            for (size_t k = i + 1; k < content.classes.size(); ++k) {
                const double apart = std::abs(lightness(content.classes[i].color) -
                                              lightness(content.classes[k].color));
                EXPECT_GT(apart, 5.0) << content.classes[i].text << ", " << content.classes[k].text;
            }
        }
    }
}

TEST(Legend, EveryViewWithNumbersOrClassesHasOne) {
    const std::set<int> without{shader::VIEW_NONE, shader::VIEW_ALBEDO, shader::VIEW_NORMAL};
    for (const ViewInfo& info : view_infos) {
        for (const bool guided : {false, true}) {
            const LegendContent content = legend_content(subject_of(info.number, guided));
            EXPECT_EQ(content.title.empty(), without.contains(info.number)) << info.name;
            for (const LegendContent::Mark& mark : content.marks) {
                EXPECT_GE(mark.place, 0.0f) << info.name;
                EXPECT_LE(mark.place, 1.0001f) << info.name;
            }
        }
    }
}

TEST(Legend, MarksStandAtTheColoursOfTheirNumbers) {
    for (const int view :
         {shader::VIEW_SAMPLES, shader::VIEW_VLC_LIGHTS, shader::VIEW_VLC_BUCKETS}) {
        const LegendContent content = legend_content(subject_of(view, true));
        ASSERT_GE(content.marks.size(), 4u);
        const float most = view == shader::VIEW_SAMPLES ? shader::view_most_samples({1280, 720})
                           : view == shader::VIEW_VLC_LIGHTS ? shader::VIEW_MOST_LIGHTS
                                                             : shader::VIEW_MOST_BUCKETS;
        for (const LegendContent::Mark& mark : content.marks) {
            const glm::vec3 shown =
                shader::color_map(shader::count_on_scale(std::stof(mark.text), most));
            const auto step =
                static_cast<size_t>(mark.place * 0.9999f * static_cast<float>(content.bar.size()));
            EXPECT_LT(glm::distance(shown, content.bar[step]), 0.02f) << mark.text;
        }
    }
}

TEST(Legend, DensitiesStandAtTheirColours) {
    const LegendContent content = legend_content(subject_of(shader::VIEW_CDQ, true));
    ASSERT_EQ(content.marks.size(), 4u);
    for (const LegendContent::Mark& mark : content.marks) {
        const glm::vec3 shown = shader::color_map(shader::density_on_scale(std::stof(mark.text)));
        const auto step = static_cast<size_t>(mark.place * static_cast<float>(content.bar.size()));
        EXPECT_LT(glm::distance(shown, content.bar[step]), 0.02f) << mark.text;
    }
    EXPECT_NEAR(shader::density_on_scale(shader::VIEW_LEAST_DENSITY), 0.0f, 1e-5f);
    EXPECT_NEAR(shader::density_on_scale(shader::VIEW_MOST_DENSITY), 1.0f, 1e-5f);
    EXPECT_EQ(content.notes.size(), 3u);
}

TEST(Legend, SaysThatQuadtreesAreOff) {
    LegendSubject subject = subject_of(shader::VIEW_CDQ, true);
    const auto off = [&] {
        const LegendContent content = legend_content(subject);
        const auto row =
            std::ranges::find(content.classes, shader::VIEW_OFF, &LegendContent::Class::color);
        return row == content.classes.end() ? std::string() : row->text;
    };
    EXPECT_EQ(off(), "no guider: pt_guide brdf");
    subject.quadtrees = true;
    EXPECT_EQ(off(), "nothing under the cross");
}

TEST(Legend, SaysThatGuidingIsOff) {
    for (const int view : {shader::VIEW_OCTREE, shader::VIEW_SAMPLES, shader::VIEW_VLC_LIGHTS,
                           shader::VIEW_VLC_BUCKETS}) {
        const LegendContent content = legend_content(subject_of(view, false));
        ASSERT_EQ(content.classes.size(), 1u);
        EXPECT_EQ(content.classes[0].color, shader::VIEW_OFF);
        EXPECT_EQ(content.classes[0].text, "guiding is off: pt_nee sll");
        EXPECT_TRUE(content.bar.empty());
    }
    LegendSubject brute = subject_of(shader::VIEW_ZERO, false);
    brute.technique = Technique::brute;
    brute.samples_lights = false;
    EXPECT_EQ(legend_content(brute).classes.at(0).text, "none: pt_nee brute");
}

TEST(Legend, DrawsItsColoursAndLetters) {
    const uint32_t ground = draw_legend({"x", {}, {}, {}, {}}, 360).rgba[0];
    for (const ViewInfo& info : view_infos) {
        const LegendContent content = legend_content(subject_of(info.number, true));
        if (content.title.empty()) continue;
        for (const uint32_t height : {180u, 720u, 1440u, 4320u}) {
            const LegendPixels pixels = draw_legend(content, height);
            ASSERT_EQ(pixels.rgba.size(), size_t{pixels.width} * pixels.height);
            for (const LegendContent::Class& row : content.classes)
                EXPECT_TRUE(holds(pixels, row.color)) << info.name << ": " << row.text;
            for (const glm::vec3& color : content.bar)
                EXPECT_TRUE(holds(pixels, color)) << info.name;
            // The title's letters cover a part of its line, and the frame around all stays clear.
            const uint32_t line = 18 * std::clamp(height / 720, 1u, 3u);
            const auto drawn =
                std::count_if(pixels.rgba.begin(), pixels.rgba.begin() + line * pixels.width,
                              [&](uint32_t word) { return word != ground; });
            EXPECT_GT(drawn, 20 * static_cast<long>(content.title.size()) / 2) << info.name;
            for (uint32_t y = 0; y < pixels.height; ++y) {
                EXPECT_EQ(pixels.rgba[size_t{y} * pixels.width], ground);
                EXPECT_EQ(pixels.rgba[size_t{y + 1} * pixels.width - 1], ground);
            }
        }
    }
    EXPECT_EQ(draw_legend({"x", {}, {}, {}, {}}, 1440).height,
              2 * draw_legend({"x", {}, {}, {}, {}}, 360).height);
}

} // namespace
} // namespace vigil::vkpt
