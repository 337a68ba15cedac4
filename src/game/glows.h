// SPDX-License-Identifier: GPL-2.0-or-later
// Places that glow for a moment: bursts, and what bolts hit. Who shows the level makes lights of
// them.
#pragma once

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace vigil {

struct Glow {
    uint32_t id = 0; ///< as who adds it counts them
    glm::vec3 place{0.0f};
    int ticks_left = 0, ticks = 0; ///< of all

    /// Fades from 1 to 0.
    float brightness() const { return static_cast<float>(ticks_left) / static_cast<float>(ticks); }
};

class Glows {
public:
    /// More at once are not kept: the oldest go first.
    static constexpr size_t most = 256;

    void add(uint32_t id, const glm::vec3& place, int ticks) {
        if (glowing_.size() == most) glowing_.erase(glowing_.begin());
        glowing_.push_back({id, place, ticks, ticks});
    }
    void tick() {
        std::erase_if(glowing_, [](Glow& glow) { return --glow.ticks_left <= 0; });
    }
    /// The oldest first.
    const std::vector<Glow>& glowing() const { return glowing_; }

private:
    std::vector<Glow> glowing_;
};

} // namespace vigil
