// SPDX-License-Identifier: GPL-2.0-or-later
// Bytes of the small models; see small_models.h.
#include "small_models.h"

namespace vigil {

Bytes small_md2() {
    constexpr uint32_t vertices = 4, frame_size = 40 + 4 * vertices;
    Bytes file;
    append_text(file, "IDP2", 4);
    for (const uint32_t value : {8u, 64u, 32u, frame_size, 1u, vertices, 5u, 2u, 0u, 2u, 68u, 132u})
        append(file, value);
    for (const size_t offset : {md2_triangles_at, md2_frames_at, size_t{0}, size_t{0}})
        append(file, static_cast<uint32_t>(offset));
    append_text(file, "models/box/skin.pcx", 64);
    append_list<int16_t>(file, {0, 0, 63, 0, 63, 31, 0, 31, 32, 16});
    append_list<uint16_t>(file, {0, 1, 2, 0, 1, 2, 0, 2, 3, 4, 2, 3});
    for (const float height : {1.0f, 5.0f}) {
        append_vec3(file, {0.1f, 0.1f, 1.0f});
        append_vec3(file, {0.0f, 0.0f, height});
        append_text(file, height == 1.0f ? "stand" : "jump", 16);
        const uint8_t corners[vertices][2] = {{0, 0}, {0, 100}, {100, 100}, {100, 0}};
        for (const auto& corner : corners)
            append_bytes(file, {corner[0], corner[1], 0, 0});
    }
    return file;
}

Bytes write_sp2(std::span<const Sp2Frame> frames) {
    Bytes file;
    append_text(file, "IDS2", 4);
    append(file, 2u);
    append(file, static_cast<uint32_t>(frames.size()));
    for (const Sp2Frame& frame : frames) {
        for (const int value : {frame.size.x, frame.size.y, frame.origin.x, frame.origin.y})
            append(file, value);
        append_text(file, frame.picture, 64);
    }
    return file;
}

Bytes small_sp2() {
    const Sp2Frame frames[] = {{{32, 24}, {8, -4}, "sprites/a.tga"},
                               {{8, 8}, {4, 4}, "sprites/b.tga"}};
    return write_sp2(frames);
}

Bytes write_glb(std::string json, const Bytes& binary) {
    json.resize((json.size() + 3) / 4 * 4, ' ');
    Bytes padded = binary;
    padded.resize((binary.size() + 3) / 4 * 4, 0);
    Bytes file;
    append_text(file, "glTF", 4);
    append<uint32_t>(file, 2);
    append(file, static_cast<uint32_t>(12 + 8 + json.size() + 8 + padded.size()));
    append(file, static_cast<uint32_t>(json.size()));
    append_text(file, "JSON", 4);
    append_text(file, json, json.size());
    append(file, static_cast<uint32_t>(padded.size()));
    append_text(file, "BIN", 4);
    append_bytes(file, padded);
    return file;
}

Bytes triangle_glb(std::string_view node, std::string_view material) {
    Bytes binary;
    for (const glm::vec3& corner : {glm::vec3(0), glm::vec3(1, 0, 0), glm::vec3(0, 1, 0)})
        append_vec3(binary, corner);
    for (int i = 0; i < 3; ++i)
        append_vec3(binary, {0, 0, 1});
    for (const float value : {0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 1.0f})
        append(binary, value);
    append_list<uint16_t>(binary, {0, 1, 2});
    std::string json =
        R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{)";
    json += node;
    json += R"("mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0,"NORMAL":1,)"
            R"("TEXCOORD_0":2},"indices":3,"material":0}]}],"materials":[)";
    json += material;
    json += R"(],"buffers":[{"byteLength":104}],"bufferViews":[)"
            R"({"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":36},)"
            R"({"buffer":0,"byteOffset":72,"byteLength":24},)"
            R"({"buffer":0,"byteOffset":96,"byteLength":6}],"accessors":[)"
            R"({"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},)"
            R"({"bufferView":1,"componentType":5126,"count":3,"type":"VEC3"},)"
            R"({"bufferView":2,"componentType":5126,"count":3,"type":"VEC2"},)"
            R"({"bufferView":3,"componentType":5123,"count":3,"type":"SCALAR"}]})";
    return write_glb(json, binary);
}

} // namespace vigil
