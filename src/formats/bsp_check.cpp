// SPDX-License-Identifier: GPL-2.0-or-later
// Checks of a decoded level, lump by lump; see bsp_check.h. Limits that only the original game's
// fixed arrays had (so many faces, so many leafs) are not enforced.
#include "formats/bsp_check.h"

#include "common/error.h"
#include "formats/bsp_query.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <limits>

namespace vigil {

namespace {

/// Texture axes and offsets beyond this would overflow when multiplied by coordinates.
constexpr float max_texture_axis = 1e9f;
/// Faces may have this many corners together, most of them named again and again: the scene's
/// triangles take some hundred bytes each. Real levels have a tenth of it.
constexpr uint64_t max_face_corners = uint64_t{1} << 21;
/// Portal switches are numbered below this in Quake II.
constexpr uint32_t max_portals = 1024;

/// Names one record in messages: "maps/x.bsp: faces lump: face 12".
struct Record {
    const Bsp& bsp;
    const char* lump;
    const char* kind;
    size_t index = 0;

    template <typename... Args>
    [[noreturn]] void bad(fmt::format_string<Args...> text, Args&&... args) const {
        fail("{}: {} lump: {} {} {}", bsp.name, lump, kind, index,
             fmt::format(text, std::forward<Args>(args)...));
    }

    void uses(const char* target, uint32_t value, size_t count) const {
        // Negative indices arrive here as values above INT32_MAX; print them as they were written.
        if (value >= count) bad("uses {} {} of {}", target, static_cast<int32_t>(value), count);
    }

    /// `total` sums up the ranges of one kind.
    void uses_range(const char* target, uint32_t first, uint32_t size, size_t count,
                    uint64_t& total, uint64_t limit = bsp_max_range_total) const {
        if (uint64_t{first} + size > count)
            bad("uses {} {} more from {} on, of {}", static_cast<int32_t>(size), target,
                static_cast<int32_t>(first), count);
        total += size;
        if (total > limit)
            bad("brings the {} used so far to {}, most of them again (limit {})", target, total,
                limit);
    }

