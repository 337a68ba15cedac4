// SPDX-License-Identifier: GPL-2.0-or-later
// What stops a moving box in a level: the world's brushes and the brush models that stand in it
// now. Asking changes nothing, so the same question has the same answer.
#pragma once

#include "game/brush_trace.h"

#include <cstddef>
#include <vector>

namespace vigil {

/// A brush model that stands in the world.
struct Obstacle {
    uint32_t model = 0; ///< into Bsp::models
    Placement place;
    int owner = owner_none; ///< number of the entity
    bool solid = true;      ///< stops boxes; else it is passed through
    bool flows = true;      ///< the currents of its brushes carry who stands on it
};

class CollisionWorld {
public:
    /// `bsp` must outlive it.
    explicit CollisionWorld(const Bsp& bsp) : bsp_(bsp) {}

    const Bsp& bsp() const { return bsp_; }

    /// Returns its index. `obstacle.model` must be one of the level's.
    size_t add(const Obstacle& obstacle);
    Obstacle& obstacle(size_t index) { return obstacles_[index]; }
    const Obstacle& obstacle(size_t index) const { return obstacles_[index]; }
    size_t obstacle_count() const { return obstacles_.size(); }

    /// Moves a box until it hits the world or a solid obstacle.
    Trace trace(const glm::vec3& start, const glm::vec3& end, const Box& box, uint32_t mask) const;
    /// The same as if one obstacle were not there.
    Trace trace_without(size_t index, const glm::vec3& start, const glm::vec3& end, const Box& box,
                        uint32_t mask) const;
    /// The same against one obstacle alone, solid or not.
    Trace trace_obstacle(size_t index, const glm::vec3& start, const glm::vec3& end, const Box& box,
                         uint32_t mask) const;
    /// True where the box touches nothing solid.
    bool is_free(const glm::vec3& place, const Box& box, uint32_t mask) const {
        return !trace(place, place, box, mask).start_solid;
    }

    /// ContentsFlag bits at a point: of the world's leaf and of solid obstacles.
    uint32_t contents_at(const glm::vec3& point) const;

    /// Bounds of an obstacle where it stands, around all its points.
    Box bounds(size_t index) const;

private:
    void trace_into(const Obstacle& obstacle, const glm::vec3& start, const glm::vec3& end,
                    const Box& box, uint32_t mask, Trace& trace) const;

    const Bsp& bsp_;
    std::vector<Obstacle> obstacles_;
};

/// True where two boxes share a point.
bool boxes_touch(const Box& a, const Box& b);

} // namespace vigil
