// SPDX-License-Identifier: GPL-2.0-or-later
#include "client/measure/recent_times.h"

#include <algorithm>

namespace vigil::client {

void RecentTimes::add_frame(const refresh::FrameTimes& frame) {
    if (frame.passes.empty()) return;
    if (frames_.size() == most_frames) frames_.pop_front();
    frames_.push_back(frame.passes);
}

std::vector<refresh::PassTime> RecentTimes::means() const {
    std::vector<refresh::PassTime> means;
    for (const std::vector<refresh::PassTime>& frame : frames_) {
        for (const refresh::PassTime& pass : frame) {
            auto mean = std::ranges::find(means, pass.name, &refresh::PassTime::name);
            if (mean == means.end()) mean = means.insert(mean, {pass.name, 0.0, pass.group});
            mean->milliseconds += pass.milliseconds / static_cast<double>(frames_.size());
        }
    }
    return means;
}

double sum_of(const std::vector<refresh::PassTime>& passes, refresh::PassGroup group) {
    double sum = 0.0;
    for (const refresh::PassTime& pass : passes)
        if (pass.group == group) sum += pass.milliseconds;
    return sum;
}

} // namespace vigil::client