    void finite(const char* what, float value, float limit) const {
        if (!(std::abs(value) <= limit)) bad("has {} {}", what, value);
    }
    /// Traces and trees need unit normals, and distances that stay finite in sums.
    void splits_by(const BspPlane& plane, uint32_t number) const {
        const float length = glm::length(plane.normal);
        if (!(std::abs(length - 1.0f) < 0.01f))
            bad("lies on plane {}, whose normal has length {}", number, length);
        if (!(std::abs(plane.dist) <= 2.0f * bsp_max_coordinate))
            bad("lies on plane {}, which is {} units away", number, plane.dist);
    }
    void finite(const char* what, const glm::vec3& value, float limit) const {
        for (size_t axis = 0; axis < 3; ++axis)
            finite(what, value[axis], limit);
    }
};

constexpr float any_finite = std::numeric_limits<float>::max();

void check_geometry(const Bsp& bsp) {
    for (size_t i = 0; i < bsp.planes.size(); ++i) {
        const Record record{bsp, "planes", "plane", i};
        record.finite("normal", bsp.planes[i].normal, 2.0f);
        record.finite("distance", bsp.planes[i].dist, any_finite);
    }
    for (size_t i = 0; i < bsp.vertices.size(); ++i)
        Record{bsp, "vertices", "vertex", i}.finite("coordinate", bsp.vertices[i],
                                                    bsp_max_coordinate);
    for (size_t i = 0; i < bsp.edges.size(); ++i)
        for (const uint32_t vertex : bsp.edges[i])
            Record{bsp, "edges", "edge", i}.uses("vertex", vertex, bsp.vertices.size());
    for (size_t i = 0; i < bsp.surf_edges.size(); ++i) {
        const int64_t edge = bsp.surf_edges[i];
        if (std::abs(edge) >= static_cast<int64_t>(bsp.edges.size()))
            Record{bsp, "surface edges", "surface edge", i}.bad("uses edge {} of {}", edge,
                                                                bsp.edges.size());
    }
}

void check_texinfos(const Bsp& bsp) {
    for (size_t i = 0; i < bsp.texinfos.size(); ++i) {
        const Record record{bsp, "texinfo", "texinfo", i};
        const BspTexInfo& info = bsp.texinfos[i];
        for (size_t axis = 0; axis < 4; ++axis) {
            record.finite("texture axis", info.s[axis], max_texture_axis);
            record.finite("texture axis", info.t[axis], max_texture_axis);
        }
        if (info.next != -1)
            record.uses("texinfo", static_cast<uint32_t>(info.next), bsp.texinfos.size());
    }
    for (size_t i = 0; i < bsp.texinfos.size(); ++i)
        if (animation_chain(bsp, static_cast<uint32_t>(i)).size() > bsp_max_animation)
            Record{bsp, "texinfo", "texinfo", i}.bad("begins an animation of more than {} frames",
                                                     bsp_max_animation);
}

void check_faces(const Bsp& bsp) {
    uint64_t corners = 0;
    for (size_t i = 0; i < bsp.faces.size(); ++i) {
        const Record record{bsp, "faces", "face", i};
        const BspFace& face = bsp.faces[i];
        record.uses("plane", face.plane, bsp.planes.size());
        const float length = glm::length(bsp.planes[face.plane].normal);
        if (!(std::abs(length - 1.0f) < 0.01f))
            record.bad("lies on plane {}, whose normal has length {}", face.plane, length);
        if (face.edge_count < 3) record.bad("has only {} edges", face.edge_count);
        record.uses_range("surface edges", face.first_edge, face.edge_count, bsp.surf_edges.size(),
                          corners, max_face_corners);
        record.uses("texinfo", face.texinfo, bsp.texinfos.size());
        if (face.light_offset != -1)
            record.uses("light map byte", static_cast<uint32_t>(face.light_offset),
                        bsp.lightmaps.size());
    }
}

void check_leafs(const Bsp& bsp) {
    uint64_t faces = 0, brushes = 0;
    for (size_t i = 0; i < bsp.leafs.size(); ++i) {
        const Record record{bsp, "leafs", "leaf", i};
        const BspLeaf& leaf = bsp.leafs[i];
        if (leaf.cluster != -1)
            record.uses("cluster", static_cast<uint32_t>(leaf.cluster), bsp.cluster_count);
        record.uses("area", leaf.area, bsp.areas.size());
        record.uses_range("leaf faces", leaf.first_leaf_face, leaf.leaf_face_count,
                          bsp.leaf_faces.size(), faces);
        record.uses_range("leaf brushes", leaf.first_leaf_brush, leaf.leaf_brush_count,
                          bsp.leaf_brushes.size(), brushes);
    }
    for (size_t i = 0; i < bsp.leaf_faces.size(); ++i)
        Record{bsp, "leaf faces", "entry", i}.uses("face", bsp.leaf_faces[i], bsp.faces.size());
    for (size_t i = 0; i < bsp.leaf_brushes.size(); ++i)
        Record{bsp, "leaf brushes", "entry", i}.uses("brush", bsp.leaf_brushes[i],
                                                     bsp.brushes.size());
}

void check_brushes(const Bsp& bsp) {
    uint64_t sides = 0;
    for (size_t i = 0; i < bsp.brushes.size(); ++i)
        Record{bsp, "brushes", "brush", i}.uses_range("sides", bsp.brushes[i].first_side,
                                                      bsp.brushes[i].side_count,
                                                      bsp.brush_sides.size(), sides);
    for (size_t i = 0; i < bsp.brush_sides.size(); ++i) {
        const Record record{bsp, "brush sides", "side", i};
        const BspBrushSide& side = bsp.brush_sides[i];
        record.uses("plane", side.plane, bsp.planes.size());
        record.splits_by(bsp.planes[side.plane], side.plane);
        if (side.texinfo != -1)
            record.uses("texinfo", static_cast<uint32_t>(side.texinfo), bsp.texinfos.size());
    }
}

/// A trace may meet every brush of every leaf, and looks at all their sides.
void check_sides_in_leafs(const Bsp& bsp) {
    uint64_t sides = 0;
    for (size_t i = 0; i < bsp.leafs.size(); ++i) {
        const BspLeaf& leaf = bsp.leafs[i];
        for (uint32_t entry = 0; entry < leaf.leaf_brush_count; ++entry)
            sides += bsp.brushes[bsp.leaf_brushes[leaf.first_leaf_brush + entry]].side_count;
        if (sides > bsp_max_range_total)
            Record{bsp, "leafs", "leaf", i}.bad(
                "brings the sides of brushes in leafs to {}, most of them again (limit {})", sides,
                bsp_max_range_total);
    }
}

void check_areas(const Bsp& bsp) {
    uint64_t portals = 0;
    for (size_t i = 0; i < bsp.areas.size(); ++i)
        Record{bsp, "areas", "area", i}.uses_range("area portals", bsp.areas[i].first_portal,
                                                   bsp.areas[i].portal_count,
                                                   bsp.area_portals.size(), portals);
    for (size_t i = 0; i < bsp.area_portals.size(); ++i) {
        const Record record{bsp, "area portals", "area portal", i};
        record.uses("portal", bsp.area_portals[i].portal, max_portals);
        record.uses("area", bsp.area_portals[i].other_area, bsp.areas.size());
    }
}

/// A child or headnode: a node >= 0 or a leaf -1 - index.
void check_child(const Record& record, const Bsp& bsp, int32_t child) {
    if (child >= 0)
        record.uses("node", static_cast<uint32_t>(child), bsp.nodes.size());
    else
        record.uses("leaf", static_cast<uint32_t>(-1 - child), bsp.leafs.size());
}

/// Every node has at most one parent, and following parents ends after at most bsp_max_depth
/// steps: the nodes form trees. Leafs may be shared (compilers share solid ones).
void check_trees(const Bsp& bsp) {
    constexpr uint32_t none = ~0u;
    std::vector<uint32_t> parent(bsp.nodes.size(), none);
    for (size_t i = 0; i < bsp.nodes.size(); ++i)
        for (const int32_t child : bsp.nodes[i].children) {
            if (child < 0) continue;
            uint32_t& known = parent[static_cast<size_t>(child)];
            if (known != none)
                Record{bsp, "nodes", "node", static_cast<size_t>(child)}.bad(
                    "hangs below two parents, {} and {}", known, i);
            known = static_cast<uint32_t>(i);
        }

    std::vector<uint32_t> depth(bsp.nodes.size(), 0); // 0: not known yet; a root has depth 1
    std::vector<uint32_t> path;
    for (size_t i = 0; i < bsp.nodes.size(); ++i) {
        path.clear();
        uint32_t node = static_cast<uint32_t>(i);
        while (node != none && depth[node] == 0) {
            if (path.size() > bsp_max_depth)
                Record{bsp, "nodes", "node", i}.bad("lies in a loop, or deeper than {} levels",
                                                    bsp_max_depth);
            path.push_back(node);
            node = parent[node];
        }
        uint32_t known = node == none ? 0 : depth[node];
        for (; !path.empty(); path.pop_back()) {
            if (++known > bsp_max_depth)
                Record{bsp, "nodes", "node", path.back()}.bad("lies deeper than {} levels",
                                                              bsp_max_depth);
            depth[path.back()] = known;
        }
    }
}

void check_nodes(const Bsp& bsp) {
    uint64_t faces = 0;
    for (size_t i = 0; i < bsp.nodes.size(); ++i) {
        const Record record{bsp, "nodes", "node", i};
        const BspNode& node = bsp.nodes[i];
        record.uses("plane", node.plane, bsp.planes.size());
        record.splits_by(bsp.planes[node.plane], node.plane);
        record.uses_range("faces", node.first_face, node.face_count, bsp.faces.size(), faces);
        for (const int32_t child : node.children)
            check_child(record, bsp, child);
    }
    check_trees(bsp);
}

void check_models(const Bsp& bsp) {
    if (bsp.models.empty()) fail("{}: models lump: empty, not even the world is there", bsp.name);
    uint64_t faces = 0;
    for (size_t i = 0; i < bsp.models.size(); ++i) {
        const Record record{bsp, "models", "model", i};
        const BspModel& model = bsp.models[i];
        record.finite("bound", model.mins, any_finite);
        record.finite("bound", model.maxs, any_finite);
        record.finite("origin", model.origin, bsp_max_coordinate);
        check_child(record, bsp, model.headnode);
        record.uses_range("faces", model.first_face, model.face_count, bsp.faces.size(), faces);
    }
}

} // namespace

void check_bsp(const Bsp& bsp) {
    check_geometry(bsp);
    check_texinfos(bsp);
    check_faces(bsp);
    check_leafs(bsp);
    check_brushes(bsp);
    check_sides_in_leafs(bsp);
    check_areas(bsp);
    check_nodes(bsp);
    check_models(bsp);
}

} // namespace vigil
