// SPDX-License-Identifier: GPL-2.0-or-later
// The level parser on a hand-made level: every field arrives, every kind of damage is named. Real
// levels are tested in real_levels_test.cpp, random damage in damage_test.cpp.
#include "fault.h"
#include "formats/bsp_query.h"
#include "small_level.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include <limits>

namespace vigil {
namespace {

Bsp parse(const LevelLumps& lumps) {
    return parse_bsp("maps/x.bsp", write_level(lumps));
}

TEST(Bsp, EveryLumpArrives) {
    const Bsp bsp = parse_bsp("maps/x.bsp", write_level(small_level(), 100));
    EXPECT_EQ(bsp.entities.size(), 2u);
    EXPECT_EQ(bsp.worldspawn().get_string("sky"), "court");
    EXPECT_EQ(bsp.planes.size(), 3u);
    EXPECT_EQ(bsp.planes[2].type, 2);
    EXPECT_EQ(bsp.vertices[2], glm::vec3(64, 64, 0));
    EXPECT_EQ(bsp.cluster_count, 2u);
    EXPECT_EQ(bsp.visibility_offsets.size(), 2u);
    EXPECT_EQ(bsp.nodes[0].children, (std::array<int32_t, 2>{-2, -3}));
    EXPECT_EQ(bsp.nodes[0].maxs, glm::vec3(64));
    EXPECT_EQ(bsp.texinfos[0].texture, "lamp");
    EXPECT_EQ(bsp.texinfos[0].value, 100);
    EXPECT_TRUE(is_emissive(bsp.texinfos[0]));
    EXPECT_FALSE(is_emissive(bsp.texinfos[1]));
    EXPECT_EQ(bsp.faces[1].edge_count, 4u);
    EXPECT_TRUE(bsp.faces[1].back_side);
    EXPECT_EQ(bsp.faces[0].styles, (std::array<uint8_t, 4>{0, 255, 255, 255}));
    EXPECT_EQ(bsp.lightmaps.size(), 48u);
    EXPECT_EQ(bsp.leafs[0].cluster, -1);
    EXPECT_EQ(bsp.leafs[1].leaf_face_count, 3u);
    EXPECT_EQ(bsp.leafs[2].contents, uint32_t{CONTENTS_WATER});
    EXPECT_EQ(bsp.leaf_faces, (std::vector<uint32_t>{0, 1, 2}));
    EXPECT_EQ(bsp.leaf_brushes, (std::vector<uint32_t>{0}));
    EXPECT_EQ(bsp.models[0].face_count, 2u);
    EXPECT_EQ(bsp.models[1].headnode, -1);
    EXPECT_EQ(bsp.brushes[0].side_count, 2u);
    EXPECT_EQ(bsp.brush_sides[1].texinfo, -1);
    EXPECT_EQ(bsp.areas.size(), 2u);
    EXPECT_EQ(bsp.area_portals[0].portal, 1u);
}

TEST(Bsp, PolygonsTurnCounterClockwiseAroundTheirNormal) {
    const Bsp bsp = parse(small_level());
    EXPECT_EQ(face_normal(bsp, bsp.faces[0]), glm::vec3(0, 0, 1));
    EXPECT_EQ(face_normal(bsp, bsp.faces[1]), glm::vec3(0, 0, -1));
    for (const BspFace& face : bsp.faces) {
        const auto p = face_polygon(bsp, face);
        ASSERT_EQ(p.size(), 4u);
        const glm::vec3 area = glm::cross(p[1] - p[0], p[2] - p[0]);
        EXPECT_EQ(area, 64.0f * 64.0f * face_normal(bsp, face));
    }
}

TEST(Bsp, PointsFindTheirLeafAndTexel) {
    const Bsp bsp = parse(small_level());
    EXPECT_EQ(leaf_at(bsp, {1, 5, 5}), 1u);
    EXPECT_EQ(leaf_at(bsp, {0, 5, 5}), 1u) << "a plane belongs to its front";
    EXPECT_EQ(leaf_at(bsp, {-1, 5, 5}), 2u);
    EXPECT_EQ(leaf_at(bsp, {1, 5, 5}, bsp.models[1].headnode), 0u);
    EXPECT_EQ(cluster_at(bsp, {-1, 5, 5}), 1);
    EXPECT_EQ(texel_coordinates(bsp.texinfos[0], {10, 3, 9}), glm::vec2(18, 13));
}

TEST(Bsp, AnimationChainsEndWhereTheyClose) {
    const Bsp bsp = parse(small_level());
    EXPECT_EQ(animation_chain(bsp, 0), (std::vector<uint32_t>{0}));
    EXPECT_EQ(animation_chain(bsp, 1), (std::vector<uint32_t>{1, 2}));
    EXPECT_EQ(animation_chain(bsp, 2), (std::vector<uint32_t>{2, 1}));
}

TEST(Bsp, AnimationChainsMayCloseBehindTheirStart) {
    LevelLumps lumps = small_level();
    patch<int32_t>(lumps[level_texinfo], 72, 1); // 0 -> 1 -> 2 -> 1
    EXPECT_EQ(animation_chain(parse(lumps), 0), (std::vector<uint32_t>{0, 1, 2}));
}

TEST(Bsp, OptionalLumpsMayBeMissing) {
    LevelLumps lumps = small_level();
    for (const LevelLump lump : {level_entities, level_visibility, level_lighting, level_areas,
                                 level_area_portals, level_pop})
        lumps[lump].clear();
    const Bsp bsp = parse(lumps);
    EXPECT_EQ(bsp.worldspawn().classname(), "worldspawn");
    EXPECT_EQ(bsp.cluster_count, 2u) << "counted from the leafs";
    EXPECT_TRUE(bsp.visibility_offsets.empty());
    EXPECT_EQ(bsp.faces[0].light_offset, -1);
    EXPECT_EQ(bsp.areas.size(), 1u);
}

TEST(Bsp, OtherFilesAreRefusedByName) {
    const auto refuse = [](std::string_view part, const Bytes& bytes) {
        expect_fault("maps/x.bsp", part, [&] { parse_bsp("maps/x.bsp", bytes); });
    };
    refuse("header: ends after 0 bytes", {});
    Bytes file = write_level(small_level());
    refuse("do not fit into a file of 100 bytes", Bytes(file.begin(), file.begin() + 100));
    patch<int32_t>(file, 4, 29);
    refuse("IBSP version 29", file);
    file[0] = 'V';
    refuse("not a Quake II level", file);
}

TEST(Bsp, LumpsMustLieInTheFileInWholeRecords) {
    for (size_t lump = 0; lump < level_lump_count; ++lump) {
        Bytes file = write_level(small_level());
        patch<uint32_t>(file, 8 + 8 * lump, 0xfffffff0u);
        patch<uint32_t>(file, 12 + 8 * lump, 0x20u); // the sum wraps around 32 bits
        expect_fault("maps/x.bsp", "do not fit into a file",
                     [&] { parse_bsp("maps/x.bsp", file); });
        if (level_record_sizes[lump] == 1) continue;
        LevelLumps lumps = small_level();
        lumps[lump].push_back(0);
        expect_fault("maps/x.bsp", "not a whole number", [&] { parse(lumps); });
    }
}

/// One damaged field: the value written at `offset` of a lump and what the message must say.
struct Damage {
    LevelLump lump;
    size_t offset;
    size_t size;
    int64_t value;
    const char* message;
};

class BspDamage : public testing::TestWithParam<Damage> {};

TEST_P(BspDamage, IsNamed) {
    const Damage& damage = GetParam();
    LevelLumps lumps = small_level();
    ASSERT_LE(damage.offset + damage.size, lumps[damage.lump].size());
    std::memcpy(lumps[damage.lump].data() + damage.offset, &damage.value, damage.size);
    expect_fault("maps/x.bsp", damage.message, [&] { parse(lumps); });
}

constexpr int64_t float_nan = 0x7fc00000, float_infinity = 0x7f800000, float_huge = 0x7f000000;

INSTANTIATE_TEST_SUITE_P(
    Indices, BspDamage,
    testing::Values(
        Damage{level_planes, 4, 4, float_nan, "planes lump: plane 0 has normal nan"},
        Damage{level_planes, 12, 4, float_infinity, "planes lump: plane 0 has distance inf"},
        Damage{level_vertices, 12, 4, float_huge, "vertices lump: vertex 1 has coordinate"},
        Damage{level_vertices, 8, 4, float_nan, "vertices lump: vertex 0 has coordinate nan"},
        Damage{level_visibility, 0, 4, 3, "visibility lump: 3 clusters do not fit"},
        Damage{level_visibility, 0, 4, -1, "visibility lump: 4294967295 clusters do not fit"},
        Damage{level_visibility, 0, 4, 1, "leafs lump: leaf 2 uses cluster 1 of 1"},
        Damage{level_visibility, 4, 4, 22, "the row of cluster 0 starts at byte 22 of 22"},
        Damage{level_visibility, 16, 4, -1, "the row of cluster 1 starts at byte -1"},
        Damage{level_nodes, 0, 4, 3, "nodes lump: node 0 uses plane 3 of 3"},
        Damage{level_nodes, 4, 4, 1, "nodes lump: node 0 uses node 1 of 1"},
        Damage{level_nodes, 4, 4, 0, "nodes lump: node 0 lies in a loop"},
        Damage{level_nodes, 8, 4, -4, "nodes lump: node 0 uses leaf 3 of 3"},
        Damage{level_nodes, 8, 4, INT32_MIN, "nodes lump: node 0 uses leaf"},
        Damage{level_nodes, 26, 2, 4, "nodes lump: node 0 uses 4 faces more from 0 on, of 3"},
        Damage{level_texinfo, 4, 4, float_nan, "texinfo lump: texinfo 0 has texture axis nan"},
        Damage{level_texinfo, 72, 4, 3, "texinfo lump: texinfo 0 uses texinfo 3 of 3"},
        Damage{level_texinfo, 72, 4, -2, "texinfo lump: texinfo 0 uses texinfo -2 of 3"},
        Damage{level_faces, 20, 2, 3, "faces lump: face 1 uses plane 3 of 3"},
        Damage{level_faces, 4, 4, -1, "faces lump: face 0 uses 4 surface edges more from -1"},
        Damage{level_faces, 4, 4, 5, "faces lump: face 0 uses 4 surface edges more from 5"},
        Damage{level_faces, 8, 2, 2, "faces lump: face 0 has only 2 edges"},
        Damage{level_faces, 10, 2, 3, "faces lump: face 0 uses texinfo 3 of 3"},
        Damage{level_faces, 16, 4, 48, "faces lump: face 0 uses light map byte 48 of 48"},
        Damage{level_faces, 16, 4, -2, "faces lump: face 0 uses light map byte -2 of 48"},
        Damage{level_leafs, 32, 2, 2, "leafs lump: leaf 1 uses cluster 2 of 2"},
        Damage{level_leafs, 32, 2, -2, "leafs lump: leaf 1 uses cluster 65534 of 2"},
        Damage{level_leafs, 34, 2, 2, "leafs lump: leaf 1 uses area 2 of 2"},
        Damage{level_leafs, 48, 2, 1, "leafs lump: leaf 1 uses 3 leaf faces more from 1"},
        Damage{level_leafs, 26, 2, 2, "leafs lump: leaf 0 uses 2 leaf brushes more from 0"},
        Damage{level_leaf_faces, 2, 2, 3, "leaf faces lump: entry 1 uses face 3 of 3"},
        Damage{level_leaf_brushes, 0, 2, 1, "leaf brushes lump: entry 0 uses brush 1 of 1"},
        Damage{level_edges, 6, 2, 8, "edges lump: edge 1 uses vertex 8 of 8"},
        Damage{level_surf_edges, 0, 4, 9, "surface edges lump: surface edge 0 uses edge 9 of 9"},
        Damage{level_surf_edges, 4, 4, -9, "surface edge 1 uses edge -9 of 9"},
        Damage{level_surf_edges, 4, 4, INT32_MIN, "surface edge 1 uses edge -2147483648 of 9"},
        Damage{level_models, 0, 4, float_nan, "models lump: model 0 has bound nan"},
        Damage{level_models, 36, 4, 1, "models lump: model 0 uses node 1 of 1"},
        Damage{level_models, 92, 4, 2, "models lump: model 1 uses 2 faces more from 2 on, of 3"},
        Damage{level_brushes, 4, 4, 3, "brushes lump: brush 0 uses 3 sides more from 0 on, of 2"},
        Damage{level_brush_sides, 0, 2, 3, "brush sides lump: side 0 uses plane 3 of 3"},
        Damage{level_brush_sides, 6, 2, 3, "brush sides lump: side 1 uses texinfo 3 of 3"},
        Damage{level_areas, 8, 4, 2, "areas lump: area 1 uses 2 area portals more from 0"},
        Damage{level_area_portals, 0, 4, -1, "area portals lump: area portal 0 uses portal -1"},
        Damage{level_area_portals, 4, 4, 2, "area portals lump: area portal 0 uses area 2 of 2"}));

TEST(Bsp, NodesAndBrushSidesNeedPlanesThatSplit) {
    LevelLumps lumps = small_level();
    patch<float>(lumps[level_planes], 0, 2.0f);
    expect_fault("maps/x.bsp", "nodes lump: node 0 lies on plane 0, whose normal has length 2",
                 [&] { parse(lumps); });
    lumps = small_level();
    patch<float>(lumps[level_planes], 12, 1e8f);
    expect_fault("maps/x.bsp", "nodes lump: node 0 lies on plane 0, which is 100000000 units away",
                 [&] { parse(lumps); });
    lumps = small_level();
    patch<float>(lumps[level_planes], 52, -1e8f);
    expect_fault("maps/x.bsp", "brush sides lump: side 1 lies on plane 2, which is",
                 [&] { parse(lumps); });
}

TEST(Bsp, FacesNeedPlanesWithAUnitNormal) {
    LevelLumps lumps = small_level();
    patch<float>(lumps[level_planes], 28, 0.5f);
    expect_fault("maps/x.bsp", "faces lump: face 0 lies on plane 1, whose normal has length 0.5",
                 [&] { parse(lumps); });
}

TEST(Bsp, ALevelNeedsAWorld) {
    LevelLumps lumps = small_level();
    lumps[level_models].clear();
    expect_fault("maps/x.bsp", "models lump: empty", [&] { parse(lumps); });
}

/// Replaces the node lump by `children` (all on plane 0).
void set_nodes(LevelLumps& lumps, const std::vector<std::array<int32_t, 2>>& children) {
    lumps[level_nodes].clear();
    for (const auto& pair : children) {
        append<int32_t>(lumps[level_nodes], 0);
        append(lumps[level_nodes], pair[0]);
        append(lumps[level_nodes], pair[1]);
        lumps[level_nodes].resize(lumps[level_nodes].size() + 16, 0);
    }
}

std::vector<std::array<int32_t, 2>> chain_of_nodes(int32_t length) {
    std::vector<std::array<int32_t, 2>> children;
    for (int32_t i = 0; i < length; ++i)
        children.push_back({i + 1 < length ? i + 1 : -2, -3});
    return children;
}

TEST(Bsp, NodesMustFormTrees) {
    LevelLumps lumps = small_level();
    set_nodes(lumps, {{1, 2}, {2, -2}, {-2, -3}});
    expect_fault("maps/x.bsp", "nodes lump: node 2 hangs below two parents, 0 and 1",
                 [&] { parse(lumps); });
    set_nodes(lumps, {{1, 1}, {-2, -3}});
    expect_fault("maps/x.bsp", "node 1 hangs below two parents", [&] { parse(lumps); });
    set_nodes(lumps, {{-2, -3}, {2, -3}, {3, -3}, {1, -3}}); // a loop nobody reaches
    expect_fault("maps/x.bsp", "lies in a loop", [&] { parse(lumps); });
    set_nodes(lumps, {{2, 1}, {-2, -3}, {-2, -3}});
    EXPECT_NO_THROW(parse(lumps)) << "leafs may be shared";
}

TEST(Bsp, TreesMayBeDeepButNotDeeperThanTheLimit) {
    LevelLumps lumps = small_level();
    set_nodes(lumps, chain_of_nodes(bsp_max_depth));
    EXPECT_NO_THROW(parse(lumps));
    set_nodes(lumps, chain_of_nodes(bsp_max_depth + 1));
    expect_fault("maps/x.bsp", "deeper than 1024 levels", [&] { parse(lumps); });
    // The same chain stored from its end, so that depths are known before their ancestors are.
    auto children = chain_of_nodes(bsp_max_depth + 1);
    const int32_t last = static_cast<int32_t>(children.size()) - 1;
    std::reverse(children.begin(), children.end());
    for (auto& pair : children)
        if (pair[0] >= 0) pair[0] = last - pair[0];
    set_nodes(lumps, children);
    patch<int32_t>(lumps[level_models], 36, last);
    expect_fault("maps/x.bsp", "deeper than 1024 levels", [&] { parse(lumps); });
}

TEST(Bsp, ClustersAreLimited) {
    LevelLumps lumps = small_level();
    lumps[level_visibility].assign(4 + 8 * 40'000, 0);
    patch<uint32_t>(lumps[level_visibility], 0, 32'769);
    expect_fault("x.bsp", "visibility lump: 32769 clusters are too many (limit 32768)",
                 [&] { parse_bsp("x.bsp", write_level(lumps)); });
}

TEST(Bsp, AnimationsAreLimited) {
    LevelLumps lumps = small_level();
    Bytes& texinfos = lumps[level_texinfo];
    const Bytes one(texinfos.begin(), texinfos.begin() + 76);
    while (texinfos.size() < 76u * 80) {
        append_bytes(texinfos, one);
        patch(texinfos, texinfos.size() - 4, static_cast<int32_t>(texinfos.size() / 76) % 80);
    }
    expect_fault("x.bsp", "begins an animation of more than 64 frames",
                 [&] { parse_bsp("x.bsp", write_level(lumps)); });
}

TEST(Bsp, RangesThatOverlapAreLimitedTogether) {
    // 20 bytes for each face, 65535 corners each: the same ones.
    LevelLumps lumps = small_level();
    for (int i = 0; i < 65'535; ++i)
        append<int32_t>(lumps[level_surf_edges], 0);
    Bytes face(lumps[level_faces].begin(), lumps[level_faces].begin() + 20);
    patch<uint32_t>(face, 4, 0);
    patch<uint16_t>(face, 8, 65'535);
    for (int i = 0; i < 200; ++i)
        append_bytes(lumps[level_faces], face);
    expect_fault("x.bsp", "surface edges used so far to",
                 [&] { parse_bsp("x.bsp", write_level(lumps)); });
}

} // namespace
} // namespace vigil
