// SPDX-License-Identifier: GPL-2.0-or-later
#include "client/recent_times.h"

namespace vigil::client {

void RecentTimes::add_frame(const refresh::FrameTimes& frame) {
    if (frame.passes.empty()) return;
    Groups sums;
    for (const refresh::PassTime& pass : frame.passes) {
        switch (pass.group) {
        case refresh::PassGroup::PathTracing:
            sums.path_tracing += pass.milliseconds;
            break;
        case refresh::PassGroup::Preparation:
            sums.preparation += pass.milliseconds;
            break;
        case refresh::PassGroup::Other:
            sums.other += pass.milliseconds;
            break;
        }
    }
    if (frames_.size() == most_frames) frames_.pop_front();
    frames_.push_back(sums);
}

RecentTimes::Groups RecentTimes::means() const {
    Groups means;
    if (frames_.empty()) return means;
    for (const Groups& frame : frames_) {
        means.path_tracing += frame.path_tracing;
        means.preparation += frame.preparation;
        means.other += frame.other;
    }
    const auto count = static_cast<double>(frames_.size());
    return {means.path_tracing / count, means.preparation / count, means.other / count};
}

} // namespace vigil::client
