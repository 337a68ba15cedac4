// SPDX-License-Identifier: GPL-2.0-or-later
// The blaster's bolts on their way, and where the last ones hit: 1000 units per second for two
// seconds at most, damage 10, a shot every half second, as in the original.
#pragma once

#include "game/glows.h"

namespace vigil {

class Game;

struct Bolt {
    uint32_t id = 0; ///< counted from 0 in the level
    glm::vec3 before{0.0f}, now{0.0f};
    glm::vec3 velocity{0.0f};
    int ticks_left = 0;
};

class Bolts {
public:
    /// One tick: moves and hits, then shoots from `eye` along `angles` if `attack` is down.
    void tick(Game& game, const glm::vec3& eye, const glm::vec3& angles, bool attack);

    const std::vector<Bolt>& flying() const { return bolts_; }
    /// Where bolts hit a moment ago, by the bolts' ids.
    const std::vector<Glow>& hits() const { return hits_.glowing(); }

private:
    std::vector<Bolt> bolts_;
    Glows hits_;
    uint32_t next_id_ = 0;
    int pause_ticks_ = 0;
};

} // namespace vigil
