// SPDX-License-Identifier: GPL-2.0-or-later
// Values that are not finite are planted, in the sky and in lights: each is counted, marked where
// it was met, and kept out of means, the octree's caches and its quadtrees. All other GPU tests
// demand that nothing was counted (render_test.h).
#include "numerics/record.h"
#include "refresh/vkpt/gpu/commands.h"
#include "render_test.h"
#include "shared/firewall.h"
#include "shared/view_colors.h"
#include "shared/views.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vigil::test {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

class Firewall : public RenderTest {
protected:
    void SetUp() override {
        RenderTest::SetUp();
        before_ = renderer().nonfinite_count();
    }
    void TearDown() override { EXPECT_EQ(renderer().device().validation_messages(), 0); }

    /// Events since this was asked last.
    uint32_t events() {
        const uint32_t now = renderer().nonfinite_count();
        return now - std::exchange(before_, now);
    }

    static size_t marked() {
        return static_cast<size_t>(std::ranges::count_if(
            pixel_flags(), [](uint32_t flags) { return (flags & shader::PIXEL_NONFINITE) != 0; }));
    }

    /// The octree's floats: what exploring brought, shares of guided rays, and sums of quadtrees of
    /// `bits` bits (0: there are none).
    static void expect_sound_memory(uint32_t bits) {
        const vkpt::Guiding& guiding = renderer().guiding();
        const vkpt::Guiding::Tree& tree = guiding.tree();
        const uint32_t capacity = guiding.header().node_capacity;
        const std::vector<uint32_t> words = gpu::download_now_as<uint32_t>(
            renderer().device(), tree.leaves, 0, tree.leaves.bytes() / sizeof(uint32_t));
        const std::vector<uint32_t> nodes =
            gpu::download_now_as<uint32_t>(renderer().device(), tree.nodes, 0, 1 + capacity);
        const auto expect_finite = [&](uint32_t first, uint32_t count, const char* what) {
            for (uint32_t word = first; word < first + count; ++word)
                for (const uint32_t half : {0u, 1u})
                    ASSERT_TRUE(
                        shader::is_finite_nonnegative(shader::unpack_sum(words[word], half)))
                        << what << ", word " << word;
        };
        for (uint32_t leaf = 0; leaf < 8 * nodes[0]; ++leaf)
            if ((nodes[1 + leaf / 8] >> leaf % 8 & 1u) != 0u) // no inner node
                expect_finite(shader::leaf_array_word(shader::LEAF_EXPLORE, leaf, capacity), 2,
                              "explored");
        for (uint32_t node = 0; bits > 0 && node < nodes[0]; ++node) {
            const shader::NodeArray sums = shader::guide_memory(shader::CDQ_SUM_WORDS);
            expect_finite(shader::node_array_word(shader::NODE_SHARE, node, capacity), 2, "share");
            expect_finite(shader::node_array_word(sums, node, capacity), bits / 2, "sums");
        }
    }

    uint32_t before_ = 0;
};

Shot court() {
    return {{{-192, -64, 56}, {0, 20, 0}, 90}, {}, {}, 0};
}

TEST_F(Firewall, CountsShowsAndStopsWhatTheSkyBrings) {
    load("opensky");
    for (const float planted : {infinity, -infinity, not_a_number, -1.0f}) {
        SCOPED_TRACE(planted);
        radiance(court());
        EXPECT_EQ(events(), 0u);
        EXPECT_EQ(marked(), 0u);
        vkpt::FrameDescription frame = params(court());
        frame.settings.pt_view = shader::VIEW_NONFINITE;
        frame.sky_radiance = glm::vec3(planted);
        const std::vector<float> mean = trace(frame, 2);
        EXPECT_TRUE(all_finite_nonnegative(mean));
        const size_t bad = marked();
        EXPECT_GT(bad, 0u);
        EXPECT_LT(bad, mean.size() / 3); // some pixels met nothing of it
        EXPECT_GE(events(), bad);
        // Where it was, the view says so.
        const refresh::Picture picture = renderer().read_picture(false);
        const std::vector<uint32_t> flags = pixel_flags();
        for (size_t i = 0; i < flags.size(); ++i) {
            const bool shown = picture.rgba[4 * i] > 200 && picture.rgba[4 * i + 1] < 50;
            ASSERT_EQ(shown, (flags[i] & shader::PIXEL_NONFINITE) != 0) << "pixel " << i;
        }
        // A frame later nothing is left of it.
        frame.sky_radiance = glm::vec3(1.0f);
        EXPECT_GT(sum_of(trace(frame, 2)), 0.0);
        EXPECT_EQ(events(), 0u);
        EXPECT_EQ(marked(), 0u);
    }
    record("the firewall", "infinite, NaN and negative sky, planted",
           "each counted, its pixel shown by pt_view nonfinite, the mean sound, nothing left of it "
           "a frame later",
           "");
}

