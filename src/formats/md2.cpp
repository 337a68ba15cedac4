// SPDX-License-Identifier: GPL-2.0-or-later
// MD2 decoder; see md2.h. A header of 17 words gives counts and offsets of skins (64-byte names),
// texture coordinates (2 shorts), triangles (3 vertex and 3 texture indices) and frames (scale,
// translation, name, 4 bytes per vertex).
#include "formats/md2.h"

#include "common/error.h"
#include "formats/byte_reader.h"

#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace vigil {

namespace {

constexpr uint32_t md2_magic = 0x32504449; // "IDP2"
constexpr uint32_t md2_version = 8;
constexpr size_t skin_bytes = 64, uv_bytes = 4, triangle_bytes = 12, frame_header_bytes = 40;
/// Vertices in all frames together; a few bytes must not ask for gigabytes. id's largest model has
/// some 200,000.
constexpr uint64_t max_frame_vertices = uint64_t{1} << 24;
/// Triangles in all frames together: frames are cheap in bytes, but each one's normals are summed
/// over all triangles.
constexpr uint64_t max_frame_triangles = uint64_t{1} << 26;
constexpr float max_scale = 1048576.0f; ///< map units, also for translations

/// As in the file.
struct Header {
    uint32_t skin_width, skin_height, frame_size;
    uint32_t skins, vertices, uvs, triangles, commands, frames;
    uint32_t skins_at, uvs_at, triangles_at, frames_at;
};

/// As in the file.
struct Triangle {
    std::array<uint16_t, 3> vertex, uv;
};

Header read_header(std::string_view name, std::span<const uint8_t> bytes) {
    const std::string what = fmt::format("{}: MD2 header", name);
    ByteReader reader(what, bytes);
    if (reader.u32() != md2_magic) fail("{}: not a model (no IDP2 signature)", name);
    if (const uint32_t version = reader.u32(); version != md2_version)
        fail("{}: MD2 version {}, Quake II models have version {}", name, version, md2_version);
    Header header{};
    reader.get(header);
    if (header.skin_width == 0 || header.skin_height == 0)
        fail("{}: the skin size is {} x {}", name, header.skin_width, header.skin_height);
    if (header.frames == 0) fail("{}: the model has no frames", name);
    if (header.triangles == 0) fail("{}: the model has no triangles", name);
    if (header.frame_size < frame_header_bytes + uint64_t{4} * header.vertices)
        fail("{}: frames of {} bytes do not hold {} vertices", name, header.frame_size,
             header.vertices);
    return header;
}

/// The bytes of one table of the file.
std::span<const uint8_t> section(std::string_view name, const char* what,
                                 std::span<const uint8_t> bytes, uint32_t offset, uint32_t count,
                                 size_t size) {
    const uint64_t length = uint64_t{count} * size;
    if (offset > bytes.size() || length > bytes.size() - offset)
        fail("{}: {} {} at byte {} do not fit into a file of {} bytes", name, count, what, offset,
             bytes.size());
    return bytes.subspan(offset, length);
}

std::vector<Triangle> read_triangles(std::string_view name, std::span<const uint8_t> bytes,
                                     const Header& header) {
    ByteReader reader(name, section(name, "triangles", bytes, header.triangles_at, header.triangles,
                                    triangle_bytes));
    std::vector<Triangle> triangles(header.triangles);
    for (size_t i = 0; i < triangles.size(); ++i) {
        reader.get(triangles[i]);
        for (const uint16_t vertex : triangles[i].vertex)
            if (vertex >= header.vertices)
                fail("{}: triangle {} uses vertex {} of {}", name, i, vertex, header.vertices);
        for (const uint16_t uv : triangles[i].uv)
            if (uv >= header.uvs)
                fail("{}: triangle {} uses texture coordinate {} of {}", name, i, uv, header.uvs);
    }
    return triangles;
}

std::vector<glm::vec2> read_uvs(std::string_view name, std::span<const uint8_t> bytes,
                                const Header& header) {
    ByteReader reader(
        name, section(name, "texture coordinates", bytes, header.uvs_at, header.uvs, uv_bytes));
    std::vector<glm::vec2> uvs(header.uvs);
    const glm::vec2 size(header.skin_width, header.skin_height);
    for (glm::vec2& uv : uvs) {
        const float s = reader.i16(), t = reader.i16();
        uv = (glm::vec2(s, t) + 0.5f) / size; // whole numbers name texel centres
    }
    return uvs;
}

/// Area-weighted vertex normals. Vertices that share a position index share a normal, so seams of
/// the skin do not show.
std::vector<glm::vec3> smooth_normals(const std::vector<glm::vec3>& positions,
                                      const std::vector<Triangle>& triangles) {
    std::vector<glm::vec3> normals(positions.size(), glm::vec3(0.0f));
    for (const Triangle& triangle : triangles) {
        const auto& [a, b, c] = triangle.vertex;
        // The file's triangles are clockwise seen from outside.
        const glm::vec3 normal =
            glm::cross(positions[c] - positions[a], positions[b] - positions[a]);
        for (const uint16_t vertex : triangle.vertex)
            normals[vertex] += normal;
    }
    for (glm::vec3& normal : normals) {
        const float length = glm::length(normal);
        normal = length > 0.0f && std::isfinite(length) ? normal / length : glm::vec3(0, 0, 1);
    }
    return normals;
}

} // namespace

