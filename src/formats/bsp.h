// SPDX-License-Identifier: GPL-2.0-or-later
// A Quake II level (IBSP, version 38): all 19 lumps of the file as checked vectors. Every index,
// offset and float is verified once, in parse_bsp; whoever holds a Bsp never re-checks. It does not
// build geometry (bsp_query.h) nor decompress visibility (level/pvs.h), and it skips BSPX lumps.
#pragma once

#include "formats/entity.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace vigil {

/// Surface flags of a texinfo (TexInfo::flags).
enum SurfaceFlag : uint32_t {
    SURF_LIGHT = 0x1,           ///< emits light when TexInfo::value > 0
    SURF_SLICK = 0x2,           ///< low friction
    SURF_SKY = 0x4,             ///< the sky box shows through
    SURF_WARP = 0x8,            ///< liquid: texture coordinates wobble
    SURF_TRANS33 = 0x10,        ///< drawn at 33 % opacity
    SURF_TRANS66 = 0x20,        ///< drawn at 66 % opacity
    SURF_FLOWING = 0x40,        ///< the texture scrolls
    SURF_NODRAW = 0x80,         ///< never drawn
    SURF_HINT = 0x100,          ///< compiler hint, never drawn
    SURF_SKIP = 0x200,          ///< compiler hint, never drawn
    SURF_ALPHATEST = 0x2000000, ///< texture alpha cuts holes (extension used by source ports)
};

/// Contents of a leaf or a brush.
enum ContentsFlag : uint32_t {
    CONTENTS_SOLID = 0x1,
    CONTENTS_WINDOW = 0x2,
    CONTENTS_LAVA = 0x8,
    CONTENTS_SLIME = 0x10,
    CONTENTS_WATER = 0x20,
    CONTENTS_PLAYERCLIP = 0x10000,
    CONTENTS_CURRENT_0 = 0x40000,
    CONTENTS_CURRENT_90 = 0x80000,
    CONTENTS_CURRENT_180 = 0x100000,
    CONTENTS_CURRENT_270 = 0x200000,
    CONTENTS_CURRENT_UP = 0x400000,
    CONTENTS_CURRENT_DOWN = 0x800000,
    CONTENTS_MONSTER = 0x2000000,
    CONTENTS_DEADMONSTER = 0x4000000,
    CONTENTS_LADDER = 0x20000000,
};

/// The plane dot(normal, p) = dist. `type` 0..2: normal is exactly +x, +y, +z; 3..5: nearest axis.
struct BspPlane {
    glm::vec3 normal{0.0f};
    float dist = 0.0f;
    int32_t type = 0;
};

/// Inner node of a BSP tree. A child >= 0 is a node, a child < 0 is leaf -1 - child.
/// children[0] lies in front of the plane (dot(normal, p) >= dist).
struct BspNode {
    uint32_t plane = 0;
    std::array<int32_t, 2> children{};
    glm::vec3 mins{0.0f}, maxs{0.0f};
    uint32_t first_face = 0, face_count = 0; ///< faces that lie on the node's plane
};

/// Texture projection of faces: texel coordinates are (dot(p, s.xyz) + s.w, dot(p, t.xyz) + t.w).
struct BspTexInfo {
    glm::vec4 s{0.0f}, t{0.0f};
    uint32_t flags = 0;  ///< SurfaceFlag bits
    int32_t value = 0;   ///< emitted light when SURF_LIGHT is set, in Quake's light units
    std::string texture; ///< name below textures/, without an extension, as spelt in the file
    int32_t next = -1;   ///< next texinfo of an animation, -1: none; chains may be cyclic
};

/// A flat polygon with at least three edges. Its area may be zero: compilers leave a few faces
/// whose corners lie on a line.
struct BspFace {
    uint32_t plane = 0;
    bool back_side = false;  ///< the face looks against its plane's normal
    uint32_t first_edge = 0; ///< into Bsp::surf_edges
    uint32_t edge_count = 0;
    uint32_t texinfo = 0;
    std::array<uint8_t, 4> styles{}; ///< light styles of its light maps, 255: unused
    int32_t light_offset = -1;       ///< into Bsp::lightmaps, -1: no light map
};

