// SPDX-License-Identifier: GPL-2.0-or-later
// What a demo shows at one moment, in place of the level's own entities and lights.
#pragma once

#include "refresh/refresh.h"

#include <vector>

namespace vigil::client {

struct PlayedScene {
    float fov = 90.0f; ///< as refresh::View::fov
    std::vector<refresh::Entity> entities;
    std::vector<refresh::DynamicLight> dynamic_lights;
    std::vector<refresh::Beam> beams;
    std::vector<refresh::Particle> particles;
};

} // namespace vigil::client
