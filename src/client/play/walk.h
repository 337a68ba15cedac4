// SPDX-License-Identifier: GPL-2.0-or-later
// A scripted walk: what a player's keys and view are at every tick of the level, from its start on.
// Text format: one `ticks forward side up pitch yaw roll attack` per line, that many ticks (1/100
// s) with these wished speeds (units per second), view angles (degrees) and trigger (0 or 1); `#`
// begins a comment. Replayed, a walk ends in the same place at any frame rate.
#pragma once

#include "common/file_system.h"
#include "game/player_movement.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace vigil::client {

class Walk {
public:
    /// Half a day.
    static constexpr int64_t most_ticks = 50'000 * int64_t{player::ticks_per_second};

    /// Throws Error with `name` and the line when a line has not eight numbers in range (speeds and
    /// angles up to 10,000), when there is no line, and beyond most_ticks.
    static Walk parse(std::string_view name, std::string_view text);
    std::string text() const;

    /// Adds a tick; those beyond most_ticks are dropped.
    void add(const PlayerCommand& command) { add(command, 1); }

    int64_t ticks() const { return ticks_; }
    /// Of tick 0 and on; `tick` must be below ticks(). Fast where ticks are asked for in order.
    const PlayerCommand& command_at(int64_t tick) const;

private:
    struct Run {
        int64_t begin;
        PlayerCommand command;
    };
    void add(const PlayerCommand& command, int64_t ticks);

    std::vector<Run> runs_;
    int64_t ticks_ = 0;
};

/// "walks/NAME.walk"; `name` may be given with folder and extension.
std::string walk_path(std::string_view name);

/// The walk recorded below `outdir`, else that of the game. Throws Error.
Walk load_walk(const FileSystem& files, const std::string& outdir, std::string_view name);

} // namespace vigil::client
