// SPDX-License-Identifier: GPL-2.0-or-later
#include "game/collision_world.h"

#include "formats/bsp_query.h"
#include "game/view_axes.h"

#include <glm/glm.hpp>

namespace vigil {

namespace {

/// Of a model of the level at a place, around all its points.
Box placed_bounds(const BspModel& model, const Placement& place) {
    if (place.angles == glm::vec3(0.0f))
        return {model.mins + place.origin, model.maxs + place.origin};
    const glm::mat3 rotation = model_rotation(place.angles);
    const glm::vec3 middle = rotation * (0.5f * (model.mins + model.maxs)) + place.origin;
    const glm::mat3 reach(glm::abs(rotation[0]), glm::abs(rotation[1]), glm::abs(rotation[2]));
    const glm::vec3 half = reach * (0.5f * (model.maxs - model.mins));
    return {middle - half, middle + half};
}

} // namespace

bool boxes_touch(const Box& a, const Box& b) {
    return glm::all(glm::lessThanEqual(a.mins, b.maxs)) &&
           glm::all(glm::lessThanEqual(b.mins, a.maxs));
}

size_t CollisionWorld::add(const Obstacle& obstacle) {
    obstacles_.push_back(obstacle);
    return obstacles_.size() - 1;
}

Box CollisionWorld::bounds(size_t index) const {
    const Obstacle& obstacle = obstacles_[index];
    return placed_bounds(bsp_.models[obstacle.model], obstacle.place);
}

void CollisionWorld::trace_into(const Obstacle& obstacle, const glm::vec3& start,
                                const glm::vec3& end, const Box& box, uint32_t mask,
                                Trace& trace) const {
    const BspModel& model = bsp_.models[obstacle.model];
    const Box bounds = placed_bounds(model, obstacle.place);
    const glm::vec3 gap(2.0f * trace_gap);
    const Box way{glm::min(start, end) + box.mins - gap, glm::max(start, end) + box.maxs + gap};
    if (!boxes_touch(bounds, way)) return;
    const float before = trace.fraction;
    trace_tree(bsp_, model.headnode, obstacle.place, start, end, box, mask, obstacle.owner, trace);
    if (!obstacle.flows && trace.fraction < before) trace.contents &= ~mask_current;
}

Trace CollisionWorld::trace(const glm::vec3& start, const glm::vec3& end, const Box& box,
                            uint32_t mask) const {
    return trace_without(obstacles_.size(), start, end, box, mask);
}

Trace CollisionWorld::trace_without(size_t index, const glm::vec3& start, const glm::vec3& end,
                                    const Box& box, uint32_t mask) const {
    Trace trace;
    trace_tree(bsp_, bsp_.models.front().headnode, {}, start, end, box, mask, owner_world, trace);
    for (size_t i = 0; i < obstacles_.size(); ++i) {
        if (trace.all_solid) break;
        if (i != index && obstacles_[i].solid)
            trace_into(obstacles_[i], start, end, box, mask, trace);
    }
    trace.end = trace.fraction == 1.0f ? end : start + trace.fraction * (end - start);
    return trace;
}

Trace CollisionWorld::trace_obstacle(size_t index, const glm::vec3& start, const glm::vec3& end,
                                     const Box& box, uint32_t mask) const {
    Trace trace;
    trace_into(obstacles_[index], start, end, box, mask, trace);
    trace.end = trace.fraction == 1.0f ? end : start + trace.fraction * (end - start);
    return trace;
}

uint32_t CollisionWorld::contents_at(const glm::vec3& point) const {
    uint32_t contents = bsp_.leafs[leaf_at(bsp_, point)].contents;
    for (const Obstacle& obstacle : obstacles_) {
        if (!obstacle.solid) continue;
        const BspModel& model = bsp_.models[obstacle.model];
        if (!boxes_touch(placed_bounds(model, obstacle.place), {point, point})) continue;
        glm::vec3 local = point - obstacle.place.origin;
        if (obstacle.place.angles != glm::vec3(0.0f))
            local = glm::transpose(model_rotation(obstacle.place.angles)) * local;
        contents |= bsp_.leafs[leaf_at(bsp_, local, model.headnode)].contents;
    }
    return contents;
}

} // namespace vigil
