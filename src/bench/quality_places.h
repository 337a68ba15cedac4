// SPDX-License-Identifier: GPL-2.0-or-later
// Where the quality benchmark measures: places of a level, each with the frames of a moving camera
// that lead to it. From the level's camera route, else from where players start. No GPU.
#pragma once

#include "client/demo/route.h"
#include "formats/bsp.h"

#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace vigil::bench {

/// Frames per second of camera movement; nothing to do with how fast frames are rendered.
inline constexpr double place_fps = 20.0;

struct Pose {
    glm::vec3 origin{0.0f}; // of the eye
    glm::vec3 angles{0.0f}; // degrees
    double time_s = 0.0;    // of the level
};

struct Place {
    std::string name;
    std::vector<Pose> frames; // the warm-up, then the frame that is measured

    const Pose& measured() const { return frames.back(); }
};

/// `count` places in the middle of as many equal parts of the route, each with `warmup` frames of
/// the route before it.
std::vector<Place> route_places(const client::Route& route, int count, int warmup);

/// `count` places at info_player_start and info_player_deathmatch (where there are not enough, the
/// same ones looking another way), reached on a straight walk of at most 60 units per second that
/// begins in the open. The middle of the level where nobody starts.
std::vector<Place> start_places(const Bsp& bsp, int count, int warmup);

} // namespace vigil::bench
