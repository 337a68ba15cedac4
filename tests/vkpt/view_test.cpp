// SPDX-License-Identifier: GPL-2.0-or-later
// The debug views on the GPU against what they are views of: flags of primary hits, and the octree
// and light caches read back. With guiding off they show one flat colour.
#include "refresh/vkpt/guiding/leaf_report.h"
#include "render_test.h"
#include "shared/view_colors.h"
#include "shared/views.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>

namespace vigil::test {
namespace {

constexpr std::array guiding_views{"octree", "samples", "vlc_lights", "vlc_buckets"};

class Views : public RenderTest {
protected:
    void SetUp() override {
        RenderTest::SetUp();
        load("rooms");
        shot_.view = {{290, 20, 96}, {5, 55, 0}, 90};
        set_size(96, 64); // no legend is this small
    }

    void render(int frames = 1) {
        for (int i = 0; i < frames; ++i)
            renderer().render(shot_.frame());
    }
    /// sRGB of a pixel, 0 to 1.
    static glm::vec3 color_at(const refresh::Picture& picture, size_t pixel) {
        return glm::vec3(picture.rgba[4 * pixel], picture.rgba[4 * pixel + 1],
                         picture.rgba[4 * pixel + 2]) /
               255.0f;
    }
    static bool same(const glm::vec3& a, const glm::vec3& b) {
        return glm::all(glm::lessThan(glm::abs(a - b), glm::vec3(0.6f / 255.0f)));
    }
    float facing(const shader::PrimaryHit& hit) const {
        return std::abs(glm::dot(hit.normal, glm::normalize(shot_.view.origin - hit.position)));
    }
    /// All hits have this colour, all else is black.
    static void expect_flat(const glm::vec3& color) {
        const refresh::Picture picture = renderer().read_picture(false);
        const std::vector<shader::PrimaryHit> hits = primary_hits();
        for (size_t i = 0; i < hits.size(); ++i) {
            const bool hit = hits[i].primitive != shader::NONE;
            ASSERT_TRUE(same(color_at(picture, i), hit ? color : glm::vec3(0.0f))) << "pixel " << i;
        }
    }

