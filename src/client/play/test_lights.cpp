// SPDX-License-Identifier: GPL-2.0-or-later
#include "client/play/test_lights.h"

#include "client/play/effect_lights.h"
#include "client/play/level_entities.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

namespace vigil::client {

namespace {

/// As the blaster's bolts in size, half as bright.
constexpr float game_radius = 120.0f;
/// What a light keeps from walls.
constexpr Box clearance{glm::vec3(-8.0f), glm::vec3(8.0f)};
/// Straight pieces from the start to a light's home, so that many spread further than few, and from
/// there of its way.
constexpr int fewest_to_home = 2, most_to_home = 10, pieces = 6;
constexpr float shortest_piece = 64.0f, longest_piece = 384.0f;

/// In [0, 1), the same on every machine.
float even(std::minstd_rand& random) {
    return static_cast<float>(random() - std::minstd_rand::min()) /
           (static_cast<float>(std::minstd_rand::max() - std::minstd_rand::min()) + 1.0f);
}

glm::vec3 color_of(uint32_t number) {
    // Hues by the golden ratio: neighbours differ, and no two are the same.
    constexpr float golden = 0.618034f;
    const float hue = std::fmod(golden * static_cast<float>(number), 1.0f);
    const auto channel = [hue](float shift) {
        const float x = std::abs(6.0f * std::fmod(hue + shift, 1.0f) - 3.0f) - 1.0f;
        return 0.15f + 0.85f * std::clamp(x, 0.0f, 1.0f);
    };
    return {channel(0.0f), channel(2.0f / 3.0f), channel(1.0f / 3.0f)};
}

} // namespace

TestLights::TestLights(std::shared_ptr<const Level> level)
    : level_(std::move(level)), world_(level_->bsp), start_(find_start(level_->bsp).origin) {}

TestLights::Way TestLights::make_way(uint32_t number) const {
    std::minstd_rand random(number + 1);
    const int to_home =
        fewest_to_home + static_cast<int>(number % (most_to_home - fewest_to_home + 1));
    glm::vec3 place = start_;
    Way way;
    for (int piece = 0; piece < to_home + pieces; ++piece) {
        // The longest of a few tries, so that corners do not hold a light.
        constexpr int tries = 4;
        glm::vec3 farthest = place;
        for (int i = 0; i < tries; ++i) {
            const float yaw = 6.2831853f * even(random), rise = 0.8f * (even(random) - 0.5f);
            const float length = shortest_piece + (longest_piece - shortest_piece) * even(random);
            const glm::vec3 direction(std::cos(yaw), std::sin(yaw), rise);
            const Trace trace = world_.trace(place, place + length * direction, clearance,
                                             mask_player_solid | mask_water);
            if (!trace.start_solid &&
                glm::distance(trace.end, place) > glm::distance(farthest, place))
                farthest = trace.end;
        }
        if (piece == to_home) way = {{place}, {0.0}};
        place = farthest;
        if (piece < to_home || place == way.points.back()) continue;
        way.lengths.push_back(way.lengths.back() +
                              static_cast<double>(glm::distance(way.points.back(), place)));
        way.points.push_back(place);
    }
    return way;
}

std::vector<refresh::DynamicLight> TestLights::at(int count, double time_s) {
    std::vector<refresh::DynamicLight> lights;
    for (uint32_t number = 0; number < static_cast<uint32_t>(count); ++number) {
        if (number == ways_.size()) ways_.push_back(make_way(number));
        const Way& way = ways_[number];
        const double whole = way.lengths.back();
        glm::vec3 place = way.points.front();
        if (whole > 0.0) {
            // There and back.
            double gone = std::fmod(static_cast<double>(speed) * time_s, 2.0 * whole);
            if (gone < 0.0) gone += 2.0 * whole;
            gone = std::min(gone, 2.0 * whole - gone);
            const auto next = std::ranges::upper_bound(way.lengths, gone);
            const auto i = static_cast<size_t>(std::clamp<std::ptrdiff_t>(
                next - way.lengths.begin(), 1, static_cast<std::ptrdiff_t>(way.points.size()) - 1));
            const double part = (gone - way.lengths[i - 1]) / (way.lengths[i] - way.lengths[i - 1]);
            place = glm::mix(way.points[i - 1], way.points[i], static_cast<float>(part));
        }
        lights.push_back(
            dynamic_light(first_test_light + number, place, {game_radius, color_of(number)}));
    }
    return lights;
}

} // namespace vigil::client
