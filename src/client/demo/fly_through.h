// SPDX-License-Identifier: GPL-2.0-or-later
// One flight of the camera along a route: every frame of the route is rendered, none is skipped,
// and the end reports frame rate and GPU times (Quake's timedemo, with a camera instead of a demo).
#pragma once

#include "client/demo/route.h"
#include "client/demo/timed_run.h"

namespace vigil::client {

class FlyThrough {
public:
    /// Throws Error when what the plan wants written cannot be.
    FlyThrough(Route route, RunPlan plan);

    bool finished() const { return run_.frame_count() == frame_count_; }

    /// Puts the camera at this frame's view and lets one frame of route time pass. Where pictures
    /// are kept, the first is as calm as a level's first in play.
    void begin_frame(Session& session);
    /// Takes this frame's times and picture. `seconds` is the time that rendering it took. Throws
    /// Error when the picture cannot be written.
    void end_frame(Session& session, double seconds);

    /// Quake's line and the table of passes; writes the JSON report if one is wanted. Throws Error
    /// when it cannot be written. Waits for the GPU; that time counts.
    void report(Session& session, const CvarRegistry& variables);

    /// Throws Error with how far the flight came: it was ended before its time.
    [[noreturn]] void cut_short();

private:
    Route route_;
    int frame_count_ = 0;
    TimedRun run_;
};

} // namespace vigil::client
