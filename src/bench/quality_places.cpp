// SPDX-License-Identifier: GPL-2.0-or-later
#include "bench/quality_places.h"

#include "client/play/level_entities.h"
#include "common/ascii_case.h"
#include "formats/bsp_query.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vigil::bench {

namespace {

constexpr float eye_height = 22.0f;    // of a standing player over the entity's origin
constexpr float walk_speed = 60.0f;    // units per second; players run at 300
constexpr float turn_degrees = 120.0f; // between views from the same place

std::vector<client::StartPlace> all_starts(const Bsp& bsp) {
    std::vector<client::StartPlace> starts = {client::find_start(bsp)};
    for (const Entity& entity : bsp.entities) {
        if (!equal_nocase(entity.classname(), "info_player_deathmatch")) continue;
        const glm::vec3 eye = entity.get_vec3("origin") + glm::vec3(0.0f, 0.0f, eye_height);
        if (eye != starts.front().origin) starts.push_back({eye, entity.get_model_angles()});
    }
    return starts;
}

/// The level direction of a yaw in degrees.
glm::vec3 direction_of(float yaw) {
    return {std::cos(glm::radians(yaw)), std::sin(glm::radians(yaw)), 0.0f};
}

/// Velocity, in units per frame, of a walk to `start` in the direction it looks: slower where
/// otherwise one of its frames would be inside a wall.
glm::vec3 walk_to(const Bsp& bsp, const client::StartPlace& start, int frames) {
    glm::vec3 step = direction_of(start.angles.y) * walk_speed / static_cast<float>(place_fps);
    const auto open = [&] {
        for (int i = 1; i <= frames; ++i)
            if (cluster_at(bsp, start.origin - static_cast<float>(i) * step) < 0) return false;
        return true;
    };
    for (int halvings = 0; halvings < 4; ++halvings, step *= 0.5f)
        if (open()) return step;
    return glm::vec3(0.0f);
}

} // namespace

std::vector<Place> route_places(const client::Route& route, int count, int warmup) {
    std::vector<Place> places;
    for (int i = 0; i < count; ++i) {
        // A short route leaves no room for the warm-up before its first places.
        const double lead = std::min(warmup / place_fps, route.duration_s());
        const double time = std::max((i + 0.5) / count * route.duration_s(), lead);
        Place place{fmt::format("{:.2f} s", time), {}};
        for (int frame = warmup; frame >= 0; --frame) {
            const double seconds = std::max(0.0, time - frame / place_fps);
            const client::Route::Key key = route.at(seconds);
            place.frames.push_back({key.origin, key.angles, seconds});
        }
        places.push_back(std::move(place));
    }
    return places;
}

std::vector<Place> start_places(const Bsp& bsp, int count, int warmup) {
    const std::vector<client::StartPlace> starts = all_starts(bsp);
    const auto available = static_cast<int>(starts.size());
    std::vector<Place> places;
    for (int i = 0; i < count; ++i) {
        // The first start and others spread over the list; when all are used, turned.
        const int spread = std::min(count, available);
        const int index = i % spread * available / spread;
        client::StartPlace start = starts[index];
        start.angles.y += turn_degrees * static_cast<float>(i / spread);
        const glm::vec3 step = walk_to(bsp, start, warmup);
        Place place{fmt::format("start {} yaw {:.0f}", index, start.angles.y), {}};
        for (int frame = warmup; frame >= 0; --frame)
            place.frames.push_back({start.origin - static_cast<float>(frame) * step, start.angles,
                                    (warmup - frame) / place_fps});
        places.push_back(std::move(place));
    }
    return places;
}

} // namespace vigil::bench