/// A convex cell of the level. Faces and brushes are ranges of leaf_faces and leaf_brushes.
struct BspLeaf {
    uint32_t contents = 0; ///< ContentsFlag bits
    int32_t cluster = -1;  ///< -1: in no cluster (solid, or outside the level)
    uint32_t area = 0;
    glm::vec3 mins{0.0f}, maxs{0.0f};
    uint32_t first_leaf_face = 0, leaf_face_count = 0;
    uint32_t first_leaf_brush = 0, leaf_brush_count = 0;
};

/// models[0] is the world, models[n] is the brush model "*n" of an entity.
struct BspModel {
    glm::vec3 mins{0.0f}, maxs{0.0f};
    glm::vec3 origin{0.0f};
    int32_t headnode = 0; ///< a node, or -1 - leaf as in BspNode::children
    uint32_t first_face = 0, face_count = 0;
};

/// Intersection of the half spaces behind its sides' planes.
struct BspBrush {
    uint32_t first_side = 0, side_count = 0;
    uint32_t contents = 0;
};

struct BspBrushSide {
    uint32_t plane = 0;
    int32_t texinfo = -1; ///< -1: none (a bevel that only collision uses)
};

struct BspArea {
    uint32_t first_portal = 0, portal_count = 0; ///< into Bsp::area_portals
};

struct BspAreaPortal {
    uint32_t portal = 0;     ///< number of the door-like switch that opens it
    uint32_t other_area = 0; ///< the area behind it
};

struct Bsp {
    std::string name;             ///< as given to parse_bsp, for messages
    std::vector<Entity> entities; ///< entities[0] is the worldspawn; never empty
    std::vector<BspPlane> planes;
    std::vector<glm::vec3> vertices;
    std::vector<uint8_t> visibility; ///< the whole lump; empty: everything sees everything
    /// Per cluster: offset into `visibility` of its compressed potentially visible row [0] and
    /// potentially hearable row [1]. Both lie inside the lump.
    std::vector<std::array<uint32_t, 2>> visibility_offsets;
    /// Clusters are 0..cluster_count-1. Counted from the leafs where the lump is missing.
    uint32_t cluster_count = 0;
    std::vector<BspNode> nodes;
    std::vector<BspTexInfo> texinfos;
    std::vector<BspFace> faces;
    std::vector<uint8_t> lightmaps; ///< RGB bytes; Vigil does not light with them
    std::vector<BspLeaf> leafs;
    /// Faces that touch a leaf. May name faces of brush models (compilers list them in leafs of
    /// cluster 0): skip indices >= models[0].face_count for the static world.
    std::vector<uint32_t> leaf_faces;
    std::vector<uint32_t> leaf_brushes;
    std::vector<std::array<uint32_t, 2>> edges; ///< vertex pairs
    std::vector<int32_t> surf_edges; ///< edge index; negative: the edge -e, walked backwards
    std::vector<BspModel> models;    ///< at least one
    std::vector<BspBrush> brushes;
    std::vector<BspBrushSide> brush_sides;
    std::vector<BspArea> areas; ///< at least one
    std::vector<BspAreaPortal> area_portals;

    const Entity& worldspawn() const { return entities.front(); }
};

/// Trees deeper than this are refused, so that recursion over a checked tree is safe.
inline constexpr uint32_t bsp_max_depth = 1024;
/// More clusters than this are refused: decompressed visibility takes a bit for each pair of them,
/// 128 MiB here. Real levels have some thousands.
inline constexpr uint32_t bsp_max_clusters = 32768;
/// Longer animations of textures are refused: every frame may begin one of its own.
inline constexpr uint32_t bsp_max_animation = 64;
/// Records of one lump may name overlapping ranges of another (corners of faces, faces of leafs,
/// ...); ranges of one kind that are longer than this together are refused. Real levels stay below
/// a hundredth of it.
inline constexpr uint64_t bsp_max_range_total = uint64_t{1} << 23;
/// Vertex coordinates beyond this are refused; sums and products of coordinates stay finite.
inline constexpr float bsp_max_coordinate = 1048576.0f;

/// Parses and checks a whole level. `name` appears in messages. Throws Error naming lump and fault.
/// Levels without visibility, light maps, entities or areas are accepted.
Bsp parse_bsp(std::string_view name, std::span<const uint8_t> bytes);

/// True where the texinfo says "emits light" (and is neither sky nor hidden).
inline bool is_emissive(const BspTexInfo& info) {
    return (info.flags & SURF_LIGHT) != 0 && info.value > 0 &&
           (info.flags & (SURF_SKY | SURF_NODRAW)) == 0;
}

} // namespace vigil
