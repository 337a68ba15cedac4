// SPDX-License-Identifier: GPL-2.0-or-later
#include "walks/walk_report.h"

#include "client/play/level_entities.h"
#include "common/error.h"
#include "formats/bsp_query.h"
#include "game/actors/door.h"
#include "game/game.h"

#include <fmt/format.h>
#include <glm/glm.hpp>

#include <algorithm>
#include <cstdio>
#include <set>

namespace vigil::walks {

namespace {

/// Less than this is no way.
constexpr float still = 8.0f;
/// Further than this in a tick is no walking: a teleporter.
constexpr float jump = 100.0f;

/// Ticks in a row that something holds, and the most there were.
struct Streak {
    int now = 0, most = 0;
    void add(bool holds) {
        now = holds ? now + 1 : 0;
        most = std::max(most, now);
    }
};

} // namespace

glm::vec3 start_origin(const Bsp& bsp) {
    return client::find_start(bsp).origin - glm::vec3(0.0f, 0.0f, player::standing_eye);
}

WalkReport report_walk(const std::shared_ptr<const Level>& level, const client::Walk& walk) {
    Game game(level, start_origin(level->bsp));
    WalkReport report;
    const glm::vec3 start = game.player().origin;
    std::set<const Door*> closed, opened;
    for (const auto& actor : game.actors())
        if (const auto* door = dynamic_cast<const Door*>(actor.get())) closed.insert(door);

    Streak in_solid, stuck, rest;
    glm::vec3 last = start, stuck_at = start, rest_at = start;
    for (int64_t tick = 0; tick < walk.ticks(); ++tick) {
        const PlayerCommand& command = walk.command_at(tick);
        game.tick(command);
        const PlayerState& player = game.player();
        in_solid.add(!game.collision().is_free(player.origin, player.box(), mask_player_solid));
        report.outside += cluster_at(level->bsp, game.eye_at(1.0f)) < 0 ? 1 : 0;

        const bool keys = command.forward != 0.0f || command.side != 0.0f || command.up != 0.0f;
        const bool near = glm::distance(player.origin, stuck_at) < still;
        stuck.add(keys && near);
        if (stuck.now == 0) stuck_at = player.origin;
        rest.add(glm::distance(player.origin, rest_at) < still);
        if (rest.now == 0) rest_at = player.origin;

        const float step = glm::distance(player.origin, last);
        if (step < jump) report.way += static_cast<double>(step);
        report.distance =
            std::max(report.distance, static_cast<double>(glm::distance(player.origin, start)));
        last = player.origin;
        for (const Door* door : closed)
            if (door->state() == Door::State::Opening) opened.insert(door);
    }
    report.end = game.player();
    report.ticks = static_cast<int>(walk.ticks());
    report.doors_opened = static_cast<int>(opened.size());
    report.longest_in_solid = in_solid.most;
    report.longest_stuck = stuck.most;
    report.longest_rest = rest.most;
    report.deaths = game.deaths();
    return report;
}

std::string WalkReport::text() const {
    return fmt::format("{:.1f} s, {:.0f} units, up to {:.0f} from the start, {} doors opened; ends "
                       "at {:.1f} {:.1f} {:.1f}; ticks at most: {} stuck, {} at rest, {} in solid; "
                       "{} outside, {} deaths",
                       static_cast<double>(ticks) / player::ticks_per_second, way, distance,
                       doors_opened, end.origin.x, end.origin.y, end.origin.z, longest_stuck,
                       longest_rest, longest_in_solid, outside, deaths);
}

std::string goal_text(const WalkGoal& goal) {
    return fmt::format("# ends at {:.0f} {:.0f} {:.0f}, {} doors opened\n", goal.place.x,
                       goal.place.y, goal.place.z, goal.doors);
}

WalkGoal read_goal(std::string_view name, const std::string& text) {
    WalkGoal goal;
    const size_t line = text.find("# ends at ");
    if (line == std::string::npos ||
        std::sscanf(text.c_str() + line, "# ends at %f %f %f, %d doors", &goal.place.x,
                    &goal.place.y, &goal.place.z, &goal.doors) != 4)
        fail("{}: the walk does not say where it ends", name);
    return goal;
}

} // namespace vigil::walks
