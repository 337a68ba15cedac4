// SPDX-License-Identifier: GPL-2.0-or-later
#include "walks/reach.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <queue>
#include <tuple>

namespace vigil::walks {

namespace {

constexpr int headings = 8;
constexpr int jump_ticks = 4;    // that the key is down
constexpr int jump_penalty = 60; // ticks: people jump where they have to
constexpr uint32_t burns = CONTENTS_LAVA | CONTENTS_SLIME;

using Cell = std::tuple<int, int, int>;

Cell cell_of(const PlayerState& state) {
    const glm::vec3 c = glm::floor(state.origin / Reach::cell);
    return {static_cast<int>(c.x), static_cast<int>(c.y), static_cast<int>(c.z)};
}

bool rests(const PlayerState& state) {
    return state.ground != owner_none || state.water_level >= 2;
}

} // namespace

PlayerCommand command_of(const Step& step, int tick) {
    PlayerCommand command;
    command.angles.y = step.heading;
    command.forward = run_speed;
    if (step.swim_up || (step.jump && tick < jump_ticks)) command.up = run_speed;
    return command;
}

bool take_step(PlayerState& state, const Step& step, const CollisionWorld& world,
               std::vector<PlayerCommand>* commands, std::vector<glm::vec3>* places) {
    const int least = state.water_level >= 2 ? Reach::swim_ticks : Reach::step_ticks;
    for (int tick = 0; tick < Reach::longest_fall_ticks; ++tick) {
        if (tick >= least && rests(state)) return true;
        const PlayerCommand command = command_of(step, tick);
        state = move_player(state, command, world);
        if (state.water_level > 0 && (state.water_type & burns) != 0) return false;
        if (commands != nullptr) commands->push_back(command);
        if (places != nullptr) places->push_back(state.origin);
    }
    return false;
}

Reach::Reach(const CollisionWorld& world, const PlayerState& start, int most_ticks,
             const Judge& judge) {
    // Dijkstra's search; a place is final when it is taken from the queue.
    struct Candidate {
        int cost; ///< ticks, and what jumps cost more
        Place place;
    };
    const auto later = [](const Candidate& a, const Candidate& b) { return a.cost > b.cost; };
    std::priority_queue<Candidate, std::vector<Candidate>, decltype(later)> queue(later);
    std::map<Cell, int> best;
    queue.push({0, {start, -1, {}, 0, false}});
    best[cell_of(start)] = 0;
    while (!queue.empty()) {
        const Candidate next = queue.top();
        queue.pop();
        if (next.cost > best[cell_of(next.place.state)]) continue;
        const int index = static_cast<int>(places_.size());
        places_.push_back(next.place);
        const Place& from = next.place;
        if (from.ends || from.ticks >= most_ticks) continue;

        const auto try_step = [&](const Step& step) {
            PlayerState state = from.state;
            std::vector<glm::vec3> way;
            if (!take_step(state, step, world, nullptr, &way)) return state;
            const Verdict verdict = judge(state);
            if (verdict == Verdict::Forbidden) return state;
            const int ticks = static_cast<int>(way.size());
            const int cost = next.cost + ticks + (step.jump ? jump_penalty : 0);
            const auto known = best.find(cell_of(state));
            if (known != best.end() && known->second <= cost) return state;
            best[cell_of(state)] = cost;
            queue.push({cost, {state, index, step, from.ticks + ticks, verdict == Verdict::Ends}});
            return state;
        };
        for (int i = 0; i < headings; ++i) {
            const float heading = 360.0f / headings * static_cast<float>(i);
            if (from.state.water_level >= 2) {
                try_step({heading, false, true});
                try_step({heading, false, false});
                continue;
            }
            const PlayerState walked = try_step({heading, false, false});
            const glm::vec2 way(walked.origin - from.state.origin);
            constexpr float short_way = 24.0f, deep = 40.0f;
            const bool hindered = glm::length(way) < short_way;
            const bool fell = walked.origin.z < from.state.origin.z - deep;
            if ((hindered || fell) && from.state.ground != owner_none)
                try_step({heading, true, false});
        }
    }
}

std::vector<int> Reach::way_to(int place) const {
    std::vector<int> way;
    for (; place > 0; place = places_[static_cast<size_t>(place)].parent)
        way.push_back(place);
    std::ranges::reverse(way);
    return way;
}

} // namespace vigil::walks
