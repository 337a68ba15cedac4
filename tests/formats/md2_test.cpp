// SPDX-License-Identifier: GPL-2.0-or-later
// MD2 on a hand-made model: geometry, seams, winding, and every kind of refusal.
#include "fault.h"
#include "formats/md2.h"
#include "small_models.h"

#include <glm/geometric.hpp>

namespace vigil {
namespace {

TEST(Md2, FramesAndSkinsArrive) {
    const Md2 model = parse_md2("x.md2", small_md2());
    EXPECT_EQ(model.skins, (std::vector<std::string>{"models/box/skin.pcx"}));
    ASSERT_EQ(model.frames.size(), 2u);
    EXPECT_EQ(model.frames[0].name, "stand");
    EXPECT_EQ(model.frames[1].name, "jump");
    EXPECT_EQ(model.indices.size(), 6u);
    // Vertex 0 appears twice because its triangles give it two texture coordinates.
    EXPECT_EQ(model.uvs.size(), 5u);
    for (const Md2Frame& frame : model.frames) {
        EXPECT_EQ(frame.positions.size(), model.uvs.size());
        EXPECT_EQ(frame.normals.size(), model.uvs.size());
    }
    EXPECT_EQ(model.frames[1].positions[0].z, 5.0f);
}

TEST(Md2, TrianglesTurnCounterClockwise) {
    const Md2 model = parse_md2("x.md2", small_md2());
    for (const Md2Frame& frame : model.frames) {
        for (size_t i = 0; i < model.indices.size(); i += 3) {
            const glm::vec3 a = frame.positions[model.indices[i]];
            const glm::vec3 b = frame.positions[model.indices[i + 1]];
            const glm::vec3 c = frame.positions[model.indices[i + 2]];
            EXPECT_NEAR(glm::cross(b - a, c - a).z, 100.0f, 1e-3f);
        }
        for (const glm::vec3& normal : frame.normals)
            EXPECT_EQ(normal, glm::vec3(0, 0, 1));
    }
}

TEST(Md2, TextureCoordinatesStayWithTheirCorners) {
    const Md2 model = parse_md2("x.md2", small_md2());
    const auto& positions = model.frames[0].positions;
    size_t checked = 0;
    for (size_t i = 0; i < positions.size(); ++i) {
        if (positions[i].x < 5 || positions[i].y < 5) continue;
        EXPECT_EQ(model.uvs[i], glm::vec2(63.5f / 64.0f, 31.5f / 32.0f));
        ++checked;
    }
    EXPECT_EQ(checked, 1u);
}

TEST(Md2, DamageIsNamed) {
    const auto refuse = [](size_t at, auto value, std::string_view part) {
        Bytes file = small_md2();
        patch(file, at, value);
        expect_fault("x.md2", part, [&] { parse_md2("x.md2", file); });
    };
    refuse(0, uint8_t{'X'}, "no IDP2 signature");
    refuse(4, uint32_t{7}, "MD2 version 7");
    refuse(8, uint32_t{0}, "the skin size is 0 x 32");
    refuse(16, uint32_t{55}, "frames of 55 bytes do not hold 4 vertices");
    refuse(20, uint32_t{0xffffffff}, "4294967295 skins at byte 68 do not fit");
    refuse(24, uint32_t{0xffffffff}, "do not hold 4294967295 vertices");
    refuse(32, uint32_t{0}, "no triangles");
    refuse(32, uint32_t{0x10000000}, "268435456 triangles at byte");
    refuse(40, uint32_t{0}, "no frames");
    refuse(40, uint32_t{3}, "3 frames at byte");
    refuse(56, uint32_t{0xfffffff0}, "frames at byte 4294967280");
    refuse(md2_triangles_at + 2, uint16_t{4}, "triangle 0 uses vertex 4 of 4");
    refuse(md2_triangles_at + 18, uint16_t{5}, "triangle 1 uses texture coordinate 5 of 5");
    refuse(md2_frames_at, std::numeric_limits<float>::quiet_NaN(), "frame 0 has scale nan");
    refuse(md2_frames_at + 16, std::numeric_limits<float>::infinity(), "translation inf");
}

TEST(Md2, FramesAndTrianglesAreBoundedTogether) {
    // All frames and all triangles may be the same bytes: only the limit stops their product.
    constexpr uint32_t triangles = 70'000, frames = 1'000, frame_size = 44;
    Bytes file;
    append_text(file, "IDP2", 4);
    for (const uint32_t value : {8u, 64u, 32u, frame_size, 0u, 1u, 1u, triangles, 0u, frames, 68u,
                                 68u, 68u, 68u, 68u, 68u})
        append(file, value);
    file.resize(68 + triangles * 12);
    expect_fault("x.md2", "1000 frames of 70000 triangles are too many",
                 [&] { parse_md2("x.md2", file); });
}

TEST(Md2, CutFilesAreRefused) {
    const Bytes file = small_md2();
    for (size_t size = 0; size < file.size(); ++size)
        expect_fault("x.md2", "", [&] { parse_md2("x.md2", std::span(file).first(size)); });
}

} // namespace
} // namespace vigil
