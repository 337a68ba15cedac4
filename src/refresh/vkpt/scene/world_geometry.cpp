// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/scene/world_geometry.h"

#include "formats/bsp_query.h"
#include "level/level.h"

namespace vigil::vkpt {

namespace {

constexpr uint32_t hidden_flags = SURF_NODRAW | SURF_HINT | SURF_SKIP;

// What can be seen from both sides has a face for either, in the same place, and rounding would
// choose which one a ray finds: lava would have black speckles. Each goes this far out along its
// normal (map units): more than the rounding of distances in the largest level, too little to see.
constexpr uint32_t two_sided_flags = SURF_WARP | SURF_FLOWING | SURF_TRANS33 | SURF_TRANS66;
constexpr float two_sided_gap = 1.0f / 32.0f;

/// Per face: the one cluster whose leafs it bounds, or NONE if there are several (or none).
std::vector<uint32_t> face_clusters(const Bsp& bsp) {
    constexpr uint32_t unseen = shader::NONE - 1;
    std::vector<uint32_t> clusters(bsp.faces.size(), unseen);
    for (const BspLeaf& leaf : bsp.leafs) {
        if (leaf.cluster < 0) continue;
        for (uint32_t i = 0; i < leaf.leaf_face_count; ++i) {
            uint32_t& cluster = clusters[bsp.leaf_faces[leaf.first_leaf_face + i]];
            if (cluster == unseen)
                cluster = static_cast<uint32_t>(leaf.cluster);
            else if (cluster != static_cast<uint32_t>(leaf.cluster))
                cluster = shader::NONE;
        }
    }
    for (uint32_t& cluster : clusters)
        if (cluster == unseen) cluster = shader::NONE;
    return clusters;
}

/// The light style of an emissive face: the first of its light map's styles that is neither steady
/// (0) nor unused.
int emissive_style(const BspFace& face) {
    for (const uint8_t style : face.styles)
        if (style != 0 && style != 255) return style;
    return 0;
}

} // namespace

ModelGeometry brush_model_geometry(const Level& level, uint32_t model_index,
                                   MaterialSet& materials) {
    const Bsp& bsp = level.bsp;
    const BspModel& model = bsp.models[model_index];
    const std::vector<uint32_t> clusters =
        model_index == 0 ? face_clusters(bsp)
                         : std::vector<uint32_t>(bsp.faces.size(), shader::NONE);
    ModelGeometry geometry;
    for (uint32_t f = model.first_face; f < model.first_face + model.face_count; ++f) {
        const BspFace& face = bsp.faces[f];
        const BspTexInfo& info = bsp.texinfos[face.texinfo];
        if (info.flags & hidden_flags) continue;
        const MaterialSet::WorldMaterial& material = materials.world_material(bsp, face.texinfo);
        std::vector<glm::vec3> corners = face_polygon(bsp, face);
        std::vector<glm::vec2> uvs;
        for (const glm::vec3& corner : corners)
            uvs.push_back(texel_coordinates(info, corner) / glm::vec2(material.uv_size));
        // Whole repeats do not matter; near 0 coordinates keep their digits.
        const glm::vec2 repeats = glm::floor(uvs.front());
        for (glm::vec2& uv : uvs)
            uv -= repeats;

        if (info.flags & two_sided_flags) {
            const glm::vec3 outwards = two_sided_gap * face_normal(bsp, face);
            for (glm::vec3& corner : corners)
                corner += outwards;
        }

        for (size_t i = 2; i < corners.size(); ++i) { // faces are convex: a fan
            const glm::vec3& v0 = corners[0];
            const glm::vec3& v1 = corners[i - 1];
            const glm::vec3& v2 = corners[i];
            if (glm::cross(v1 - v0, v2 - v0) == glm::vec3(0.0f)) continue; // collinear corners
            shader::Primitive& primitive =
                geometry.add({v0, v1, v2, material.coverage}, material.index);
            primitive.uv0 = uvs[0];
            primitive.uv1 = uvs[i - 1];
            primitive.uv2 = uvs[i];
            primitive.cluster = clusters[f];
            if (material.radiance != glm::vec3(0.0f))
                geometry.shine(material.radiance, emissive_style(face));
        }
    }
    return geometry;
}

std::vector<shader::BspTreeNode> cluster_tree(const Bsp& bsp) {
    const auto child = [&](int32_t index) {
        return index >= 0 ? index : -2 - bsp.leafs[static_cast<size_t>(-1 - index)].cluster;
    };
    std::vector<shader::BspTreeNode> tree;
    for (const BspNode& node : bsp.nodes) {
        const BspPlane& plane = bsp.planes[node.plane];
        tree.push_back(
            {plane.normal, plane.dist, child(node.children[0]), child(node.children[1])});
    }
    // The walk starts at node 0; a level whose root is elsewhere, or a lone leaf, gets a node in
    // front of the others.
    const int32_t root = bsp.models[0].headnode;
    if (root != 0 || tree.empty()) {
        for (shader::BspTreeNode& node : tree) {
            if (node.front >= 0) ++node.front;
            if (node.back >= 0) ++node.back;
        }
        const int32_t start = root >= 0 ? root + 1 : child(root);
        tree.insert(tree.begin(), {glm::vec3(0.0f, 0.0f, 1.0f), 0.0f, start, start});
    }
    return tree;
}

} // namespace vigil::vkpt
