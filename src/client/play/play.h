// SPDX-License-Identifier: GPL-2.0-or-later
// The level as it is played: lets the game (game/game.h) tick with the time of frames, gives it
// the keys or a scripted walk, and shows in the session what it says: eye, brush models, light
// styles, bolts. Between two ticks everything is interpolated, so pictures are a tick late (1/100
// s).
#pragma once

#include "client/play/session.h"
#include "client/play/walk.h"
#include "game/game.h"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vigil::client {

class Play {
public:
    /// The level of the session from its start on, with the player at its start place.
    explicit Play(const Session& session);

    /// The game, for what the console asks about.
    const Game& game() const { return *game_; }

    /// A frame of `seconds`: ticks that are due, then the session shows the moment. Walking, the
    /// camera follows the player; else it flies freely and the level goes on without a player.
    /// With `level_stands`, only the player moves.
    void frame(const FlightInput& keys, double seconds, bool level_stands, Session& session);

    /// Free flight or back. The player then stands where the camera is, if there is room; else it
    /// returns to where it was left. False in that case.
    bool set_walking(bool walking, Session& session);
    bool walking() const { return walking_; }
    /// Ends the player's life: it starts anew at the level's start. Only while walking.
    void kill(Session& session);
    bool recording() const { return recording_.has_value(); }

    /// Follows a walk in place of the keys, until it ends.
    void follow(Walk walk);
    bool following() const { return script_.has_value(); }
    void stop_following() { script_.reset(); }
    /// Records the commands of ticks from now on, as path below outdir.
    void record(std::string path);
    const std::string& recorded_path() const { return recorded_path_; }
    /// What was recorded; no longer records.
    std::optional<Walk> take_recording();

    /// Ends what it shows: models, styles and lights are as the level has them.
    static void clear(Session& session);

private:
    PlayerCommand command_of(const FlightInput& keys, const glm::vec3& angles) const;
    void tick(const FlightInput& keys, bool level_stands, Session& session);
    void show(Session& session);
    void show_models(Session& session, float fraction);
    void show_styles(Session& session);
    void show_lights(Session& session, float fraction) const;

    std::unique_ptr<Game> game_;
    bool walking_ = true;
    double clock_s_ = 0.0; ///< since the last tick
    // What was shown last: only what changed is shown again, so that `turn` and `lightstyle` hold.
    std::vector<MovedModel> shown_models_;
    std::map<int, std::string> shown_styles_;
    std::optional<Walk> script_;
    int64_t script_tick_ = 0;
    std::optional<Walk> recording_;
    std::string recorded_path_;
};

} // namespace vigil::client
