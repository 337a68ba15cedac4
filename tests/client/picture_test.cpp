// SPDX-License-Identifier: GPL-2.0-or-later
// Pictures are written whole and read back the same, or not at all.
#include "client/measure/picture_file.h"
#include "common/error.h"
#include "formats/image.h"
#include "test_game.h"

#include <tinyexr.h>

#include <gtest/gtest.h>

namespace vigil::client {
namespace {

TEST(PictureFile, PngHoldsTheColours) {
    const TestGame game;
    const refresh::Picture picture{2, 1, {10, 20, 30, 0, 200, 100, 50, 255}};
    write_png(game.path("out/a.png"), picture);
    const std::string bytes = game.read("out/a.png");
    const Image image = decode_image(
        "a.png", std::span(reinterpret_cast<const uint8_t*>(bytes.data()), bytes.size()));
    EXPECT_EQ(image.width, 2u);
    EXPECT_EQ(image.height, 1u);
    EXPECT_EQ(image.rgba, (std::vector<uint8_t>{10, 20, 30, 255, 200, 100, 50, 255}));
}

TEST(PictureFile, ExrHoldsEveryBit) {
    const TestGame game;
    const refresh::RadiancePicture picture{2, 1, 3, {1e-20f, 0.1f, 7e30f, 0.0f, 1.5f, 65536.5f}};
    write_exr(game.path("out/a.exr"), picture);
    const std::string bytes = game.read("out/a.exr");
    float* rgba = nullptr;
    int width = 0;
    int height = 0;
    const char* reason = nullptr;
    ASSERT_EQ(LoadEXRFromMemory(&rgba, &width, &height,
                                reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size(),
                                &reason),
              TINYEXR_SUCCESS);
    ASSERT_EQ(width, 2);
    ASSERT_EQ(height, 1);
    for (size_t i = 0; i < 6; ++i)
        EXPECT_EQ(rgba[i / 3 * 4 + i % 3], picture.rgb[i]);
    std::free(rgba);
}

TEST(PictureFile, AFailureLeavesNoFile) {
    const TestGame game;
    const refresh::Picture picture{1, 1, {1, 2, 3, 4}};
    game.write("out/file", "in the way");
    EXPECT_THROW(write_png(game.path("out/file/a.png"), picture), Error);
    EXPECT_THROW(write_png(game.path("out/a.png"), {2, 2, {1, 2, 3, 4}}), Error);
    EXPECT_THROW(write_exr(game.path("out/a.exr"), {}), Error);
    EXPECT_FALSE(game.exists("out/a.png"));
    EXPECT_FALSE(game.exists("out/a.exr"));
}

} // namespace
} // namespace vigil::client
