// SPDX-License-Identifier: GPL-2.0-or-later
#include "box_level.h"

#include <array>

namespace vigil {

BoxLevel::BoxLevel() {
    bsp_.name = "boxes";
    bsp_.entities.push_back({{{"classname", "worldspawn"}}});
    models_.push_back({{glm::vec3(-4096.0f), glm::vec3(4096.0f)}, {}});
    bsp_.areas.resize(2);
}

uint32_t BoxLevel::add_brush(std::span<const glm::vec4> planes, uint32_t contents,
                             uint32_t surface) {
    BspBrush brush{static_cast<uint32_t>(bsp_.brush_sides.size()),
                   static_cast<uint32_t>(planes.size()), contents};
    const int32_t texinfo = static_cast<int32_t>(bsp_.texinfos.size());
    bsp_.texinfos.push_back({});
    bsp_.texinfos.back().flags = surface;
    for (const glm::vec4& plane : planes) {
        bsp_.brush_sides.push_back({static_cast<uint32_t>(bsp_.planes.size()), texinfo});
        bsp_.planes.push_back({glm::vec3(plane), plane.w, 3});
    }
    bsp_.brushes.push_back(brush);
    const auto index = static_cast<uint32_t>(bsp_.brushes.size() - 1);
    models_.front().brushes.push_back(index);
    return index;
}

uint32_t BoxLevel::add_box(const Box& box, uint32_t contents, uint32_t surface) {
    const std::array<glm::vec4, 6> planes = {
        glm::vec4{1, 0, 0, box.maxs.x}, {-1, 0, 0, -box.mins.x}, {0, 1, 0, box.maxs.y},
        {0, -1, 0, -box.mins.y},        {0, 0, 1, box.maxs.z},   {0, 0, -1, -box.mins.z}};
    return add_brush(planes, contents, surface);
}

uint32_t BoxLevel::add_model(const Box& box, uint32_t contents) {
    const uint32_t brush = add_box(box, contents);
    models_.front().brushes.pop_back();
    models_.push_back({box, {brush}});
    return static_cast<uint32_t>(models_.size() - 1);
}

int BoxLevel::add_entity(std::initializer_list<std::pair<const char*, std::string>> pairs) {
    Entity entity;
    for (const auto& [key, value] : pairs)
        entity.set(key, value);
    bsp_.entities.push_back(entity);
    return static_cast<int>(bsp_.entities.size() - 1);
}

void BoxLevel::flood(float z, uint32_t contents) {
    water_z_ = z;
    water_contents_ = contents;
}

BoxLevel BoxLevel::with_floor(uint32_t surface) {
    BoxLevel level;
    level.add_box({{-4096, -4096, -64}, {4096, 4096, 0}}, CONTENTS_SOLID, surface);
    return level;
}

Bsp BoxLevel::build() const {
    Bsp bsp = bsp_;
    for (const Model& model : models_) {
        BspLeaf leaf;
        leaf.cluster = 0;
        leaf.first_leaf_brush = static_cast<uint32_t>(bsp.leaf_brushes.size());
        leaf.leaf_brush_count = static_cast<uint32_t>(model.brushes.size());
        bsp.leaf_brushes.insert(bsp.leaf_brushes.end(), model.brushes.begin(), model.brushes.end());
        bsp.leafs.push_back(leaf);
        BspModel placed;
        placed.mins = model.bounds.mins;
        placed.maxs = model.bounds.maxs;
        placed.headnode = -static_cast<int32_t>(bsp.leafs.size());
        bsp.models.push_back(placed);
    }
    bsp.cluster_count = 1;
    if (water_contents_ == 0) return bsp;
    // The world's tree: above and below the water, with the same brushes.
    bsp.planes.push_back({{0, 0, 1}, water_z_, 2});
    bsp.leafs.push_back(bsp.leafs.front());
    bsp.leafs.back().contents = water_contents_;
    BspNode node;
    node.plane = static_cast<uint32_t>(bsp.planes.size() - 1);
    node.children = {-1, -static_cast<int32_t>(bsp.leafs.size())};
    bsp.nodes.push_back(node);
    bsp.models.front().headnode = 0;
    return bsp;
}

} // namespace vigil
