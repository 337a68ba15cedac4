// SPDX-License-Identifier: GPL-2.0-or-later
// Order statistics of pass times by the nearest-rank method.
#include "client/measure/pass_statistics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace vigil::client {

namespace {

/// The smallest value that at least `part` of the sorted values do not exceed.
double quantile(std::span<const double> sorted, double part) {
    const auto rank = static_cast<size_t>(std::ceil(part * static_cast<double>(sorted.size())));
    return sorted[std::max<size_t>(rank, 1) - 1];
}

PassSummary summary_of(std::string name, std::vector<double>& times) {
    std::ranges::sort(times);
    PassSummary summary;
    summary.name = std::move(name);
    summary.frames = times.size();
    if (times.empty()) return summary;
    summary.minimum = times.front();
    summary.median = quantile(times, 0.5);
    summary.mean =
        std::accumulate(times.begin(), times.end(), 0.0) / static_cast<double>(times.size());
    summary.p99 = quantile(times, 0.99);
    return summary;
}

std::string row(const PassSummary& summary) {
    return fmt::format("{:<24} {:>9.3f} {:>9.3f} {:>9.3f} {:>9.3f} {:>6.1f}%\n", summary.name,
                       summary.minimum, summary.median, summary.mean, summary.p99,
                       100.0 * summary.share);
}

} // namespace

size_t PassStatistics::index_of(const refresh::PassTime& pass) {
    const auto found = std::ranges::find(names_, pass.name);
    if (found != names_.end()) return static_cast<size_t>(found - names_.begin());
    names_.push_back(pass.name);
    groups_.push_back(pass.group);
    return names_.size() - 1;
}

void PassStatistics::add_frame(std::span<const refresh::PassTime> passes) {
    if (passes.empty()) return; // the first frames are still on their way through the GPU
    std::vector<Time> frame;
    frame.reserve(passes.size());
    for (const refresh::PassTime& pass : passes) {
        frame.push_back({index_of(pass), static_cast<float>(pass.milliseconds)});
    }
    frames_.push_back(std::move(frame));
    if (frames_.size() > capacity) frames_.pop_front();
}

std::vector<PassSummary> PassStatistics::summarize() const {
    std::vector<std::vector<double>> times(names_.size());
    double total = 0.0;
    for (const std::vector<Time>& frame : frames_) {
        for (const Time& time : frame) {
            times[time.pass].push_back(time.milliseconds);
            total += time.milliseconds;
        }
    }
    std::vector<PassSummary> summaries;
    for (size_t i = 0; i < names_.size(); ++i) {
        if (times[i].empty()) continue;
        const double sum = std::accumulate(times[i].begin(), times[i].end(), 0.0);
        summaries.push_back(summary_of(names_[i], times[i]));
        summaries.back().share = total > 0.0 ? sum / total : 0.0;
    }
    return summaries;
}

PassSummary PassStatistics::summarize(const PassSum& wanted) const {
    std::vector<double> sums;
    double total = 0.0, of_group = 0.0;
    for (const std::vector<Time>& frame : frames_) {
        double sum = 0.0;
        for (const Time& time : frame) {
            total += time.milliseconds;
            if (groups_[time.pass] == wanted.group) sum += time.milliseconds;
        }
        if (sum > 0.0) sums.push_back(sum);
        of_group += sum;
    }
    PassSummary summary = summary_of(wanted.name, sums);
    summary.share = total > 0.0 ? of_group / total : 0.0;
    return summary;
}

std::vector<refresh::PassTime> PassStatistics::recent_means(size_t most_frames) const {
    std::vector<refresh::PassTime> means;
    for (size_t pass = 0; pass < names_.size(); ++pass)
        means.push_back({names_[pass], 0.0, groups_[pass]});
    const size_t count = std::min(most_frames, frames_.size());
    for (size_t frame = frames_.size() - count; frame < frames_.size(); ++frame)
        for (const Time& time : frames_[frame])
            means[time.pass].milliseconds += time.milliseconds / static_cast<double>(count);
    std::erase_if(means, [](const refresh::PassTime& mean) { return mean.milliseconds == 0.0; });
    return means;
}

std::string PassStatistics::table(std::span<const PassSum> wanted) const {
    if (frames_.empty()) return "no frames have been timed";
    std::string text = fmt::format("GPU milliseconds over {} frames\n", frames_.size());
    text += fmt::format("{:<24} {:>9} {:>9} {:>9} {:>9} {:>7}\n", "pass", "min", "median", "mean",
                        "p99", "share");
    for (const PassSummary& summary : summarize())
        text += row(summary);
    for (const PassSum& sum : wanted) {
        if (const PassSummary summary = summarize(sum); summary.frames > 0) text += row(summary);
    }

    std::vector<double> totals;
    for (const std::vector<Time>& frame : frames_) {
        totals.push_back(
            std::accumulate(frame.begin(), frame.end(), 0.0,
                            [](double sum, const Time& time) { return sum + time.milliseconds; }));
    }
    PassSummary all = summary_of("all passes", totals);
    all.share = 1.0;
    text += row(all);
    text.pop_back(); // the log ends the last line itself
    return text;
}

} // namespace vigil::client
