// SPDX-License-Identifier: GPL-2.0-or-later
// What has burst in a level a moment ago: places that glow for a second and a half, as the
// original's explosions do. Who shows the level makes lights of them.
#pragma once

#include "game/player_movement.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace vigil {

struct Explosion {
    uint32_t id = 0; ///< counted from 0 in the level
    glm::vec3 place{0.0f};
    int ticks_left = 0;
    /// Fades from 1 to 0.
    float brightness() const;
};

class Explosions {
public:
    static constexpr int life_ticks = 3 * player::ticks_per_second / 2;
    /// More at once are not kept: the oldest go first.
    static constexpr size_t most = 256;

    void add(const glm::vec3& place);
    void tick();
    /// The oldest first.
    const std::vector<Explosion>& glowing() const { return glowing_; }

private:
    std::vector<Explosion> glowing_;
    uint32_t next_id_ = 0;
};

} // namespace vigil
