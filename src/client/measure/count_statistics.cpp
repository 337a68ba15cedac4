// SPDX-License-Identifier: GPL-2.0-or-later
#include "client/measure/count_statistics.h"

#include <fmt/format.h>

#include <algorithm>

namespace vigil::client {

CountStatistics::Row& CountStatistics::row_of(const std::string& name) {
    const auto found = std::ranges::find(rows_, name, &Row::name);
    return found != rows_.end() ? *found : rows_.emplace_back(Row{name, 0.0, 0.0});
}

void CountStatistics::add_frame(std::span<const refresh::FrameCount> counts) {
    if (counts.empty()) return;
    ++frame_count_;
    for (const refresh::FrameCount& count : counts) {
        Row& row = row_of(count.name);
        row.sum += count.value;
        row.last = count.value;
    }
    if (most_frames_ == 0) return;
    recent_.emplace_back(counts.begin(), counts.end());
    if (recent_.size() <= most_frames_) return;
    for (const refresh::FrameCount& count : recent_.front())
        row_of(count.name).sum -= count.value;
    recent_.pop_front();
    --frame_count_;
}

void CountStatistics::clear() {
    frame_count_ = 0;
    rows_.clear();
    recent_.clear();
}

std::vector<refresh::FrameCount> CountStatistics::means() const {
    std::vector<refresh::FrameCount> means;
    for (const Row& row : rows_)
        means.push_back({row.name, row.sum / static_cast<double>(frame_count_)});
    return means;
}

std::string CountStatistics::table() const {
    if (frame_count_ == 0) return "no frame has been counted";
    std::string text = fmt::format("guiding, {:<24} {:>12} {:>12}",
                                   fmt::format("mean of {} frames", frame_count_), "mean", "last");
    for (const Row& row : rows_)
        text += fmt::format("\n  {:<31} {:>12.1f} {:>12.1f}", row.name,
                            row.sum / static_cast<double>(frame_count_), row.last);
    return text;
}

} // namespace vigil::client
