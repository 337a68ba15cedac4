// SPDX-License-Identifier: GPL-2.0-or-later
// Random damage, the same in every run: each parser either throws Error or returns a structure that
// can be walked in full without any further check. Sanitizers turn every slip into a failure.
#include "common/error.h"
#include "formats/image.h"
#include "formats/md2.h"
#include "formats/mesh.h"
#include "level_walk.h"
#include "picture_bytes.h"
#include "real_levels.h"
#include "small_level.h"
#include "small_models.h"

#include <gtest/gtest.h>

#include <functional>
#include <random>

namespace vigil {
namespace {

/// Changes one byte: to a random value, a bit flip, or one of the values that make trouble.
void damage(Bytes& bytes, size_t first, size_t size, std::mt19937& random) {
    uint8_t& byte = bytes[first + random() % size];
    switch (random() % 3) {
    case 0:
        byte = static_cast<uint8_t>(random());
        break;
    case 1:
        byte = static_cast<uint8_t>(byte ^ 1u << random() % 8);
        break;
    default:
        byte = std::array<uint8_t, 4>{0x00, 0x7f, 0x80, 0xff}[random() % 4];
    }
}

/// Calls `parse` on `rounds` damaged copies; returns how many were accepted.
size_t survive(const Bytes& original, size_t rounds, uint32_t seed,
               const std::function<void(const Bytes&)>& parse) {
    std::mt19937 random(seed);
    size_t accepted = 0;
    for (size_t round = 0; round < rounds; ++round) {
        Bytes bytes = original;
        for (size_t changes = 1 + random() % 3; changes > 0; --changes)
            damage(bytes, 0, bytes.size(), random);
        try {
            parse(bytes);
            ++accepted;
        } catch (const Error& error) {
            EXPECT_TRUE(std::string_view(error.what()).starts_with("x.")) << error.what();
        }
    }
    return accepted;
}

void parse_and_walk(const Bytes& bytes) {
    const volatile float keep = walk_level(parse_bsp("x.bsp", bytes));
    (void)keep;
}

TEST(Damage, SmallLevels) {
    const Bytes file = write_level(small_level());
    const size_t accepted = survive(file, 6000, 11, parse_and_walk);
    // Colours, names and coordinates may change without making a level unusable.
    EXPECT_GT(accepted, 500u);
    EXPECT_LT(accepted, 5500u);
}

TEST(Damage, SmallLevelsFieldByField) {
    // Every byte of every lump, set to the values that indices and offsets fear most.
    const Bytes file = write_level(small_level());
    for (size_t at = 0; at < file.size(); ++at)
        for (const uint8_t value : std::array<uint8_t, 4>{0x00, 0x7f, 0x80, 0xff}) {
            Bytes bytes = file;
            bytes[at] = value;
            try {
                parse_and_walk(bytes);
            } catch (const Error&) {
            }
        }
}

TEST(Damage, RealLevels) {
    const auto folder = real_levels_folder();
    if (!folder) GTEST_SKIP() << "no real levels: set VIGIL_SHARED to the folder of levels/";
    std::mt19937 random(5);
    for (const char* name : {"end", "dm3"}) {
        const Bytes original =
            read_file(*folder / "baseq2" / "maps" / (std::string(name) + ".bsp"));
        for (size_t round = 0; round < 150; ++round) {
            Bytes bytes = original;
            // Half of the rounds hit the directory, where damage moves whole lumps.
            if (round % 2 == 0)
                damage(bytes, 0, level_header_size, random);
            else
                damage(bytes, 0, bytes.size(), random);
            try {
                parse_and_walk(bytes);
            } catch (const Error&) {
            }
        }
    }
}

TEST(Damage, Models) {
    survive(small_sp2(), 4000, 22, [](const Bytes& bytes) { parse_sp2("x.sp2", bytes); });
    survive(small_md2(), 4000, 21, [](const Bytes& bytes) {
        const Md2 model = parse_md2("x.md2", bytes);
        for (const uint32_t index : model.indices)
            for (const Md2Frame& frame : model.frames)
                ASSERT_TRUE(std::isfinite(frame.positions.at(index).x + frame.normals.at(index).x));
    });
    survive(triangle_glb(R"("translation":[1,2,3],)"), 4000, 22, [](const Bytes& bytes) {
        const Mesh mesh = parse_glb("x.glb", bytes);
        for (const MeshPrimitive& primitive : mesh.primitives) {
            ASSERT_LT(primitive.material, mesh.materials.size());
            for (const uint32_t index : primitive.indices)
                ASSERT_TRUE(std::isfinite(primitive.positions.at(index).x));
        }
    });
}

TEST(Damage, Pictures) {
    const Image picture = test_picture(17, 11);
    const Palette palette = test_palette();
    const auto decode = [&](const char* name, const Bytes& file, size_t rounds) {
        survive(file, rounds, 31, [&](const Bytes& bytes) {
            const Image image = decode_image(name, bytes, &palette);
            ASSERT_EQ(image.rgba.size(), size_t{4} * image.width * image.height);
        });
    };
    decode("x.tga", write_tga(picture, {2, 32, 8}), 1000);
    decode("x.tga", write_tga(picture, {3, 8, 0}), 1000);
    decode("x.tga", write_tga(picture, {10, 24, 0x20}), 1000);
    decode("x.png", write_png(picture), 1500);
    decode("x.jpg", write_jpg(picture, 80), 1500);
    decode("x.pcx", write_pcx(16, 16), 1500);
    decode("x.wal", write_wal(16, 16, 0), 1500);
}

} // namespace
} // namespace vigil
