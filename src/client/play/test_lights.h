// SPDX-License-Identifier: GPL-2.0-or-later
// Lights that wander through a level, to try what moving light does (the variable `testlights`).
// Light N goes to and fro along a way of its own through the open space around the start, in a
// colour of its own: where it is depends on the level, on N and on the time alone.
#pragma once

#include "game/collision_world.h"
#include "level/level.h"
#include "refresh/refresh.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace vigil::client {

/// Ids of test lights are this and the numbers after it; those of play and demos are below.
inline constexpr uint32_t first_test_light = 0xc0000000;

class TestLights {
public:
    explicit TestLights(std::shared_ptr<const Level> level);

    /// Map units per second.
    static constexpr float speed = 100.0f;

    /// The first `count` lights at a time in seconds, times any speed that is wanted.
    std::vector<refresh::DynamicLight> at(int count, double time_s);

private:
    /// Points with nothing between neighbours, and the length of the way up to each.
    struct Way {
        std::vector<glm::vec3> points;
        std::vector<double> lengths;
    };
    Way make_way(uint32_t number) const;

    std::shared_ptr<const Level> level_;
    CollisionWorld world_; ///< without what moves
    glm::vec3 start_;
    std::vector<Way> ways_; ///< of the lights that were asked for so far
};

} // namespace vigil::client
