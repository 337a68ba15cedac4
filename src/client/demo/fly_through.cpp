// SPDX-License-Identifier: GPL-2.0-or-later
// Flying along a route.
#include "client/demo/fly_through.h"

#include "common/error.h"

#include <utility>

namespace vigil::client {

FlyThrough::FlyThrough(Route route, RunPlan plan)
    : route_(std::move(route)), frame_count_(route_.frame_count(plan.fps)),
      run_(std::move(plan), frame_count_) {
    run_.check_outputs();
}

void FlyThrough::begin_frame(Session& session) {
    const int frame = run_.frame_count();
    const Route::Key view = route_.at(frame / run_.plan().fps);
    session.camera().set(view.origin, view.angles);
    if (frame == 0) {
        if (!run_.plan().prefix.empty()) session.calm_first_picture();
        run_.begin(session);
    }
    if (frame > 0) session.advance(1.0 / run_.plan().fps);
}

void FlyThrough::end_frame(Session& session, double seconds) {
    run_.end_frame(session, seconds);
}

void FlyThrough::report(Session& session, const CvarRegistry& variables) {
    run_.end(session);
    run_.log_repetition();
    run_.report(session, variables);
}

void FlyThrough::cut_short() {
    const int frames = run_.frame_count();
    run_.drop();
    fail("ended after {} of {} frames: there is no report", frames, frame_count_);
}

} // namespace vigil::client
