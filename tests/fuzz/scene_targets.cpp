// SPDX-License-Identifier: GPL-2.0-or-later
// From the bytes of a level to all that the renderer makes of it on the host: materials, geometry,
// lights, light lists and hierarchies, each checked against what its header promises.
#include "common/file_system.h"
#include "level/level.h"
#include "refresh/vkpt/light/alias_table.h"
#include "refresh/vkpt/light/exploration.h"
#include "refresh/vkpt/light/light_hierarchy.h"
#include "refresh/vkpt/light/light_lists.h"
#include "refresh/vkpt/scene/light_set.h"
#include "refresh/vkpt/scene/top_level.h"
#include "refresh/vkpt/scene/world_geometry.h"
#include "shared/firewall.h"
#include "target.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>

namespace vigil::fuzz {

namespace {

using namespace vkpt;

bool finite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}
bool finite(const glm::vec2& v) {
    return std::isfinite(v.x) && std::isfinite(v.y);
}

void check_geometry(const ModelGeometry& geometry, const Level& level,
                    const MaterialSet& materials) {
    require(geometry.primitives.size() == geometry.triangles.size(),
            "a triangle without primitive");
    for (const BvhInputTriangle& triangle : geometry.triangles)
        require(finite(triangle.v0) && finite(triangle.v1) && finite(triangle.v2) &&
                    triangle.coverage <= 255,
                "a triangle is not finite");
    for (const shader::Primitive& primitive : geometry.primitives) {
        require(primitive.material < materials.materials().size(), "no such material");
        require(primitive.light == shader::NONE || primitive.light < geometry.lights.size(),
                "no such light");
        require(primitive.cluster == shader::NONE || primitive.cluster < level.bsp.cluster_count,
                "no such cluster");
        require(finite(primitive.uv0) && finite(primitive.uv1) && finite(primitive.uv2),
                "texture coordinates are not finite");
    }
}

void check_materials(const MaterialSet& materials, const TextureSet& textures) {
    for (const shader::Material& material : materials.materials()) {
        require(material.frame_count >= 1 &&
                    uint64_t{material.texture} + material.frame_count <= textures.headers().size(),
                "no such texture");
        require(finite(material.inverse_mean), "a material is not finite");
    }
    for (const shader::Texture& texture : textures.headers())
        require(texture.first_texel < textures.texels().size() && texture.width > 0 &&
                    texture.height > 0,
                "a texture without texels");
}

/// Walks a hierarchy: each node once, each triangle once, boxes around what they hold.
class HierarchyWalk {
public:
    explicit HierarchyWalk(const Bvh& bvh)
        : bvh_(bvh), visited_(bvh.nodes.size() / shader::BVH_RECORD_WORDS), met_(bvh.order.size()) {
        std::vector<bool> named(bvh.order.size());
        for (const uint32_t triangle : bvh.order) {
            require(triangle < named.size() && !named[triangle], "an order names a triangle twice");
            named[triangle] = true;
        }
        visit(0, 0);
        require(std::ranges::find(met_, false) == met_.end(), "a triangle in no leaf");
    }

private:
    Bounds visit(uint32_t record, uint32_t depth) {
        require(depth <= shader::BVH_MAX_DEPTH, "a hierarchy is too deep");
        require(record < visited_.size() && !visited_[record], "a record is used twice");
        visited_[record] = true;
        const glm::uvec4* words = &bvh_.nodes[size_t{record} * shader::BVH_RECORD_WORDS];
        if ((words[3].w & shader::BVH_LEAF) != 0) return leaf(words);
        const float step = std::bit_cast<float>(words[3].w & shader::BVH_STEP_MASK);
        Bounds all;
        for (uint32_t child = 0; child < 4; ++child) {
            Bounds box;
            bool point = true; // no child: an empty leaf, which nothing can be hit in
            for (glm::length_t axis = 0; axis < 3; ++axis) {
                const uint32_t interval = words[axis][child];
                const float origin = std::bit_cast<float>(words[3][axis]);
                box.lower[axis] = origin + step * static_cast<float>(interval & 0xffff);
                box.upper[axis] = origin + step * static_cast<float>(interval >> 16);
                point = point && interval == 0xffffffff;
            }
            const Bounds below =
                visit(4 * (words[3].w & shader::BVH_CHILD_NODE_MASK) + child, depth + 1);
            if (point) continue;
            require(box.contains(below), "a box does not hold what is below it");
            all.grow(below);
        }
        return all;
    }
    Bounds leaf(const glm::uvec4* words) {
        std::array<glm::vec3, 4> corner;
        for (glm::length_t i = 0; i < 3; ++i) {
            for (glm::length_t axis = 0; axis < 3; ++axis)
                corner[i][axis] = std::bit_cast<float>(words[i][axis]);
            corner[3][i] = std::bit_cast<float>(words[i][3]);
        }
        Bounds bounds;
        for (const glm::vec3& point : corner)
            bounds.grow(point);
        if (corner[0] == corner[1] && corner[0] == corner[2]) return bounds; // empty
        for (uint32_t slot = words[3].x; slot <= words[3].x + (corner[3] != corner[2] ? 1 : 0);
             ++slot) {
            require(slot < met_.size() && !met_[slot], "a triangle in two leaves, or in none");
            met_[slot] = true;
        }
        return bounds;
    }

