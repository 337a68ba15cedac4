// SPDX-License-Identifier: GPL-2.0-or-later
// Plays a demo into a session: loads its level, moves camera, entities, lights and light styles
// with the time. Between the server's frames, ten a second, everything is interpolated; what jumps
// is not. Sounds and the status bar do not exist here; console commands in demos are not run.
#pragma once

#include "client/demo/effects.h"
#include "client/demo/reader.h"
#include "client/play/session.h"

#include <map>

namespace vigil::client {

class DemoPlayer {
public:
    /// `name` is for messages.
    DemoPlayer(std::string name, std::vector<uint8_t> bytes);

    /// Loads the level and shows the first frame. Throws Error: a demo without a frame, a level
    /// that is not there.
    void start(Session& session);
    /// Shows the next frame as it is.
    void step(Session& session);
    /// Lets time pass, with frames interpolated.
    void advance(double seconds, Session& session);

    /// No frame follows the one that is shown.
    bool at_last_frame() const { return !next_; }
    /// The frame that follows begins another level.
    bool at_level_change() const;
    /// With advance(): the last frame's time is over.
    bool finished() const { return finished_; }
    /// Frames shown so far.
    int frames() const { return frames_; }
    /// Why the demo ended before its end; empty: it did not.
    const std::string& fault() const { return reader_.fault(); }
    const std::string& name() const { return reader_.name(); }
    /// Whether texts of the demo are logged.
    void log_texts(bool on) { log_texts_ = on; }

private:
    void take(DemoStep step, Session& session);
    void take_message(const dm2::Message& message, Session& session);
    void start_level(Session& session);
    void follow_light_styles(Session& session);
    /// Seconds at `part` of the present frame.
    double level_time(float part) const;
    void show(Session& session);
    void show_player(PlayedScene& scene, Session& session);
    void show_entity(const dm2::EntityState& entity, PlayedScene& scene, Session& session);
    refresh::ModelHandle model(uint8_t index, const dm2::EntityState& entity, Session& session);
    refresh::ModelHandle model_named(const std::string& name, Session& session);
    std::string player_model(uint32_t skin) const;
    /// The entity in the frame before, if it moved from there to here; else null.
    const dm2::EntityState* before(const dm2::EntityState& entity) const;

    DemoReader reader_;
    std::optional<DemoStep> next_; // read ahead
    dm2::Frame last_, now_;
    bool follows_ = false; // now_ is a tenth of a second after last_
    float part_ = 1.0f;    // 0 shows last_, 1 now_
    bool finished_ = false;
    bool log_texts_ = true;
    bool level_wanted_ = false;
    int frames_ = 0;
    int player_ = 0; // number of the player's entity
    std::map<uint32_t, std::string> strings_;
    bool styles_changed_ = false;
    DemoEffects effects_;
    std::map<std::string, refresh::ModelHandle> models_; // -1: not there
};

} // namespace vigil::client
