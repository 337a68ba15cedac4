// SPDX-License-Identifier: GPL-2.0-or-later
#include "client/play/stick.h"

#include <algorithm>
#include <cmath>

namespace vigil::client {

glm::vec2 stick_response(glm::vec2 place, float dead_zone, float curve) {
    const float way = glm::length(place);
    if (!(way > dead_zone)) return glm::vec2(0.0f);
    const float beyond = (std::min(way, 1.0f) - dead_zone) / (1.0f - dead_zone);
    return place * (std::pow(beyond, curve) / way);
}

} // namespace vigil::client