    Shot shot_;
};

TEST_F(Views, AreFlatWhileGuidingIsOff) {
    const auto expect_all_flat = [&] {
        for (const char* view : guiding_views) {
            SCOPED_TRACE(view);
            set("pt_view", view);
            render();
            expect_flat(shader::VIEW_OFF);
        }
    };
    set("pt_nee", "sll");
    expect_all_flat();
    // Nor is anything left of what was there.
    set("pt_nee", "vlc");
    render(4);
    for (const char* technique : {"sll", "brute"}) {
        set("pt_nee", technique);
        expect_all_flat();
    }
}

TEST_F(Views, ZeroAndTechniqueShowTheFlags) {
    for (const char* technique : {"sll", "vlc", "brute"}) {
        SCOPED_TRACE(technique);
        set("pt_nee", technique);
        set("pt_view", "zero");
        render(3);
        if (!renderer().technique()->samples_lights()) {
            expect_flat(shader::VIEW_OFF);
            set("pt_view", "technique");
            render();
            expect_flat(shader::VIEW_OFF);
            continue;
        }
        size_t hit_count = 0, unlit = 0, shown = 0, explored = 0;
        const auto count = [&](auto&& check) {
            const refresh::Picture picture = renderer().read_picture(false);
            const std::vector<shader::PrimaryHit> hits = primary_hits();
            const std::vector<uint32_t> flags = pixel_flags();
            for (size_t i = 0; i < hits.size(); ++i)
                if (hits[i].primitive != shader::NONE) check(flags[i], color_at(picture, i));
        };
        count([&](uint32_t flags, const glm::vec3& color) {
            ++hit_count;
            unlit += flags & shader::PIXEL_UNLIT ? 1 : 0;
            shown += same(color, shader::VIEW_ZERO_SAMPLE) ? 1 : 0;
        });
        EXPECT_EQ(shown, unlit);
        EXPECT_GT(unlit, 0u);
        EXPECT_LT(unlit, hit_count);

        set("pt_view", "technique");
        render();
        count([&](uint32_t flags, const glm::vec3& color) {
            const bool zero = (flags & shader::PIXEL_UNLIT) != 0;
            const bool explores = (flags & shader::PIXEL_EXPLORED) != 0;
            explored += explores ? 1 : 0;
            EXPECT_TRUE(
                same(color, explores ? (zero ? shader::VIEW_EXPLORED_ZERO : shader::VIEW_EXPLORED)
                                     : (zero ? shader::VIEW_CACHE_ZERO : shader::VIEW_CACHE)));
        });
        EXPECT_EQ(explored > 0, renderer().technique()->uses_guiding());
    }
}

TEST_F(Views, CountsAreThoseOfTheLeaf) {
    set("pt_nee", "vlc");
    set("pt_vlc_bucket", "2"); // so that caches have several buckets
    set("pt_oct_scale", "0.25");
    render(8);
    const glm::uvec2 size = renderer().buffers().size();
    for (const std::string_view view : {"samples", "vlc_lights", "vlc_buckets"}) {
        SCOPED_TRACE(view);
        set("pt_view", view);
        render();
        const vkpt::TreeCopy tree(renderer().device(), renderer().guiding());
        const refresh::Picture picture = renderer().read_picture(false);
        const std::vector<shader::PrimaryHit> hits = primary_hits();
        std::map<size_t, int> counts;
        for (size_t i = 0; i < hits.size(); ++i) {
            if (hits[i].primitive == shader::NONE) continue;
            const vkpt::LeafReport leaf = tree.leaf_at(hits[i].position, 2);
            size_t count = leaf.buckets.size();
            float most = shader::VIEW_MOST_BUCKETS;
            if (view == "samples") {
                count = leaf.samples;
                most = shader::view_most_samples(size);
                ASSERT_GT(count, 0u) << "the hit itself is a sample";
            } else if (view == "vlc_lights") {
                count = 0;
                for (const auto& bucket : leaf.buckets)
                    count += bucket.size();
                most = shader::VIEW_MOST_LIGHTS;
            }
            const glm::vec3 color =
                (0.8f + 0.2f * facing(hits[i])) *
                shader::color_map(shader::count_on_scale(static_cast<float>(count), most));
            const glm::vec3 expected = count == 0 ? shader::VIEW_EMPTY : color;
            // The hit's facing and the map's sines are rounded differently.
            ASSERT_LT(glm::distance(color_at(picture, i), expected), 2.5f / 255.0f)
                << "pixel " << i << ": " << count;
            ++counts[count];
        }
        EXPECT_GT(counts.size(), 1u) << "one number everywhere shows nothing";
    }
}

TEST_F(Views, EachLeafHasItsColourAndBorders) {
    set("pt_nee", "vlc");
    set("pt_oct_scale", "4"); // leaves many pixels wide
    set("pt_view", "octree");
    render(8);
    const vkpt::TreeCopy tree(renderer().device(), renderer().guiding());
    const refresh::Picture picture = renderer().read_picture(false);
    const std::vector<shader::PrimaryHit> hits = primary_hits();
    // A pixel's colour without shading; the brightest of a leaf is inside its borders.
    const auto unshaded = [&](size_t i) {
        return color_at(picture, i) / (0.5f + 0.5f * facing(hits[i]));
    };
    const auto brightness = [](const glm::vec3& color) { return color.x + color.y + color.z; };
    std::map<uint32_t, glm::vec3> brightest;
    std::vector<uint32_t> leaves(hits.size());
    for (size_t i = 0; i < hits.size(); ++i) {
        if (hits[i].primitive == shader::NONE) continue;
        leaves[i] = tree.leaf_at(hits[i].position, 32).leaf;
        glm::vec3& color = brightest.emplace(leaves[i], glm::vec3(0.0f)).first->second;
        if (brightness(unshaded(i)) > brightness(color)) color = unshaded(i);
    }
    size_t inside = 0, borders = 0;
    for (size_t i = 0; i < hits.size(); ++i) {
        if (hits[i].primitive == shader::NONE) continue;
        const glm::vec3 color = brightest[leaves[i]];
        const bool is_inside = glm::distance(unshaded(i), color) < 0.02f;
        const bool is_border = glm::distance(unshaded(i), 0.35f * color) < 0.02f;
        ASSERT_TRUE(is_inside || is_border) << "pixel " << i;
        inside += is_inside ? 1 : 0;
        borders += is_border ? 1 : 0;
    }
    EXPECT_GT(brightest.size(), 10u);
    EXPECT_GT(borders, hits.size() / 100);
    EXPECT_GT(inside, borders);
}

TEST_F(Views, LegendsArePartOfThePicture) {
    set_size(320, 180);
    set("pt_nee", "vlc");
    for (const ViewInfo& info : view_infos) {
        SCOPED_TRACE(info.name);
        set("pt_view", info.name);
        render(2);
        const vkpt::LegendPixels legend = vkpt::draw_legend(
            vkpt::legend_content({info.number, Technique::vlc, true, true, {320, 180}, true}), 180);
        const vkpt::Legend::Area& area = renderer().legend().area();
        const bool expected = info.number != shader::VIEW_NONE &&
                              info.number != shader::VIEW_ALBEDO &&
                              info.number != shader::VIEW_NORMAL;
        ASSERT_EQ(area.size.x > 0, expected);
        EXPECT_EQ(renderer().read_picture(true).rgba, renderer().read_picture(false).rgba);
        if (!expected) continue;
        ASSERT_EQ(area.size, glm::uvec2(legend.width, legend.height));
        ASSERT_EQ(area.corner.y + area.size.y, 180u); // the lower left corner
        const refresh::Picture picture = renderer().read_picture(false);
        for (uint32_t y = 0; y < legend.height; ++y) {
            const uint8_t* row = &picture.rgba[4 * (size_t{area.corner.y + y} * 320)];
            ASSERT_EQ(std::memcmp(row, &legend.rgba[size_t{y} * legend.width], 4 * legend.width),
                      0);
        }
    }
    set_size(64, 32); // no room
    set("pt_view", "samples");
    render();
    EXPECT_EQ(renderer().legend().area().size, glm::uvec2(0));
}

} // namespace
} // namespace vigil::test