Md2 parse_md2(std::string_view name, std::span<const uint8_t> bytes) {
    const Header header = read_header(name, bytes);
    const auto triangles = read_triangles(name, bytes, header);
    const auto file_uvs = read_uvs(name, bytes, header);
    if (uint64_t{header.frames} * header.triangles > max_frame_triangles)
        fail("{}: {} frames of {} triangles are too many", name, header.frames, header.triangles);

    Md2 model;
    model.skin_width = header.skin_width;
    model.skin_height = header.skin_height;
    ByteReader skins(name,
                     section(name, "skins", bytes, header.skins_at, header.skins, skin_bytes));
    for (uint32_t i = 0; i < header.skins; ++i)
        model.skins.push_back(skins.text(skin_bytes));

    // One vertex per pair of position and texture coordinate; triangles turn counter-clockwise.
    std::map<std::pair<uint16_t, uint16_t>, uint32_t> known;
    std::vector<uint16_t> source;
    for (const Triangle& triangle : triangles)
        for (const size_t corner : {0, 2, 1}) {
            const auto pair = std::pair(triangle.vertex[corner], triangle.uv[corner]);
            const auto [it, added] = known.emplace(pair, static_cast<uint32_t>(source.size()));
            if (added) {
                source.push_back(pair.first);
                model.uvs.push_back(file_uvs[pair.second]);
            }
            model.indices.push_back(it->second);
        }
    if (uint64_t{header.frames} * source.size() > max_frame_vertices)
        fail("{}: {} frames of {} vertices are too many", name, header.frames, source.size());

    ByteReader frames(
        name, section(name, "frames", bytes, header.frames_at, header.frames, header.frame_size));
    std::vector<glm::vec3> positions(header.vertices);
    for (uint32_t i = 0; i < header.frames; ++i) {
        const glm::vec3 scale = frames.vec3(), translate = frames.vec3();
        for (size_t axis = 0; axis < 3; ++axis)
            if (!(std::abs(scale[axis]) <= max_scale && std::abs(translate[axis]) <= max_scale))
                fail("{}: frame {} has scale {} and translation {}", name, i, scale[axis],
                     translate[axis]);
        Md2Frame frame;
        frame.name = frames.text(16);
        for (glm::vec3& position : positions) {
            const float x = frames.u8(), y = frames.u8(), z = frames.u8();
            frames.skip(1); // index into the game's normal table
            position = glm::vec3(x, y, z) * scale + translate;
        }
        frames.skip(header.frame_size - frame_header_bytes - size_t{4} * header.vertices);
        const auto normals = smooth_normals(positions, triangles);
        for (const uint16_t vertex : source) {
            frame.positions.push_back(positions[vertex]);
            frame.normals.push_back(normals[vertex]);
        }
        model.frames.push_back(std::move(frame));
    }
    return model;
}

} // namespace vigil
