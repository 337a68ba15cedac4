// SPDX-License-Identifier: GPL-2.0-or-later
// Textures as the GPU reads them: the shared-exponent format and its error, levels of detail, and
// what stands in for files that are missing or broken.
#include "refresh/vkpt/scene/texture_set.h"

#include "common/file_system.h"
#include "common/scratch_folder.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>

namespace vigil::vkpt {
namespace {

TEST(Rgb9e5, RoundTripIsWithinHalfAStep) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> exponent(-14.0f, 15.9f), share(0.0f, 1.0f);
    for (int i = 0; i < 100000; ++i) {
        const glm::vec3 color =
            std::exp2(exponent(random)) * glm::vec3(share(random), share(random), share(random));
        const float largest = std::max({color.x, color.y, color.z});
        const glm::vec3 back = decode_rgb9e5(encode_rgb9e5(color));
        // The largest mantissa is at least 256 of which half a step is rounded, except below 2^-16
        // where steps are 2^-24.
        const float bound = std::max(largest / 512.0f, std::ldexp(1.0f, -25)) * 1.0001f;
        for (glm::length_t c = 0; c < 3; ++c)
            ASSERT_NEAR(back[c], color[c], bound) << largest;
        ASSERT_EQ(encode_rgb9e5(back), encode_rgb9e5(decode_rgb9e5(encode_rgb9e5(back))))
            << "not idempotent";
        ASSERT_EQ(decode_rgb9e5(encode_rgb9e5(back)), back);
    }
}

TEST(Rgb9e5, EdgesOfTheRange) {
    EXPECT_EQ(decode_rgb9e5(encode_rgb9e5(glm::vec3(0.0f))), glm::vec3(0.0f));
    EXPECT_EQ(decode_rgb9e5(encode_rgb9e5(glm::vec3(1.0f))), glm::vec3(1.0f));
    EXPECT_EQ(decode_rgb9e5(encode_rgb9e5(glm::vec3(65408.0f))), glm::vec3(65408.0f));
    EXPECT_EQ(decode_rgb9e5(encode_rgb9e5(glm::vec3(1e30f, 1.0f, -5.0f))).x, 65408.0f);
    EXPECT_EQ(decode_rgb9e5(encode_rgb9e5(glm::vec3(1.0f, 0.0f, -5.0f))), glm::vec3(1, 0, 0));
    const float nan = std::numeric_limits<float>::quiet_NaN(),
                infinity = std::numeric_limits<float>::infinity();
    EXPECT_EQ(decode_rgb9e5(encode_rgb9e5(glm::vec3(nan, 1.0f, 0.5f))), glm::vec3(0, 1, 0.5));
    EXPECT_EQ(decode_rgb9e5(encode_rgb9e5(glm::vec3(infinity, 0.0f, 0.0f))),
              glm::vec3(65408, 0, 0));
    // Rounding up to the next power of two must not spill into the neighbour's bits.
    for (const float value : {0.9999f, 1.9999f, 511.6f / 512.0f, 65407.0f})
        EXPECT_NEAR(decode_rgb9e5(encode_rgb9e5(glm::vec3(value, 0.0f, 0.0f))).x, value,
                    value / 511.0f);
    EXPECT_EQ(decode_rgb9e5(encode_rgb9e5(glm::vec3(0.9999f, 0.0f, 0.0f))).y, 0.0f);
}

class TextureSetTest : public testing::Test {
protected:
    TextureSetTest() {
        files_.mount_game(std::filesystem::path(VIGIL_SOURCE_DIR) / "tests" / "data", "baseq2");
        files_.mount_folder(folder_.path());
    }

    /// An uncompressed 24-bit TGA, all texels of one grey but for the last row and column, which
    /// are white.
    void write_tga(const std::string& name, uint32_t width, uint32_t height, uint8_t grey) {
        std::vector<uint8_t> bytes{0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0};
        for (const uint32_t size : {width, height}) {
            bytes.push_back(static_cast<uint8_t>(size & 255));
            bytes.push_back(static_cast<uint8_t>(size >> 8));
        }
        bytes.insert(bytes.end(), {24, 0x20});
        for (uint32_t y = 0; y < height; ++y)
            for (uint32_t x = 0; x < width; ++x)
                bytes.insert(bytes.end(), 3,
                             x + 1 == width || y + 1 == height ? uint8_t{255} : grey);
        folder_.write(name, bytes);
        files_.mount_folder(folder_.path()); // look again
    }

