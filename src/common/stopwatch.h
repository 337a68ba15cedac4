// SPDX-License-Identifier: GPL-2.0-or-later
// Elapsed time on the monotonic clock, for frame times and load reports. GPU passes have timers of
// their own (refresh/vkpt/gpu).
#pragma once

#include <chrono>

namespace vigil {

class Stopwatch {
public:
    /// Seconds since construction or the last restart().
    double seconds() const { return elapsed(Clock::now()); }
    double milliseconds() const { return seconds() * 1e3; }

    /// Starts again; returns the seconds until now.
    double restart() {
        const Clock::time_point now = Clock::now();
        const double result = elapsed(now);
        start_ = now;
        return result;
    }

private:
    using Clock = std::chrono::steady_clock;

    double elapsed(Clock::time_point now) const {
        return std::chrono::duration<double>(now - start_).count();
    }

    Clock::time_point start_ = Clock::now();
};

} // namespace vigil
