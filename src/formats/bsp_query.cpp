// SPDX-License-Identifier: GPL-2.0-or-later
// Queries on a checked level; see bsp_query.h. All indices are trusted because parse_bsp checked
// them.
#include "formats/bsp_query.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace vigil {

namespace {

/// Below a node, of a line that came through a plane with this normal.
std::optional<LineHit> hit_below(const Bsp& bsp, int32_t child, glm::vec3 from, const glm::vec3& to,
                                 glm::vec3 normal) {
    while (child >= 0) {
        const BspNode& node = bsp.nodes[static_cast<size_t>(child)];
        const BspPlane& plane = bsp.planes[node.plane];
        const float before = glm::dot(plane.normal, from) - plane.dist;
        const float after = glm::dot(plane.normal, to) - plane.dist;
        const bool behind = before < 0.0f;
        child = node.children[behind ? 1 : 0];
        if (behind == (after < 0.0f)) continue;
        const glm::vec3 middle = from + (to - from) * (before / (before - after));
        if (std::optional<LineHit> hit = hit_below(bsp, child, from, middle, normal)) return hit;
        from = middle;
        normal = behind ? -plane.normal : plane.normal;
        child = node.children[behind ? 0 : 1];
    }
    const auto leaf = static_cast<uint32_t>(-1 - child);
    if ((bsp.leafs[leaf].contents & CONTENTS_SOLID) == 0) return std::nullopt;
    return LineHit{from, normal, leaf};
}

} // namespace

std::vector<glm::vec3> face_polygon(const Bsp& bsp, const BspFace& face) {
    std::vector<glm::vec3> polygon(face.edge_count);
    for (uint32_t i = 0; i < face.edge_count; ++i) {
        const int32_t edge = bsp.surf_edges[face.first_edge + i];
        const uint32_t vertex = edge >= 0 ? bsp.edges[static_cast<size_t>(edge)][0]
                                          : bsp.edges[static_cast<size_t>(-int64_t{edge})][1];
        // The file walks a face clockwise.
        polygon[face.edge_count - 1 - i] = bsp.vertices[vertex];
    }
    return polygon;
}

glm::vec3 face_normal(const Bsp& bsp, const BspFace& face) {
    const glm::vec3 normal = glm::normalize(bsp.planes[face.plane].normal);
    return face.back_side ? -normal : normal;
}

glm::vec2 texel_coordinates(const BspTexInfo& info, const glm::vec3& point) {
    return {glm::dot(glm::vec3(info.s), point) + info.s.w,
            glm::dot(glm::vec3(info.t), point) + info.t.w};
}

uint32_t leaf_at(const Bsp& bsp, const glm::vec3& point) {
    return leaf_at(bsp, point, bsp.models.front().headnode);
}

uint32_t leaf_at(const Bsp& bsp, const glm::vec3& point, int32_t headnode) {
    int32_t child = headnode;
    while (child >= 0) {
        const BspNode& node = bsp.nodes[static_cast<size_t>(child)];
        const BspPlane& plane = bsp.planes[node.plane];
        child = node.children[glm::dot(plane.normal, point) >= plane.dist ? 0 : 1];
    }
    return static_cast<uint32_t>(-1 - child);
}

int32_t cluster_at(const Bsp& bsp, const glm::vec3& point) {
    return bsp.leafs[leaf_at(bsp, point)].cluster;
}

std::optional<LineHit> first_hit(const Bsp& bsp, const glm::vec3& from, const glm::vec3& to) {
    return hit_below(bsp, bsp.models.front().headnode, from, to, glm::vec3(0.0f));
}

bool is_clear_line(const Bsp& bsp, const glm::vec3& from, const glm::vec3& to) {
    return !first_hit(bsp, from, to);
}

std::vector<uint32_t> animation_chain(const Bsp& bsp, uint32_t texinfo) {
    std::vector<uint32_t> chain{texinfo};
    while (chain.size() <= bsp_max_animation) {
        const int32_t next = bsp.texinfos[chain.back()].next;
        // A chain may lead into a loop that leaves out its start; stop at the first repetition.
        if (next < 0 || std::ranges::find(chain, static_cast<uint32_t>(next)) != chain.end()) break;
        chain.push_back(static_cast<uint32_t>(next));
    }
    return chain;
}

} // namespace vigil
