// SPDX-License-Identifier: GPL-2.0-or-later
// Pictures and fills over the picture (refresh::Draw): which pixels, which texels, in which order,
// and over what.
#include "common/error.h"
#include "formats/picture_bytes.h"
#include "render_test.h"

#include <glm/gtx/component_wise.hpp>
#include <limits>
#include <utility>

namespace vigil::test {
namespace {

class DrawsTest : public RenderTest {
protected:
    static constexpr int width = 48, height = 32;

    void SetUp() override {
        RenderTest::SetUp();
        // Four texels: red, green; blue, half transparent white.
        const Image four{
            2, 2, {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 128}};
        write_game_file("pics/four.tga", write_tga(four, {2, 32, 0x28}));
        four_ = renderer().register_picture("pics/four.tga");
    }

    static std::vector<glm::uvec3> pixels(refresh::Renderer& from) {
        const refresh::Picture picture = from.read_picture(false);
        std::vector<glm::uvec3> colors;
        for (size_t i = 0; i < picture.rgba.size(); i += 4)
            colors.emplace_back(picture.rgba[i], picture.rgba[i + 1], picture.rgba[i + 2]);
        return colors;
    }
    std::vector<glm::uvec3> draw(const std::vector<refresh::Draw>& draws) const {
        Shot shot;
        shot.view = {{290, 20, 96}, {5, 55, 0}, 90};
        refresh::Frame frame = shot.frame();
        frame.draws = draws;
        load_level_again();
        renderer().render(frame);
        return pixels(renderer());
    }
    /// So that all random numbers start anew.
    static void load_level_again() {
        renderer().load_level(load_level(files(), "rooms"), cvars().values());
    }
    static refresh::Draw fill(glm::ivec2 corner, glm::ivec2 size, glm::vec4 color) {
        refresh::Draw draw;
        draw.corner = corner;
        draw.size = size;
        draw.color = color;
        return draw;
    }
    /// Pixels that differ, as a rectangle: first, and one behind the last.
    static std::pair<glm::ivec2, glm::ivec2> changed(const std::vector<glm::uvec3>& a,
                                                     const std::vector<glm::uvec3>& b) {
        glm::ivec2 from(width, height), to(0);
        for (int i = 0; i < width * height; ++i)
            if (a[static_cast<size_t>(i)] != b[static_cast<size_t>(i)]) {
                const glm::ivec2 pixel(i % width, i / width);
                from = glm::min(from, pixel);
                to = glm::max(to, pixel + 1);
            }
        return {from, to};
    }
    static glm::uvec3 at(const std::vector<glm::uvec3>& colors, int x, int y) {
        return colors[static_cast<size_t>(y * width + x)];
    }