TEST_F(Firewall, CachesLearnNothingOfIt) {
    load("opensky");
    set("pt_nee", "vlc");
    set("pt_guide", "cdq");
    radiance(court());
    renderer().reset_guiding();
    vkpt::FrameDescription frame = params(court());
    gpu::FrameCommands commands(renderer().device());
    for (uint32_t i = 0; i < 8; ++i) {
        adapt(commands);
        frame.frame = i;
        const float planted[] = {1.0f, infinity, not_a_number, -1e30f};
        frame.sky_radiance = glm::vec3(planted[i % 4]);
        EXPECT_TRUE(all_finite_nonnegative(trace(frame, 1)));
    }
    adapt(commands);
    EXPECT_GT(events(), 0u);
    expect_sound_memory(renderer().guide().size);
    record("the firewall", "the same while light caches and quadtrees learn",
           "every number that the octree keeps is finite", "");
}

TEST_F(Firewall, LightsOfNoNumbersStayDark) {
    load("lamp");
    Shot shot;
    shot.view = {{-192, 0, 64}, {50, 0, 0}, 60};
    const std::vector<float> plain = radiance(shot).rgb;
    for (const char* technique : {"sll", "vlc"})
        for (const glm::vec3& planted :
             {glm::vec3(infinity), glm::vec3(1.0f, not_a_number, 1.0f), glm::vec3(-1.0f)}) {
            SCOPED_TRACE(technique);
            set("pt_nee", technique);
            shot.dynamic_lights = {{77, {-100, 0, 60}, 8.0f, planted}};
            for (int i = 0; i < 3; ++i)
                ASSERT_TRUE(all_finite_nonnegative(radiance(shot).rgb));
            EXPECT_EQ(events(), 0u);
            for (const shader::Light& light : renderer().scene()->lights().lights())
                ASSERT_TRUE(shader::is_finite_nonnegative(light.radiance));
        }
    shot.dynamic_lights.clear();
    set("pt_nee", "sll");
    EXPECT_GT(sum_of(radiance(shot).rgb), 0.0);
    record("the firewall", "lights of infinite, NaN or negative radiance",
           "dark, with one warning that names the light; no event on the GPU", "");
}

TEST_F(Firewall, FiniteLightsWhoseSumsAreNot) {
    load("lamp");
    Shot shot;
    shot.view = {{-192, 0, 64}, {50, 0, 0}, 60};
    shot.dynamic_lights = {{77, {-150, 0, 30}, 6.0f, glm::vec3(3e38f)}, // in view
                           {78, {-60, 40, 60}, 20.0f, glm::vec3(3e38f)}};
    set("pt_guide", "cdq");
    for (const char* technique : {"sll", "vlc", "brute"}) {
        SCOPED_TRACE(technique);
        set("pt_nee", technique);
        set("pt_spp", "4");
        for (int i = 0; i < 6; ++i)
            ASSERT_TRUE(all_finite_nonnegative(radiance(shot).rgb));
        EXPECT_GT(events(), 0u) << "sums that overflow are told";
        expect_sound_memory(renderer().guide().size);
        // Once they are gone, nothing is left in any cache that would be told again.
        Shot after = shot;
        after.dynamic_lights.clear();
        radiance(after);
        events();
        for (int i = 0; i < 3; ++i)
            ASSERT_TRUE(all_finite_nonnegative(radiance(after).rgb));
        EXPECT_EQ(events(), 0u);
        EXPECT_GT(sum_of(radiance(after).rgb), 0.0);
    }
    record("the firewall", "lights of 3e38, whose sums and products overflow",
           "counted and stopped; caches stay finite; nothing left when they are gone", "");
}

TEST_F(Firewall, MeansGoOnAndMarksStayWhileAccumulating) {
    load("opensky");
    radiance(court());
    vkpt::FrameDescription frame = params(court());
    std::vector<double> sum;
    std::vector<float> mean;
    size_t bad = 0;
    for (uint32_t i = 0; i < 6; ++i) {
        frame.frame = i;
        frame.accumulated = 0;
        frame.sky_radiance = glm::vec3(i == 2 ? infinity : 1.0f);
        const std::vector<float> single = trace(frame, 1);
        sum.resize(single.size(), 0.0);
        for (size_t k = 0; k < single.size(); ++k)
            sum[k] += double(single[k]);
    }
    for (uint32_t i = 0; i < 6; ++i) {
        frame.frame = i;
        frame.accumulated = i;
        frame.sky_radiance = glm::vec3(i == 2 ? infinity : 1.0f);
        mean = trace(frame, 1);
        if (i == 2) bad = marked();
        if (i == 1) {
            EXPECT_EQ(marked(), 0u);
        }
    }
    EXPECT_GT(bad, 0u);
    EXPECT_EQ(marked(), bad);
    for (size_t k = 0; k < mean.size(); ++k)
        ASSERT_NEAR(double(mean[k]), sum[k] / 6.0, 1e-5 * sum[k] + 1e-9);
    record("the firewall", "one bad frame while pictures are averaged",
           "it counts as 0 in the mean of all, and its pixels stay marked", "");
}

} // namespace
} // namespace vigil::test
