// SPDX-License-Identifier: GPL-2.0-or-later
// GPU times of the last frames by groups of passes, for a look while playing (scr_stats).
#pragma once

#include "refresh/refresh.h"

#include <deque>

namespace vigil::client {

class RecentTimes {
public:
    /// Means over this many frames, in milliseconds per frame.
    static constexpr size_t most_frames = 30;

    struct Groups {
        double path_tracing = 0.0;
        double preparation = 0.0;
        double other = 0.0;
        double sum() const { return path_tracing + preparation + other; }
    };

    /// Frames without any pass do not count.
    void add_frame(const refresh::FrameTimes& frame);
    void clear() { frames_.clear(); }
    bool empty() const { return frames_.empty(); }
    /// 0 before the first frame.
    Groups means() const;

private:
    std::deque<Groups> frames_;
};

} // namespace vigil::client
