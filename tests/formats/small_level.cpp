// SPDX-License-Identifier: GPL-2.0-or-later
// The records of the smallest level; see small_level.h. Layouts follow the IBSP 38 format and are
// written here a second time, independently of the parser.
#include "small_level.h"

namespace vigil {

namespace {

void add_plane(Bytes& out, const glm::vec3& normal, float dist, int32_t type) {
    append_vec3(out, normal);
    append(out, dist);
    append(out, type);
}

void add_shorts(Bytes& out, std::initializer_list<int> values) {
    for (const int value : values)
        append(out, static_cast<int16_t>(value));
}

void add_texinfo(Bytes& out, std::string_view name, uint32_t flags, int32_t value, int32_t next) {
    for (const float v : {1.0f, 0.0f, 0.0f, 8.0f, 0.0f, -1.0f, 0.0f, 16.0f})
        append(out, v);
    append(out, flags);
    append(out, value);
    append_text(out, name, 32);
    append(out, next);
}

void add_face(Bytes& out, uint16_t plane, int16_t side, int32_t first_edge, int16_t texinfo) {
    append(out, plane);
    append(out, side);
    append(out, first_edge);
    append<int16_t>(out, 4);
    append(out, texinfo);
    append<uint32_t>(out, 0xffffff00u); // style 0, then three unused
    append<int32_t>(out, 0);
}

void add_leaf(Bytes& out, uint32_t contents, int cluster, int first_face, int faces,
              int first_brush, int brushes) {
    append(out, contents);
    add_shorts(out, {cluster, 0, -64, -64, -64, 64, 64, 64});
    add_shorts(out, {first_face, faces, first_brush, brushes});
}

void add_model(Bytes& out, int32_t headnode, int32_t first_face, int32_t faces) {
    append_vec3(out, glm::vec3(-64));
    append_vec3(out, glm::vec3(64));
    append_vec3(out, glm::vec3(0));
    append(out, headnode);
    append(out, first_face);
    append(out, faces);
}

} // namespace

LevelLumps small_level() {
    LevelLumps lumps;
    const std::string_view entities = "{\n\"classname\" \"worldspawn\"\n\"sky\" \"court\"\n}\n"
                                      "{\n\"classname\" \"func_wall\"\n\"model\" \"*1\"\n}\n";
    append_text(lumps[level_entities], entities, entities.size() + 1);

    add_plane(lumps[level_planes], {1, 0, 0}, 0, 0);
    add_plane(lumps[level_planes], {0, 0, 1}, 0, 2);
    add_plane(lumps[level_planes], {0, 0, 1}, 64, 2);

    for (const float z : {0.0f, 64.0f})
        for (const glm::vec3& corner :
             {glm::vec3(0, 0, z), glm::vec3(0, 64, z), glm::vec3(64, 64, z), glm::vec3(64, 0, z)})
            append_vec3(lumps[level_vertices], corner);

    // Edge 0 is never used: its negative would be itself.
    const int edges[][2] = {{0, 0}, {0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}};
    for (const auto& edge : edges)
        add_shorts(lumps[level_edges], {edge[0], edge[1]});
    // Clockwise from above for the floor; backwards (clockwise from below) for the ceiling.
    for (const int32_t edge : {1, 2, 3, 4, -8, -7, -6, -5})
        append(lumps[level_surf_edges], edge);

    Bytes& visibility = lumps[level_visibility];
    append<int32_t>(visibility, 2);
    for (const int32_t offset : {20, 20, 21, 21})
        append(visibility, offset);
    append<uint8_t>(visibility, 0b01);
    append<uint8_t>(visibility, 0b11);

    append<int32_t>(lumps[level_nodes], 0);
    append<int32_t>(lumps[level_nodes], -2);
    append<int32_t>(lumps[level_nodes], -3);
    add_shorts(lumps[level_nodes], {-64, -64, -64, 64, 64, 64, 0, 2});

    add_texinfo(lumps[level_texinfo], "lamp", 1, 100, -1);
    add_texinfo(lumps[level_texinfo], "+0roof", 0, 0, 2);
    add_texinfo(lumps[level_texinfo], "+1roof", 0, 0, 1);

    add_face(lumps[level_faces], 1, 0, 0, 0);
    add_face(lumps[level_faces], 2, 1, 4, 1);
    add_face(lumps[level_faces], 1, 0, 0, 0);
    lumps[level_lighting].assign(48, 128);

    add_leaf(lumps[level_leafs], 1, -1, 0, 0, 0, 1);
    add_leaf(lumps[level_leafs], 0, 0, 0, 3, 0, 0);
    add_leaf(lumps[level_leafs], 0x20, 1, 0, 0, 0, 0);
    add_shorts(lumps[level_leaf_faces], {0, 1, 2});
    add_shorts(lumps[level_leaf_brushes], {0});

    add_model(lumps[level_models], 0, 0, 2);
    add_model(lumps[level_models], -1, 2, 1);

    for (const int32_t value : {0, 2, 1})
        append(lumps[level_brushes], value);
    add_shorts(lumps[level_brush_sides], {1, 0, 2, -1});

    for (const int32_t value : {0, 0, 1, 0})
        append(lumps[level_areas], value);
    for (const int32_t value : {1, 0})
        append(lumps[level_area_portals], value);
    return lumps;
}

Bytes write_level(const LevelLumps& lumps, size_t trailing) {
    Bytes file;
    append_text(file, "IBSP", 4);
    append<int32_t>(file, 38);
    size_t offset = level_header_size;
    for (const Bytes& lump : lumps) {
        append(file, static_cast<uint32_t>(offset));
        append(file, static_cast<uint32_t>(lump.size()));
        offset += lump.size();
    }
    for (const Bytes& lump : lumps)
        append_bytes(file, lump);
    file.resize(file.size() + trailing, 0x5a);
    return file;
}

} // namespace vigil
