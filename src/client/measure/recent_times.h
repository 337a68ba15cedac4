// SPDX-License-Identifier: GPL-2.0-or-later
// GPU times of the last frames by pass, for a look while playing (scr_stats).
#pragma once

#include "refresh/refresh.h"

#include <deque>
#include <vector>

namespace vigil::client {

class RecentTimes {
public:
    /// Means over this many frames, in milliseconds per frame.
    static constexpr size_t most_frames = 30;

    /// Frames without any pass do not count.
    void add_frame(const refresh::FrameTimes& frame);
    void clear() { frames_.clear(); }
    bool empty() const { return frames_.empty(); }
    /// Mean of each pass, in the order of their first appearance; a frame without a pass counts as
    /// 0 there.
    std::vector<refresh::PassTime> means() const;

private:
    std::deque<std::vector<refresh::PassTime>> frames_;
};

/// Sum of the passes of a group.
double sum_of(const std::vector<refresh::PassTime>& passes, refresh::PassGroup group);

} // namespace vigil::client