    const Bvh& bvh_;
    std::vector<bool> visited_, met_;
};

void check_cluster_tree(const Bsp& bsp) {
    const std::vector<shader::BspTreeNode> tree = cluster_tree(bsp);
    require(!tree.empty(), "a cluster tree without a root");
    for (const shader::BspTreeNode& node : tree)
        for (const int child : {node.front, node.back})
            require(child >= 0 ? static_cast<size_t>(child) < tree.size()
                               : -2 - child < static_cast<int>(bsp.cluster_count),
                    "a child of the cluster tree is nowhere");
}

void check_lists(const LightLists& lists, const Level& level, uint32_t light_count) {
    require(lists.ranges.size() == size_t{level.bsp.cluster_count} + 1, "a cluster without a list");
    for (const LightRange& range : lists.ranges)
        require(uint64_t{range.first} + range.count <= lists.ids.size(), "a list without ids");
    // Clusters share lists: each is looked at once.
    std::vector<bool> checked(lists.ids.size() + 1);
    for (size_t list = 0; list < lists.ranges.size(); ++list) {
        if (checked[lists.ranges[list].first]) continue;
        checked[lists.ranges[list].first] = true;
        const auto ids = lists.list(list);
        require(std::ranges::adjacent_find(ids, std::greater_equal<>()) == ids.end(),
                "a list is not sorted");
        require(ids.empty() || ids.back() < light_count, "a list names no light");
    }
    require(lists.ranges.back().count == light_count, "the list of all lights lacks one");
}

/// Everything that frames make of the lights.
void check_lights(const Level& level, const LightSet& lights) {
    for (const shader::Light& light : lights.lights())
        require(finite(light.v0) && finite(light.e1) && finite(light.e2) &&
                    shader::is_finite_nonnegative(light.radiance),
                "a light is not finite");
    std::vector<LightTriangle> triangles;
    for (uint32_t id = 0; id < lights.lights().size(); ++id) {
        const shader::Light& light = lights.lights()[id];
        triangles.push_back({light.v0, light.v0 + light.e1, light.v0 + light.e2, id});
    }
    LightListLimits limits;
    limits.steps = uint64_t{1} << 24; // both sides of a limit within reach
    const LightLister lister(level.bsp, level.pvs);
    check_lists(lister.build(triangles, limits), level, static_cast<uint32_t>(triangles.size()));

    Exploration exploration;
    for (const glm::vec3& eye : {glm::vec3(0.0f), glm::vec3(1e6f)}) {
        const std::vector<float> weights = exploration.weights(lights.lights(), eye, {});
        build_alias_table(weights);
    }
    LightHierarchy hierarchy;
    hierarchy.build(lights.lights(), {});
    for (const uint32_t light : hierarchy.leaf_lights())
        require(light == shader::NONE || light < lights.lights().size(), "a leaf without a light");
}

} // namespace

void fuzz_scene(Input bytes) {
    parse_or_refuse("x.bsp", [&] {
        Level level;
        level.name = "x";
        level.bsp = parse_bsp("x.bsp", bytes);
        level.pvs = Pvs(level.bsp);
        const FileSystem files; // nothing: every texture is missing
        TextureSet textures(files);
        MaterialSet materials(files, textures);

        check_cluster_tree(level.bsp);
        LightSet lights;
        std::vector<TopLevelInstance> instances;
        std::vector<glm::uvec4> nodes;
        uint32_t first_triangle = 0;
        const size_t models = std::min<size_t>(level.bsp.models.size(), 16);
        for (uint32_t model = 0; model < models; ++model) {
            const ModelGeometry geometry = brush_model_geometry(level, model, materials);
            check_geometry(geometry, level, materials);
            const Bvh bvh = build_bvh(geometry.triangles);
            require(bvh.order.size() == geometry.triangles.size(), "a triangle too many");
            HierarchyWalk walk(bvh);
            const uint32_t root = append_bvh(bvh, first_triangle, nodes);
            first_triangle += static_cast<uint32_t>(geometry.triangles.size());
            const std::vector<float> styles(256, 1.0f);
            if (model == 0) {
                lights = LightSet(geometry.lights);
                lights.begin_frame(styles, 1.0f);
                continue;
            }
            const glm::mat4x3 here(1.0f);
            if (lights.place(model, geometry.lights, here, glm::vec3(1.0f)))
                instances.push_back({bvh.bounds, here, here, root, model});
        }
        lights.end_frame();
        check_materials(materials, textures);
        check_lights(level, lights);
        const std::vector<shader::TopNode> top = build_top_level(instances);
        for (const shader::TopNode& node : top)
            require(node.skip == shader::TOP_END || node.skip < top.size(), "a skip into nowhere");
    });
}

} // namespace vigil::fuzz
