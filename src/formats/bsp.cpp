// SPDX-License-Identifier: GPL-2.0-or-later
// Decodes the lumps of an IBSP 38 file: a header of 19 (offset, length) pairs, then arrays of
// packed little-endian records. Bytes after the lumps (BSPX extensions, padding) are ignored.
#include "formats/bsp.h"

#include "common/error.h"
#include "formats/bsp_check.h"
#include "formats/byte_reader.h"

#include <algorithm>
#include <cmath>

namespace vigil {

namespace {

enum Lump : size_t {
    lump_entities,
    lump_planes,
    lump_vertices,
    lump_visibility,
    lump_nodes,
    lump_texinfo,
    lump_faces,
    lump_lighting,
    lump_leafs,
    lump_leaf_faces,
    lump_leaf_brushes,
    lump_edges,
    lump_surf_edges,
    lump_models,
    lump_brushes,
    lump_brush_sides,
    lump_pop, // never used by the game
    lump_areas,
    lump_area_portals,
    lump_count
};

struct LumpFormat {
    const char* name;
    uint32_t record_size; ///< bytes
};

constexpr std::array<LumpFormat, lump_count> lump_formats = {{
    {"entities", 1},      {"planes", 20},    {"vertices", 12},    {"visibility", 1},
    {"nodes", 28},        {"texinfo", 76},   {"faces", 20},       {"lighting", 1},
    {"leafs", 28},        {"leaf faces", 2}, {"leaf brushes", 2}, {"edges", 4},
    {"surface edges", 4}, {"models", 48},    {"brushes", 12},     {"brush sides", 4},
    {"pop", 1},           {"areas", 8},      {"area portals", 8},
}};

constexpr uint32_t ibsp_magic = 0x50534249; // "IBSP"
constexpr uint32_t ibsp_version = 38;

using Lumps = std::array<std::span<const uint8_t>, lump_count>;

/// Cuts the file into lumps; every lump lies inside the file and holds whole records.
Lumps read_directory(std::string_view name, std::span<const uint8_t> bytes) {
    const std::string what = fmt::format("{}: header", name);
    ByteReader reader(what, bytes);
    if (reader.u32() != ibsp_magic) fail("{}: not a Quake II level (no IBSP signature)", name);
    if (const uint32_t version = reader.u32(); version != ibsp_version)
        fail("{}: IBSP version {}, Quake II levels have version {}", name, version, ibsp_version);
    Lumps lumps;
    for (size_t i = 0; i < lump_count; ++i) {
        const uint32_t offset = reader.u32(), length = reader.u32();
        const LumpFormat& format = lump_formats[i];
        if (length == 0) continue;
        if (uint64_t{offset} + length > bytes.size())
            fail("{}: {} lump: {} bytes at offset {} do not fit into a file of {} bytes", name,
                 format.name, length, offset, bytes.size());
        if (length % format.record_size != 0)
            fail("{}: {} lump: {} bytes are not a whole number of {}-byte records", name,
                 format.name, length, format.record_size);
        lumps[i] = bytes.subspan(offset, length);
    }
    return lumps;
}

/// Decodes all records of a lump with `decode(ByteReader&) -> T`.
template <typename Decode>
auto read_records(std::string_view name, const Lumps& lumps, Lump lump, Decode decode) {
    const std::string what = fmt::format("{}: {} lump", name, lump_formats[lump].name);
    ByteReader reader(what, lumps[lump]);
    std::vector<decltype(decode(reader))> records;
    records.reserve(lumps[lump].size() / lump_formats[lump].record_size);
    while (reader.remaining() > 0)
        records.push_back(decode(reader));
    return records;
}

/// 0xffff stands for "none".
int32_t optional_index(uint16_t value) {
    return value == 0xffff ? -1 : value;
}

BspPlane read_plane(ByteReader& reader) {
    BspPlane plane;
    reader.get(plane.normal, plane.dist);
    reader.skip(4);
    // The stored type is redundant; computing it makes it true whatever the file says.
    size_t major = 0;
    for (size_t axis = 0; axis < 3; ++axis) {
        if (std::abs(plane.normal[axis]) > std::abs(plane.normal[major])) major = axis;
    }
    glm::vec3 axis_normal(0.0f);
    axis_normal[major] = 1.0f;
    plane.type = static_cast<int32_t>(plane.normal == axis_normal ? major : major + 3);
    return plane;
}

BspNode read_node(ByteReader& reader) {
    BspNode node;
    reader.get(node.plane, node.children);
    node.mins = reader.short_vec3();
    node.maxs = reader.short_vec3();
    reader.get_as<uint16_t>(node.first_face, node.face_count);
    return node;
}

BspTexInfo read_texinfo(ByteReader& reader) {
    BspTexInfo info;
    reader.get(info.s, info.t, info.flags, info.value);
    info.texture = reader.text(32);
    const int32_t next = reader.i32();
    // The game takes 0 for "none" as well: compilers that never animate leave the field zero.
    info.next = next == 0 ? -1 : next;
    return info;
}

BspFace read_face(ByteReader& reader, bool has_lightmaps) {
    BspFace face;
    reader.get_as<uint16_t>(face.plane, face.back_side);
    reader.get(face.first_edge);
    reader.get_as<uint16_t>(face.edge_count, face.texinfo);
    reader.get(face.styles, face.light_offset);
    if (!has_lightmaps) face.light_offset = -1;
    return face;
}

BspLeaf read_leaf(ByteReader& reader) {
    BspLeaf leaf;
    reader.get(leaf.contents);
    leaf.cluster = optional_index(reader.u16());
    reader.get_as<uint16_t>(leaf.area);
    leaf.mins = reader.short_vec3();
    leaf.maxs = reader.short_vec3();
    reader.get_as<uint16_t>(leaf.first_leaf_face, leaf.leaf_face_count, leaf.first_leaf_brush,
                            leaf.leaf_brush_count);
    return leaf;
}

BspModel read_model(ByteReader& reader) {
    BspModel model;
    reader.get(model.mins, model.maxs, model.origin, model.headnode, model.first_face,
               model.face_count);
    return model;
}

BspBrush read_brush(ByteReader& reader) {
    BspBrush brush;
    reader.get(brush.first_side, brush.side_count, brush.contents);
    return brush;
}

BspBrushSide read_brush_side(ByteReader& reader) {
    const uint32_t plane = reader.u16();
    return {plane, optional_index(reader.u16())};
}

BspArea read_area(ByteReader& reader) {
    BspArea area;
    reader.get(area.portal_count, area.first_portal);
    return area;
}

BspAreaPortal read_area_portal(ByteReader& reader) {
    BspAreaPortal portal;
    reader.get(portal.portal, portal.other_area);
    return portal;
}

std::array<uint32_t, 2> read_edge(ByteReader& reader) {
    std::array<uint32_t, 2> edge;
    reader.get_as<uint16_t>(edge[0], edge[1]);
    return edge;
}

/// The visibility lump starts with the number of clusters and two row offsets for each. Without
/// it, clusters are counted from the leafs.
void read_visibility(Bsp& bsp, std::span<const uint8_t> lump) {
    const std::string what = fmt::format("{}: visibility lump", bsp.name);
    ByteReader reader(what, lump);
    const uint32_t count = lump.empty() ? 0 : reader.u32();
    if (count == 0) {
        for (const BspLeaf& leaf : bsp.leafs)
            bsp.cluster_count =
                std::max(bsp.cluster_count, static_cast<uint32_t>(leaf.cluster + 1));
        return;
    }
    if (count > reader.remaining() / 8)
        fail("{}: {} clusters do not fit into {} bytes", what, count, lump.size());
    if (count > bsp_max_clusters)
        fail("{}: {} clusters are too many (limit {})", what, count, bsp_max_clusters);
    bsp.cluster_count = count;
    bsp.visibility_offsets.resize(count);
    for (size_t cluster = 0; cluster < count; ++cluster)
        for (uint32_t& offset : bsp.visibility_offsets[cluster]) {
            offset = reader.u32();
            if (offset >= lump.size())
                fail("{}: the row of cluster {} starts at byte {} of {}", what, cluster,
                     static_cast<int32_t>(offset), lump.size());
        }
    bsp.visibility.assign(lump.begin(), lump.end());
}

} // namespace

Bsp parse_bsp(std::string_view name, std::span<const uint8_t> bytes) {
    const Lumps lumps = read_directory(name, bytes);
    const auto records = [&](Lump lump, auto decode) {
        return read_records(name, lumps, lump, decode);
    };
    const auto read_u16 = [](ByteReader& reader) -> uint32_t { return reader.u16(); };
    const bool has_lightmaps = !lumps[lump_lighting].empty();

    Bsp bsp;
    bsp.name = name;
    const auto text = lumps[lump_entities];
    bsp.entities = parse_entities(name, {reinterpret_cast<const char*>(text.data()), text.size()});
    if (bsp.entities.empty()) bsp.entities.push_back({{{"classname", "worldspawn"}}});
    bsp.planes = records(lump_planes, read_plane);
    bsp.vertices = records(lump_vertices, [](ByteReader& reader) { return reader.vec3(); });
    bsp.nodes = records(lump_nodes, read_node);
    bsp.texinfos = records(lump_texinfo, read_texinfo);
    bsp.faces = records(lump_faces, [&](ByteReader& r) { return read_face(r, has_lightmaps); });
    bsp.lightmaps.assign(lumps[lump_lighting].begin(), lumps[lump_lighting].end());
    bsp.leafs = records(lump_leafs, read_leaf);
    bsp.leaf_faces = records(lump_leaf_faces, read_u16);
    bsp.leaf_brushes = records(lump_leaf_brushes, read_u16);
    bsp.edges = records(lump_edges, read_edge);
    bsp.surf_edges = records(lump_surf_edges, [](ByteReader& reader) { return reader.i32(); });
    bsp.models = records(lump_models, read_model);
    bsp.brushes = records(lump_brushes, read_brush);
    bsp.brush_sides = records(lump_brush_sides, read_brush_side);
    bsp.areas = records(lump_areas, read_area);
    bsp.area_portals = records(lump_area_portals, read_area_portal);
    // Leafs name area 0 where a level has no areas.
    if (bsp.areas.empty()) bsp.areas.push_back({});
    read_visibility(bsp, lumps[lump_visibility]);
    check_bsp(bsp);
    return bsp;
}

} // namespace vigil
