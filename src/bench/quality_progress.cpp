// SPDX-License-Identifier: GPL-2.0-or-later
#include "bench/quality_progress.h"

#include <fmt/format.h>

#include <cstdio>
#include <unistd.h>

namespace vigil::bench {

namespace {

constexpr double line_interval_s = 30.0;

std::string time_text(double seconds) {
    const auto whole = static_cast<int>(seconds);
    return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

} // namespace

Progress::Progress(const QualityOptions& options)
    : runs_per_level_(options.views * options.seeds * static_cast<int>(options.rows.size())),
      runs_(runs_per_level_ * static_cast<int>(options.levels.size())),
      terminal_(isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
    if (terminal_) fmt::print(stderr, "\r\033[K");
}

void Progress::begin(std::string_view level) {
    level_ = level;
    ++levels_;
    show("loading");
}

void Progress::advance(const std::string& what) {
    ++done_;
    show(what);
}

void Progress::note(const std::string& what) {
    show(what);
}

void Progress::skip_level() {
    done_ = levels_ * runs_per_level_;
}

void Progress::show(const std::string& what) {
    const double now = watch_.seconds();
    if (!terminal_ && shown_s_ > 0.0 && now - shown_s_ < line_interval_s) return;
    shown_s_ = now;
    // References count with the runs before them: the pace is that of all work so far.
    const std::string left =
        done_ > 0 ? time_text(now / done_ * (runs_ - done_)) + " left" : "time left not known yet";
    const std::string text =
        fmt::format("{}: {} ({} of {} runs, {})", level_, what, done_, runs_, left);
    if (terminal_)
        fmt::print(stderr, "\r\033[K{}", text);
    else
        fmt::print(stderr, "{}\n", text);
    std::fflush(stderr);
}

} // namespace vigil::bench
