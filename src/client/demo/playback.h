// SPDX-License-Identifier: GPL-2.0-or-later
// A demo on the screen, in one of two ways: with the time, frames interpolated; or as a measurement
// (`timedemo`): every frame of the demo is rendered exactly once, as fast as it can be, N times
// from the level's start, and the end reports frame rate and GPU times.
#pragma once

#include "client/demo/player.h"
#include "client/demo/timed_run.h"

namespace vigil::client {

class DemoPlayback {
public:
    /// `repetitions` of a measurement, 0: with the time. Pictures are taken, and reports written,
    /// of measurements only.
    DemoPlayback(std::string name, std::vector<uint8_t> bytes, int repetitions, RunPlan plan);

    /// Loads the level and shows the first frame. Throws Error.
    void start(Session& session);
    bool timed() const { return repetitions_ > 0; }

    /// Brings the session to what the next frame shows; `seconds` have passed. Throws Error when a
    /// later level of the demo cannot be loaded.
    void begin_frame(double seconds, Session& session);
    /// After a frame was rendered, which took `seconds`. Returns true at the end. Throws Error.
    bool end_frame(double seconds, Session& session);
    /// Logs what there is to say at the end, and writes the report. Throws Error when that fails,
    /// or with the demo's fault when it is damaged.
    void finish(Session& session, const CvarRegistry& variables);
    /// Of a measurement that is ended before its time: reports the repetitions that are finished,
    /// then throws Error with how far it came.
    [[noreturn]] void cut_short(Session& session, const CvarRegistry& variables);

private:
    std::string name_;
    std::vector<uint8_t> bytes_;
    int repetitions_ = 0;
    TimedRun run_;
    std::optional<DemoPlayer> player_;
    bool fresh_ = false; // the frame that is shown was not rendered yet
};

} // namespace vigil::client