    refresh::PictureHandle four_ = -1;
};

TEST_F(DrawsTest, PictureIsScaledWithoutAFilter) {
    const auto before = draw({});
    refresh::Draw picture;
    picture.picture = four_;
    picture.corner = {7, 5};
    picture.size = {10, 12};
    const auto after = draw({picture});
    EXPECT_EQ(changed(before, after), std::pair(glm::ivec2(7, 5), glm::ivec2(17, 17)));
    for (int y = 5; y < 17; ++y)
        for (int x = 7; x < 17; ++x) {
            const bool right = x >= 12, low = y >= 11;
            const glm::uvec3 seen = at(after, x, y), below = at(before, x, y);
            if (!(right && low)) {
                EXPECT_EQ(seen, glm::uvec3(!right && !low, right && !low, low && !right) * 255u)
                    << x << ' ' << y;
                continue;
            }
            const glm::ivec3 expected = glm::mix(glm::vec3(below), glm::vec3(255), 128.0f / 255.0f);
            EXPECT_LE(glm::compMax(glm::abs(glm::ivec3(seen) - expected)), 1) << x << ' ' << y;
        }
    EXPECT_EQ(renderer().picture_size(four_), glm::ivec2(2, 2));
    EXPECT_EQ(renderer().register_picture("pics/four.tga"), four_);
}

TEST_F(DrawsTest, PartsAndColours) {
    refresh::Draw picture;
    picture.picture = four_;
    picture.corner = {0, 0};
    picture.size = {4, 4};
    picture.from = {0.5f, 0.0f}; // green alone
    picture.to = {1.0f, 0.5f};
    picture.color = {1, 0.5f, 1, 1};
    const auto green = draw({picture});
    picture.from = {1, 0}; // mirrored
    picture.to = {0, 1};
    picture.color = glm::vec4(1);
    const auto mirrored = draw({picture});
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 4; ++x)
            EXPECT_EQ(at(green, x, y), glm::uvec3(0, 128, 0));
    EXPECT_EQ(at(mirrored, 0, 0), glm::uvec3(0, 255, 0));
    EXPECT_EQ(at(mirrored, 3, 0), glm::uvec3(255, 0, 0));
    EXPECT_EQ(at(mirrored, 3, 3), glm::uvec3(0, 0, 255));
}

TEST_F(DrawsTest, StaysWithinClipAndScreen) {
    const auto before = draw({});
    refresh::Draw cut = fill({-1000, -1000}, {3000, 3000}, {1, 0, 1, 1});
    cut.clip_corner = {3, 4};
    cut.clip_size = {20, 9};
    EXPECT_EQ(changed(before, draw({cut})), std::pair(glm::ivec2(3, 4), glm::ivec2(23, 13)));
    constexpr int huge = std::numeric_limits<int>::max();
    const auto all = draw({fill({-huge, -huge}, {huge, huge}, {0, 0, 0, 1}), // ends at the corner
                           fill({40, 20}, {huge, huge}, {0, 1, 0, 1})});
    EXPECT_EQ(changed(before, all), std::pair(glm::ivec2(40, 20), glm::ivec2(width, height)));
    EXPECT_EQ(draw({fill({4, 4}, {0, 10}, glm::vec4(1)), fill({4, 4}, {-3, -3}, glm::vec4(1)),
                    fill({width, 0}, {5, 5}, glm::vec4(1)), fill({4, 4}, {9, 9}, {1, 1, 1, 0})}),
              before);
}

TEST_F(DrawsTest, LaterOnesCoverEarlierOnes) {
    // Hundreds of the same size, each over half of the one before: no two may change places.
    std::vector<refresh::Draw> draws;
    for (int i = 0; i < 600; ++i)
        draws.push_back(fill(
            {i % 40, i / 40 * 2}, {2, 2},
            {static_cast<float>(i % 251) / 255.0f, static_cast<float>(i % 83) / 255.0f, 0, 1}));
    std::vector<glm::uvec3> expected(width * height, glm::uvec3(0, 0, 255));
    for (const refresh::Draw& one : draws)
        for (int y = one.corner.y; y < std::min(one.corner.y + 2, height); ++y)
            for (int x = one.corner.x; x < one.corner.x + 2; ++x)
                expected[static_cast<size_t>(y * width + x)] =
                    glm::uvec3(glm::round(255.0f * glm::vec3(one.color)));
    draws.insert(draws.begin(), fill({0, 0}, {width, height}, {0, 0, 1, 1}));
    EXPECT_EQ(draw(draws), expected);
}

TEST_F(DrawsTest, OverBlackBeforeALevel) {
    vkpt::VkptRenderer other(files(), nullptr, cvars().values());
    const refresh::PictureHandle four = other.register_picture("pics/four.tga");
    refresh::Draw picture = fill({8, 8}, {2, 2}, glm::vec4(1));
    picture.picture = four;
    refresh::Frame frame;
    frame.settings = cvars().values();
    frame.draws = std::span(&picture, 1);
    other.render(frame);
    const std::vector<glm::uvec3> seen = pixels(other);
    EXPECT_EQ(at(seen, 8, 8), glm::uvec3(255, 0, 0));
    EXPECT_EQ(at(seen, 9, 9), glm::uvec3(128));
    EXPECT_EQ(at(seen, 10, 10), glm::uvec3(0));
    frame.draws = {};
    other.render(frame);
    EXPECT_EQ(at(pixels(other), 8, 8), glm::uvec3(0));
    EXPECT_EQ(other.health().validation_messages, 0);
}

TEST_F(DrawsTest, SaysWhatIsWrong) {
    EXPECT_THROW(renderer().register_picture("pics/missing.pcx"), Error);
    write_game_file("pics/broken.png", std::vector<uint8_t>{1, 2, 3});
    EXPECT_THROW(renderer().register_picture("pics/broken.png"), Error);
    EXPECT_THROW(renderer().picture_size(1000), Error);
    refresh::Draw unknown = fill({0, 0}, {4, 4}, glm::vec4(1));
    unknown.picture = 1000;
    EXPECT_THROW(draw({unknown}), Error);
    const auto before = draw({});
    EXPECT_EQ(draw({}), before); // and goes on
}

} // namespace
} // namespace vigil::test
