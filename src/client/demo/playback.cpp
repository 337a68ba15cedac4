// SPDX-License-Identifier: GPL-2.0-or-later
#include "client/demo/playback.h"

#include "common/error.h"
#include "common/log.h"

#include <utility>

namespace vigil::client {

namespace {

int frame_count(const std::string& name, const std::vector<uint8_t>& bytes) {
    DemoReader reader(name, bytes);
    int frames = 0;
    while (reader.next())
        ++frames;
    return frames;
}

} // namespace

DemoPlayback::DemoPlayback(std::string name, std::vector<uint8_t> bytes, int repetitions,
                           RunPlan plan)
    : name_(std::move(name)), bytes_(std::move(bytes)), repetitions_(repetitions),
      run_(std::move(plan), timed() ? repetitions * frame_count(name_, bytes_) : 0) {
    if (timed()) run_.check_outputs();
}

void DemoPlayback::start(Session& session) {
    // The level is loaded anew for each repetition: all begin with the same random numbers and with
    // nothing learned.
    player_.emplace(name_, bytes_);
    player_->log_texts(!timed());
    player_->start(session);
    fresh_ = true;
    if (timed()) run_.begin(session);
}

void DemoPlayback::begin_frame(double seconds, Session& session) {
    if (std::exchange(fresh_, false)) return;
    if (!timed()) {
        player_->advance(seconds, session);
        return;
    }
    // Loading a level drops the times of frames that are still on their way.
    if (player_->at_level_change()) run_.take_gpu_times(session, true);
    player_->step(session);
}

bool DemoPlayback::end_frame(double seconds, Session& session) {
    if (!timed()) return player_->finished();
    run_.end_frame(session, seconds);
    if (!player_->at_last_frame()) return false;
    run_.end(session);
    run_.log_repetition();
    if (run_.repetitions() == repetitions_ || !player_->fault().empty()) return true;
    start(session);
    return false;
}

void DemoPlayback::cut_short(Session& session, const CvarRegistry& variables) {
    const int frames = run_.frame_count();
    run_.drop();
    if (run_.repetitions() > 0) run_.report(session, variables);
    fail("ended after {} frames of repetition {} of {}: {}", frames, run_.repetitions() + 1,
         repetitions_,
         run_.repetitions() > 0 ? "the report has what was finished" : "there is no report");
}

void DemoPlayback::finish(Session& session, const CvarRegistry& variables) {
    if (timed())
        run_.report(session, variables);
    else
        log_info("{}: {} frames played", name_, player_->frames());
    if (!player_->fault().empty())
        fail("the demo ends here, after {} frames: {}", player_->frames(), player_->fault());
}

} // namespace vigil::client
