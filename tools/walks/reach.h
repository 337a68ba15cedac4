// SPDX-License-Identifier: GPL-2.0-or-later
// Where a player can get from a state: a search over places a step apart, whose steps are ticks of
// the real movement (game/player_movement.h) in a world that stands still. Every place knows the
// way that led there. Cells of the search are `cell` units wide; of all ways into a cell the
// quickest counts.
#pragma once

#include "game/player_movement.h"

#include <functional>
#include <vector>

namespace vigil::walks {

/// As the keys of the program.
inline constexpr float run_speed = 400.0f;

/// One step: in a direction for some ticks, and on until the feet are on the ground or swim.
struct Step {
    float heading = 0.0f; ///< degrees
    bool jump = false;
    bool swim_up = false;
};

/// The command of a step's tick, counted from 0.
PlayerCommand command_of(const Step& step, int tick);

struct Place {
    PlayerState state;
    int parent = -1;   ///< index; -1: the start
    Step step;         ///< that led here
    int ticks = 0;     ///< of the whole way
    bool ends = false; ///< nothing leads on from here
};

class Reach {
public:
    static constexpr float cell = 40.0f;
    static constexpr int step_ticks = 16, swim_ticks = 36; ///< each more than a cell from rest
    static constexpr int longest_fall_ticks = 160;

    /// What a place is for the search.
    enum class Verdict { Fine, Ends, Forbidden };
    using Judge = std::function<Verdict(const PlayerState&)>;

    /// All places up to `most_ticks` away. `world` is asked only now.
    Reach(const CollisionWorld& world, const PlayerState& start, int most_ticks,
          const Judge& judge);

    const std::vector<Place>& places() const { return places_; }
    /// Indices from the one after the start to `place`.
    std::vector<int> way_to(int place) const;

private:
    std::vector<Place> places_;
};

/// Takes a step; false where it ends in the air or in what burns. `commands` and `places`, if
/// given, receive every tick's command and the place after it.
bool take_step(PlayerState& state, const Step& step, const CollisionWorld& world,
               std::vector<PlayerCommand>* commands = nullptr,
               std::vector<glm::vec3>* places = nullptr);

} // namespace vigil::walks
