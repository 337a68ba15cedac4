// SPDX-License-Identifier: GPL-2.0-or-later
// Means of the numbers that frames counted (of the octree and the light caches), and the table made
// of them.
#pragma once

#include "refresh/refresh.h"

#include <deque>
#include <span>
#include <string>
#include <vector>

namespace vigil::client {

class CountStatistics {
public:
    /// The oldest frames are forgotten beyond `most_frames`; 0: none is.
    explicit CountStatistics(size_t most_frames) : most_frames_(most_frames) {}

    /// Frames without counts do not count.
    void add_frame(std::span<const refresh::FrameCount> counts);
    void clear();
    size_t frame_count() const { return frame_count_; }

    /// The mean of each number over the frames, in the order in which the numbers first appeared. A
    /// frame that lacks a number others have counts as 0 there.
    std::vector<refresh::FrameCount> means() const;
    /// Lines of text: name, mean, and the value of the last frame.
    std::string table() const;

private:
    struct Row {
        std::string name;
        double sum = 0.0;
        double last = 0.0;
    };
    Row& row_of(const std::string& name);

    size_t most_frames_;
    size_t frame_count_ = 0;
    std::vector<Row> rows_;
    std::deque<std::vector<refresh::FrameCount>> recent_; // only where frames are forgotten
};

} // namespace vigil::client
