// SPDX-License-Identifier: GPL-2.0-or-later
#include "game/explosions.h"

namespace vigil {

float Explosion::brightness() const {
    return static_cast<float>(ticks_left) / static_cast<float>(Explosions::life_ticks);
}

void Explosions::add(const glm::vec3& place) {
    if (glowing_.size() == most) glowing_.erase(glowing_.begin());
    glowing_.push_back({next_id_++, place, life_ticks});
}

void Explosions::tick() {
    std::erase_if(glowing_, [](Explosion& explosion) { return --explosion.ticks_left <= 0; });
}

} // namespace vigil