    test::ScratchFolder folder_;
    FileSystem files_;
};

TEST_F(TextureSetTest, LevelsHalveRoundedDown) {
    write_tga("textures/odd.tga", 7, 3, 128);
    TextureSet textures(files_);
    const TextureSet::Entry& entry = textures.texture("odd");
    const shader::Texture& header = textures.headers()[entry.header];
    EXPECT_EQ(glm::uvec2(header.width, header.height), glm::uvec2(7, 3));
    EXPECT_EQ(header.mip_count, 3u); // 7 x 3, 3 x 1, 1 x 1
    EXPECT_EQ(textures.texels().size() - header.first_texel, 21u + 3u + 1u);
    EXPECT_EQ(entry.uv_size, glm::uvec2(7, 3));
    EXPECT_EQ(entry.file, "textures/odd.tga");
    // Level 1 comes from the first six columns and two rows: grey alone.
    const float grey = srgb_to_linear(128);
    for (uint32_t i = 21; i < 25; ++i)
        EXPECT_NEAR(decode_rgb9e5(textures.texels()[header.first_texel + i]).x, grey,
                    grey / 500.0f);
    // The mean counts all texels of level 0: 9 of 21 are white.
    EXPECT_NEAR(entry.mean.y, (12 * grey + 9) / 21, 1e-3f);
}

TEST_F(TextureSetTest, LoadsEachNameOnce) {
    TextureSet textures(files_);
    const uint32_t header = textures.texture("test/white").header;
    const size_t texels = textures.texels().size();
    EXPECT_EQ(textures.texture("test/white").header, header);
    EXPECT_EQ(textures.texels().size(), texels);
    EXPECT_TRUE(textures.missing().empty());
    EXPECT_EQ(textures.texture("test/white").mean,
              decode_rgb9e5(textures.texels()[textures.headers()[header].first_texel]));
}

TEST_F(TextureSetTest, MissingAndBrokenFilesBecomeCheckers) {
    folder_.write("textures/broken.png", "not a picture");
    files_.mount_folder(folder_.path());
    TextureSet textures(files_);
    const test::LogCapture log;
    const TextureSet::Entry missing = textures.texture("test/no_such_thing");
    const TextureSet::Entry broken = textures.texture("broken");
    for (const TextureSet::Entry& entry : {missing, broken}) {
        EXPECT_TRUE(entry.file.empty());
        EXPECT_EQ(textures.headers()[entry.header].width, checker_image().width);
    }
    EXPECT_EQ(textures.missing(), (std::vector<std::string>{"test/no_such_thing", "broken"}));
    EXPECT_TRUE(log.contains("broken.png")) << log.all();
}

TEST_F(TextureSetTest, FlatColoursAreSharedByValue) {
    TextureSet textures(files_);
    const uint32_t red = textures.flat({0.5f, 0, 0}).header;
    EXPECT_EQ(textures.flat({0.5f, 0, 0}).header, red);
    EXPECT_NE(textures.flat({0.25f, 0, 0}).header, red);
    EXPECT_EQ(textures.headers()[red].width * textures.headers()[red].height, 1u);
}

TEST_F(TextureSetTest, SkyBoxesAreWholeOrNot) {
    TextureSet textures(files_);
    const std::optional<uint32_t> sky = textures.sky_box("court");
    ASSERT_TRUE(sky);
    for (uint32_t side = 0; side < 6; ++side) {
        EXPECT_EQ(textures.headers()[*sky + side].width, 64u);
        EXPECT_EQ(textures.headers()[*sky + side].mip_count, 1u);
    }
    EXPECT_FALSE(textures.sky_box("no_such_sky"));
    EXPECT_FALSE(textures.missing().empty());
}

TEST_F(TextureSetTest, AnimationFramesLieInARow) {
    TextureSet textures(files_);
    const TextureSet::Entry white = textures.texture("test/white"),
                            red = textures.texture("test/red");
    const TextureSet::Entry blue = textures.texture("test/blue");
    const uint32_t first = textures.consecutive({&white, &blue, &red});
    EXPECT_EQ(textures.headers()[first].first_texel, textures.headers()[white.header].first_texel);
    EXPECT_EQ(textures.headers()[first + 1].first_texel,
              textures.headers()[blue.header].first_texel);
    EXPECT_EQ(textures.headers()[first + 2].first_texel,
              textures.headers()[red.header].first_texel);
    EXPECT_EQ(textures.consecutive({&red}), red.header);
}

// Devices read no more than maxTexelBufferElements texels.
TEST_F(TextureSetTest, FitsByLeavingOutTheLargestLevels) {
    write_tga("textures/large.tga", 16, 16, 128);
    write_tga("textures/small.tga", 4, 4, 64);
    TextureSet textures(files_);
    const TextureSet::Entry large = textures.texture("large");
    const TextureSet::Entry colour = textures.flat({0.25f, 0.5f, 1.0f});
    const TextureSet::Entry small = textures.texture("small");
    const uint32_t frames = textures.consecutive({&large, &small});
    const std::vector<uint32_t> before = textures.texels();
    ASSERT_EQ(before.size(), 341u + 1u + 21u);
    EXPECT_EQ(textures.fit(before.size()), 0u);
    EXPECT_EQ(textures.fit(before.size() - 1), 1u);
    EXPECT_EQ(textures.texels().size(), before.size() - 256);
    const auto header = [&](uint32_t index) { return textures.headers()[index]; };
    for (const uint32_t index : {large.header, frames}) {
        EXPECT_EQ(header(index).first_texel, 0u);
        EXPECT_EQ(glm::uvec2(header(index).width, header(index).height), glm::uvec2(8, 8));
        EXPECT_EQ(header(index).mip_count, 4u);
    }
    EXPECT_EQ(header(small.header).width, 4u);
    EXPECT_TRUE(std::equal(textures.texels().begin(), textures.texels().end(), before.begin() + 256,
                           before.end()));
    EXPECT_EQ(header(colour.header).first_texel, 85u);
    EXPECT_EQ(header(small.header).first_texel, 86u);
    // Single texels stay, whatever the limit.
    EXPECT_EQ(textures.fit(0), 2u);
    EXPECT_EQ(textures.texels().size(), 3u);
    EXPECT_EQ(header(frames + 1).first_texel, header(small.header).first_texel);
    EXPECT_EQ(decode_rgb9e5(textures.texels()[header(colour.header).first_texel]).z, 1.0f);
}

} // namespace
} // namespace vigil::vkpt
