// SPDX-License-Identifier: GPL-2.0-or-later
// The walk through a level; see level_walk.h.
#include "level_walk.h"

#include "formats/bsp_query.h"
#include "game/game.h"
#include "level/pvs.h"

namespace vigil {

namespace {

/// A quarter of a second of play: everything is used once, and the player walks, jumps and shoots.
float play_level(const Bsp& bsp) {
    auto level = std::make_shared<Level>();
    level->bsp = bsp;
    Game game(level, glm::vec3(1.0f, 2.0f, 40.0f));
    for (const auto& actor : game.actors())
        if (!actor->removed()) actor->use();
    PlayerCommand command;
    command.forward = 400.0f;
    command.attack = true;
    for (int i = 0; i < player::ticks_per_second / 4; ++i) {
        command.angles.y = static_cast<float>(7 * i);
        command.up = i % 10 == 0 ? 200.0f : 0.0f;
        game.tick(command);
    }
    return game.player().origin.x;
}

} // namespace

float walk_level(const Bsp& bsp) {
    const Pvs pvs(bsp);
    float sum = 0.0f;
    for (const BspFace& face : bsp.faces) {
        for (const glm::vec3& corner : face_polygon(bsp, face))
            sum += texel_coordinates(bsp.texinfos[face.texinfo], corner).x;
        sum += face_normal(bsp, face).x;
        sum += static_cast<float>(animation_chain(bsp, face.texinfo).size());
    }
    for (const BspLeaf& leaf : bsp.leafs) {
        for (uint32_t i = 0; i < leaf.leaf_face_count; ++i)
            sum += static_cast<float>(bsp.faces[bsp.leaf_faces[leaf.first_leaf_face + i]].plane);
        for (uint32_t i = 0; i < leaf.leaf_brush_count; ++i) {
            const BspBrush& brush = bsp.brushes[bsp.leaf_brushes[leaf.first_leaf_brush + i]];
            for (uint32_t side = 0; side < brush.side_count; ++side)
                sum += bsp.planes[bsp.brush_sides[brush.first_side + side].plane].dist;
        }
        if (leaf.cluster >= 0) sum += static_cast<float>(pvs.row(leaf.cluster)[0] & 1);
    }
    for (const BspNode& node : bsp.nodes)
        for (uint32_t i = 0; i < node.face_count; ++i)
            sum += static_cast<float>(bsp.faces[node.first_face + i].plane);
    for (const BspModel& model : bsp.models) {
        sum += static_cast<float>(leaf_at(bsp, model.mins, model.headnode));
        for (uint32_t i = 0; i < model.face_count; ++i)
            sum += static_cast<float>(bsp.faces[model.first_face + i].plane);
    }
    for (const BspArea& area : bsp.areas)
        for (uint32_t i = 0; i < area.portal_count; ++i)
            sum += static_cast<float>(bsp.area_portals[area.first_portal + i].other_area);
    for (const Entity& entity : bsp.entities)
        sum += entity.get_vec3("origin").x + static_cast<float>(entity.get_int("spawnflags"));
    return sum + play_level(bsp);
}

} // namespace vigil
