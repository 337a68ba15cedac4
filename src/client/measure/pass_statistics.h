// SPDX-License-Identifier: GPL-2.0-or-later
// GPU times of each pass over many frames, and the table made of them.
#pragma once

#include "refresh/refresh.h"

#include <deque>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace vigil::client {

/// Milliseconds of one pass over the recorded frames. `share` is its part of all passes' time,
/// 0..1.
struct PassSummary {
    std::string name;
    size_t frames = 0;
    double minimum = 0.0;
    double median = 0.0;
    double mean = 0.0;
    double p99 = 0.0; ///< 99 % of the frames were at most this long
    double share = 0.0;
};

/// Passes that are also reported together, and the name for that.
struct PassSum {
    refresh::PassGroup group;
    std::string name;
};

class PassStatistics {
public:
    /// The oldest frames are forgotten beyond this (about 20 minutes at 60 per second).
    static constexpr size_t capacity = 72000;

    /// Frames without any pass do not count.
    void add_frame(std::span<const refresh::PassTime> passes);
    void clear() { frames_.clear(); }
    size_t frame_count() const { return frames_.size(); }

    /// In the order in which the passes first appeared; a pass that a frame did not run does not
    /// count as a time of 0 there.
    std::vector<PassSummary> summarize() const;
    /// The sum of a group's passes in each frame; a frame without any of them does not count.
    PassSummary summarize(const PassSum& sum) const;
    /// Mean of each pass over the last frames, at most so many; a frame without a pass counts as 0
    /// there. Passes that none of them ran are left out.
    std::vector<refresh::PassTime> recent_means(size_t most_frames) const;
    /// Lines of text: passes, sums of groups (those that ran), the sum per frame.
    std::string table(std::span<const PassSum> sums = {}) const;

private:
    struct Time {
        size_t pass = 0; // into names_
        float milliseconds = 0.0f;
    };

    size_t index_of(const refresh::PassTime& pass);

    std::vector<std::string> names_;
    std::vector<refresh::PassGroup> groups_; // of the passes, as names_
    std::deque<std::vector<Time>> frames_;
};

} // namespace vigil::client
