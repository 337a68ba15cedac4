// SPDX-License-Identifier: GPL-2.0-or-later
// Every picture format: exact texels back, orientation, transparency, and refusal of cut or hostile
// files before anything large is allocated.
#include "fault.h"
#include "formats/bsp.h"
#include "formats/image.h"
#include "formats/pcx.h"
#include "formats/wal.h"
#include "picture_bytes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <zlib.h>

namespace vigil {
namespace {

/// The picture as the kind of file can hold it: grey from red, alpha 255 where there is none.
Image as_stored(Image image, bool grey, bool alpha) {
    for (size_t i = 0; i < image.rgba.size(); i += 4) {
        if (grey) image.rgba[i + 1] = image.rgba[i + 2] = image.rgba[i];
        if (!alpha) image.rgba[i + 3] = 255;
    }
    return image;
}

class Tga : public testing::TestWithParam<TgaKind> {};

TEST_P(Tga, ComesBackExactlyAndUpright) {
    TgaKind kind = GetParam();
    const Image picture = test_picture(13, 9);
    for (const uint32_t origin : {0x00u, 0x10u, 0x20u, 0x30u}) {
        kind.descriptor = static_cast<uint8_t>(origin | (kind.bits == 32 ? 8u : 0u));
        const Image image = decode_image("textures/a.TGA", write_tga(picture, kind));
        EXPECT_EQ(image.width, 13u);
        EXPECT_EQ(image.height, 9u);
        EXPECT_EQ(image.rgba, as_stored(picture, kind.bits == 8, kind.bits == 32).rgba)
            << "descriptor " << int{kind.descriptor};
    }
}

TEST_P(Tga, CutFilesAreRefused) {
    const Bytes file = write_tga(test_picture(13, 9), GetParam());
    for (size_t size = 1; size < file.size(); ++size)
        expect_fault("a.tga", "", [&] { decode_image("a.tga", std::span(file).first(size)); });
}

INSTANTIATE_TEST_SUITE_P(Kinds, Tga,
                         testing::Values(TgaKind{2, 24, 0}, TgaKind{2, 32, 8}, TgaKind{3, 8, 0},
                                         TgaKind{10, 24, 0}, TgaKind{10, 32, 8},
                                         TgaKind{11, 8, 0}));

TEST(Image, RunLengthTgaUsesRuns) {
    Image flat{100, 3, std::vector<uint8_t>(1200, 90)};
    const Bytes file = write_tga(flat, {10, 32, 8});
    EXPECT_LT(file.size(), 60u);
    EXPECT_EQ(decode_image("a.tga", file).rgba, flat.rgba);
}

TEST(Image, TgaWithoutAlphaBitsIsOpaque) {
    Image picture = test_picture(4, 4);
    for (size_t i = 3; i < picture.rgba.size(); i += 4)
        picture.rgba[i] = 0;
    EXPECT_EQ(decode_image("a.tga", write_tga(picture, {2, 32, 0})).rgba,
              as_stored(picture, false, false).rgba);
    EXPECT_EQ(decode_image("a.tga", write_tga(picture, {2, 32, 8})).rgba, picture.rgba);
}

TEST(Image, PngComesBackExactly) {
    const Image picture = test_picture(33, 17);
    // The content decides, not the name.
    for (const char* name : {"a.png", "a.jpg", "a.tga", "a"})
        EXPECT_EQ(decode_image(name, write_png(picture)).rgba, picture.rgba);
}

TEST(Image, JpgComesBackClosely) {
    Image picture{32, 32, {}};
    for (uint32_t i = 0; i < 32 * 32; ++i)
        for (const uint32_t value : {i % 32 * 8, i / 32 * 8, 128u, 255u})
            picture.rgba.push_back(static_cast<uint8_t>(value));
    const Image image = decode_image("a.jpg", write_jpg(picture, 95));
    ASSERT_EQ(image.rgba.size(), picture.rgba.size());
    // Quality 95 quantises to a few levels; chroma is not subsampled at this quality.
    for (size_t i = 0; i < image.rgba.size(); ++i)
        ASSERT_NEAR(image.rgba[i], picture.rgba[i], 8) << i;
}

TEST(Image, PcxComesBackWithItsPalette) {
    for (const uint32_t width : {16u, 15u}) {
        const Pcx pcx = decode_pcx("pics/colormap.pcx", write_pcx(width, 16));
        EXPECT_EQ(pcx.palette, test_palette());
        ASSERT_EQ(pcx.indices.size(), size_t{width} * 16);
        EXPECT_EQ(pcx.indices[3 * width + 5], 53);
        const Image image = decode_image("skin.pcx", write_pcx(width, 16));
        const size_t at = 4 * (3 * width + 5);
        EXPECT_EQ(Bytes(image.rgba.begin() + at, image.rgba.begin() + at + 4),
                  (Bytes{53, 202, 26, 255}));
    }
    const Image image = decode_image("skin.pcx", write_pcx(16, 16));
    EXPECT_EQ(image.rgba.back(), 0) << "index 255 is transparent";
}

TEST(Image, WalComesBackThroughThePalette) {
    const Palette palette = test_palette();
    const Wal wal = decode_wal("textures/w.wal", write_wal(16, 16, SURF_LIGHT), &palette);
    EXPECT_EQ(wal.name, "e1u1/wall");
    EXPECT_EQ(wal.next_name, "e1u1/wall2");
    EXPECT_EQ(wal.flags, uint32_t{SURF_LIGHT});
    EXPECT_EQ(wal.contents, 1u);
    EXPECT_EQ(wal.value, 77);
    EXPECT_EQ(wal.image.width, 16u);
    EXPECT_EQ(Bytes(wal.image.rgba.end() - 4, wal.image.rgba.end()), (Bytes{255, 0, 127, 255}));
    const Wal cut_out = decode_wal("w.wal", write_wal(16, 16, SURF_ALPHATEST), &palette);
    EXPECT_EQ(cut_out.image.rgba.back(), 0);
    const Image grey = decode_image("w.wal", write_wal(16, 16, 0));
    EXPECT_EQ(Bytes(grey.rgba.begin() + 4, grey.rgba.begin() + 8), (Bytes{17, 17, 17, 255}));
}

TEST(Image, CutFilesAreRefused) {
    const auto refuse_all_cuts = [](const char* name, const Bytes& file, size_t first) {
        for (size_t size = 0; size < first; ++size)
            expect_fault(name, "", [&] { decode_image(name, std::span(file).first(size)); });
    };
    refuse_all_cuts("a.wal", write_wal(16, 16, 0), 100 + 256);
    const Bytes pcx = write_pcx(16, 16);
    refuse_all_cuts("a.pcx", pcx, pcx.size());
    // The last 16 bytes of a PNG are a checksum and an empty end chunk.
    const Bytes png = write_png(test_picture(9, 9));
    refuse_all_cuts("a.png", png, png.size() - 16);
    const Bytes jpg = write_jpg(test_picture(16, 16), 90);
    refuse_all_cuts("a.jpg", jpg, jpg.size());
}

TEST(Image, HugeSizesAreRefusedBeforeAllocation) {
    Bytes tga = write_tga(test_picture(4, 4), {10, 24, 0});
    patch<uint16_t>(tga, 12, 65535);
    expect_fault("a.tga", "65535 x 4 pixels are too many", [&] { decode_image("a.tga", tga); });
    patch<uint16_t>(tga, 12, 16384);
    patch<uint16_t>(tga, 14, 16384);
    expect_fault("a.tga", "16384 x 16384 pixels", [&] { decode_image("a.tga", tga); });

    Bytes wal = write_wal(16, 16, 0);
    patch<uint32_t>(wal, 32, 0xffffffffu);
    expect_fault("a.wal", "4294967295 x 16 pixels", [&] { decode_image("a.wal", wal); });
    patch<uint32_t>(wal, 32, 0);
    expect_fault("a.wal", "the picture is empty", [&] { decode_image("a.wal", wal); });

    Bytes pcx = write_pcx(16, 16);
    patch<uint16_t>(pcx, 8, 65535);
    expect_fault("a.pcx", "65536 x 16 pixels", [&] { decode_image("a.pcx", pcx); });

    Bytes png = write_png(test_picture(4, 4));
    png[16] = 0x7f; // the width's highest byte
    expect_fault("a.png", "", [&] { decode_image("a.png", png); });
}

TEST(Image, PngsMayHoldEmptyData) {
    const Image picture = test_picture(9, 5);
    const Bytes png = write_png(picture);
    constexpr std::array<uint8_t, 12> empty = {0,   0,   0,    0,    'I',  'D',
                                               'A', 'T', 0x35, 0xaf, 0x06, 0x1e};
    // Before the data (behind signature and header), and before the end chunk.
    for (const size_t at : {size_t{8 + 25}, png.size() - 12}) {
        Bytes file = png;
        file.insert(file.begin() + static_cast<std::ptrdiff_t>(at), empty.begin(), empty.end());
        EXPECT_EQ(decode_image("a.png", file).rgba, picture.rgba);
    }
}

/// A PNG of one colour channel, whose rows are `rows` zero bytes, packed.
Bytes png_of(uint32_t width, uint32_t height, size_t rows, uint8_t interlaced = 0) {
    Bytes packed(compressBound(rows));
    uLongf size = packed.size();
    compress2(packed.data(), &size, Bytes(rows).data(), rows, 9);
    packed.resize(size);
    Bytes file = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    const auto big_endian = [](Bytes& out, uint64_t value) {
        for (int shift = 24; shift >= 0; shift -= 8)
            out.push_back(static_cast<uint8_t>(value >> shift));
    };
    const auto chunk = [&](std::string_view kind, const Bytes& content) {
        big_endian(file, content.size());
        append_text(file, kind, kind.size());
        append_bytes(file, content);
        const size_t bytes = kind.size() + content.size();
        big_endian(file, crc32_z(0, file.data() + file.size() - bytes, bytes));
    };
    Bytes header;
    big_endian(header, width);
    big_endian(header, height);
    append_bytes(header, {8, 0, 0, 0, interlaced});
    chunk("IHDR", header);
    chunk("IDAT", packed);
    chunk("IEND", {});
    return file;
}

TEST(Image, PngsMustHoldAllOfTheirPicture) {
    const auto refuse = [](std::string_view part, const Bytes& file) {
        expect_fault("a.png", part, [&] { decode_image("a.png", file); });
    };
    EXPECT_EQ(decode_image("a.png", png_of(3, 2, 8)).width, 3u);
    EXPECT_EQ(decode_image("a.png", png_of(9, 9, 9 * 9 + 19, 1)).width, 9u); // Adam7
    refuse("Not enough image data", png_of(9, 9, 9 * 9 + 18, 1));
    refuse("Not enough image data", png_of(3, 2, 7));
    refuse("bytes cannot hold 16384 x 4096 pixels", png_of(16384, 4096, 8));
    Bytes damaged = png_of(30, 30, 930);
    damaged[8 + 25 + 8 + 6] ^= 0xff;
    refuse("IDAT", damaged);
    Bytes foreign = png_of(3, 2, 8);
    foreign[12] = 'C'; // Apple's PNGs begin with a chunk of their own
    const auto checksum = static_cast<uint32_t>(crc32_z(0, &foreign[12], 4 + 13));
    for (size_t i = 0; i < 4; ++i)
        foreign[29 + i] = static_cast<uint8_t>(checksum >> (24 - 8 * i));
    refuse("", foreign);
}

TEST(Image, WhatAPngHoldsBeyondItsPictureIsLeft) {
    const Bytes bomb = png_of(1, 1, size_t{64} << 20);
    EXPECT_LT(bomb.size(), size_t{100'000});
    EXPECT_EQ(decode_image("a.png", bomb).rgba.size(), 4u);
}

TEST(Image, JpgsThatAskForMoreThanTheyHoldAreRefused) {
    const Bytes right = write_jpg(test_picture(16, 16), 90);
    const std::array<uint8_t, 2> frame = {0xff, 0xc0};
    const auto at = static_cast<size_t>(
        std::search(right.begin(), right.end(), frame.begin(), frame.end()) - right.begin());
    Bytes large = right;
    for (const size_t byte : {at + 5, at + 7}) // height and width, big-endian
        large[byte] = 0x10;
    expect_fault("a.jpg", "bytes cannot hold 4112 x 4112 pixels",
                 [&] { decode_image("a.jpg", large); });

    Bytes many = right;
    for (int i = 0; i < 101; ++i)
        append_bytes(many, {0xff, 0xda, 0, 2});
    expect_fault("a.jpg", "a JPG with 102 scans", [&] { decode_image("a.jpg", many); });
}

TEST(Image, UnknownFilesAreRefusedByName) {
    const Bytes text = {'h', 'e', 'l', 'l', 'o'};
    expect_fault("a.png", "neither PNG nor JPG", [&] { decode_image("a.png", text); });
    expect_fault("a.b/c", "not a picture format", [&] { decode_image("a.b/c", text); });
    expect_fault("a.tga", "the file is empty", [] { decode_image("a.tga", {}); });
}

TEST(Image, SrgbBecomesLinear) {
    EXPECT_EQ(srgb_to_linear(0), 0.0f);
    EXPECT_EQ(srgb_to_linear(255), 1.0f);
    EXPECT_NEAR(srgb_to_linear(188), 0.5f, 0.005f) << "mid grey in light";
    for (int value = 0; value < 256; ++value)
        EXPECT_EQ(linear_to_srgb(srgb_to_linear(static_cast<uint8_t>(value))), value);
    EXPECT_EQ(linear_to_srgb(-1.0f), 0);
    EXPECT_EQ(linear_to_srgb(7.0f), 255);
    EXPECT_EQ(linear_to_srgb(std::numeric_limits<float>::quiet_NaN()), 0);
}

TEST(Image, CheckerHasTwoColoursInEqualParts) {
    const Image image = checker_image();
    ASSERT_EQ(image.rgba.size(), size_t{4} * image.width * image.height);
    size_t dark = 0;
    for (size_t i = 0; i < image.rgba.size(); i += 4)
        dark += image.rgba[i] == image.rgba[0];
    EXPECT_EQ(dark, image.rgba.size() / 8);
}

} // namespace
} // namespace vigil
