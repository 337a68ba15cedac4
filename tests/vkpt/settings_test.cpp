// SPDX-License-Identifier: GPL-2.0-or-later
// Settings are values: they come with a frame, and two renderers in one process have their own.
#include "render_test.h"

namespace vigil::test {
namespace {

class SettingsTest : public RenderTest {
protected:
    /// A view of `rooms`, drawn as these settings say.
    static refresh::Frame frame_with(const refresh::Settings& settings) {
        const Shot shot{{{150, 128, 60}, {5, 20, 0}, 90}, {}, {}};
        refresh::Frame frame = shot.frame();
        frame.settings = settings;
        return frame;
    }

    static std::vector<float> draw(refresh::Renderer& from, const refresh::Settings& settings) {
        from.render(frame_with(settings));
        return from.read_radiance().rgb;
    }
};

TEST_F(SettingsTest, TwoRenderersHaveTheirOwn) {
    load("rooms");
    refresh::Settings lists = cvars().values(); // sll
    refresh::Settings brute = lists;
    brute.pt_nee = setting_choice("pt_nee", "brute");
    brute.vid_width = 32;
    brute.pt_seed = 7;

    const auto first_frames = [&](refresh::Renderer& from, const refresh::Settings& settings) {
        from.load_level(load_level(files(), "rooms"), settings); // random numbers start anew
        return std::vector{draw(from, settings), draw(from, settings)};
    };
    vkpt::VkptRenderer other(files(), nullptr, brute);
    const auto lists_alone = first_frames(renderer(), lists);
    const auto brute_alone = first_frames(other, brute);
    EXPECT_EQ(lists_alone[0].size(), 3u * 48 * 32);
    EXPECT_EQ(brute_alone[0].size(), 3u * 32 * 32);
    EXPECT_GT(sum_of(lists_alone[0]), 0.0);
    EXPECT_GT(sum_of(brute_alone[0]), 0.0);

    renderer().load_level(load_level(files(), "rooms"), lists);
    other.load_level(load_level(files(), "rooms"), brute);
    for (size_t frame = 0; frame < 2; ++frame) {
        EXPECT_EQ(draw(renderer(), lists), lists_alone[frame]);
        EXPECT_EQ(draw(other, brute), brute_alone[frame]);
    }
    EXPECT_EQ(other.health().validation_messages, 0);
}

TEST_F(SettingsTest, VariablesAreNotRead) {
    load("rooms");
    const refresh::Settings settings = cvars().values();
    const auto before = draw(renderer(), settings);
    load("rooms");
    set("pt_nee", "brute");
    set("pt_bounces", "0");
    set_size(64, 16);
    EXPECT_EQ(draw(renderer(), settings), before);
}

} // namespace
} // namespace vigil::test
