// SPDX-License-Identifier: GPL-2.0-or-later
// Pictures that a front end makes itself (a film, a preview), and frames that show no level.
#include "common/error.h"
#include "render_test.h"

namespace vigil::test {
namespace {

class MadePicturesTest : public RenderTest {
protected:
    static constexpr int width = 48, height = 32;

    static std::vector<glm::uvec3> pixels() {
        const refresh::Picture picture = renderer().read_picture(false);
        std::vector<glm::uvec3> colors;
        for (size_t i = 0; i < picture.rgba.size(); i += 4)
            colors.emplace_back(picture.rgba[i], picture.rgba[i + 1], picture.rgba[i + 2]);
        return colors;
    }
    static std::vector<glm::uvec3> draw(const std::vector<refresh::Draw>& draws,
                                        bool show_level = true) {
        Shot shot;
        shot.view = {{290, 20, 96}, {5, 55, 0}, 90};
        refresh::Frame frame = shot.frame();
        frame.draws = draws;
        frame.show_level = show_level;
        // Random numbers start anew.
        if (show_level) renderer().load_level(load_level(files(), "rooms"), cvars().values());
        renderer().render(frame);
        return pixels();
    }
    static glm::uvec3 at(const std::vector<glm::uvec3>& colors, int x, int y) {
        return colors[static_cast<size_t>(y * width + x)];
    }
};

TEST_F(MadePicturesTest, MadePicturesShowWhatTheyAreTold) {
    const refresh::PictureHandle made = renderer().make_picture({2, 1});
    EXPECT_EQ(renderer().picture_size(made), glm::ivec2(2, 1));
    refresh::Draw picture;
    picture.picture = made;
    picture.size = {2, 1};
    EXPECT_EQ(draw({picture}), draw({})) << "transparent at first";
    const uint8_t first[] = {255, 0, 0, 255, 0, 0, 255, 255};
    renderer().change_picture(made, first);
    refresh::Draw other;
    other.picture = renderer().register_picture("textures/test/red.png");
    other.corner = {4, 0};
    other.size = {2, 2};
    const glm::uvec3 same = at(draw({picture, other}), 4, 0);
    // Several frames in flight, and another text in each.
    Shot shot;
    refresh::Frame frame = shot.frame();
    const refresh::Draw both[] = {picture, other};
    frame.draws = both;
    for (int i = 0; i < 6; ++i) {
        const auto red = static_cast<uint8_t>(40 * i);
        const uint8_t texels[] = {red, 0, 0, 255, 0, 0, 255, 255};
        renderer().change_picture(made, texels);
        renderer().render(frame);
        if (i % 2 == 1) continue;
        const auto seen = pixels();
        EXPECT_EQ(at(seen, 0, 0), glm::uvec3(red, 0, 0));
        EXPECT_EQ(at(seen, 1, 0), glm::uvec3(0, 0, 255));
        EXPECT_EQ(at(seen, 4, 0), same) << "others stay";
    }
    EXPECT_THROW(renderer().change_picture(made, std::span(first, 4)), Error);
    EXPECT_THROW(renderer().change_picture(-1, first), Error);
    for (const glm::ivec2 size : {glm::ivec2(0, 4), {4, -1}, {4097, 1}})
        EXPECT_THROW(renderer().make_picture(size), Error);
}

TEST_F(MadePicturesTest, ALevelNeedNotBeShown) {
    const auto before = draw({});
    refresh::Draw one;
    one.corner = {3, 3};
    one.size = {5, 5};
    one.color = {0, 1, 0, 1};
    const auto seen = draw({one}, false);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            ASSERT_EQ(at(seen, x, y),
                      glm::uvec3(0, x >= 3 && x < 8 && y >= 3 && y < 8 ? 255 : 0, 0));
    EXPECT_EQ(draw({}), before) << "and it comes back";
}

} // namespace
} // namespace vigil::test
