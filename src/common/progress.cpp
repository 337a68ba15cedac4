// SPDX-License-Identifier: GPL-2.0-or-later
#include "common/progress.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <unistd.h>

namespace vigil {

namespace {

constexpr double terminal_interval_s = 0.2, line_interval_s = 30.0;
// Work that ends before it is not worth a line.
constexpr double first_line_s = 5.0;
constexpr int bar_width = 20;

std::string time_text(double seconds) {
    const auto whole = static_cast<int>(seconds);
    return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

} // namespace

ProgressLine::ProgressLine(double bar_after_s, double line_after_s)
    : terminal_(isatty(STDERR_FILENO) != 0), after_s_(terminal_ ? bar_after_s : line_after_s) {}

void ProgressLine::clear() {
    if (terminal_ && shown_) fmt::print(stderr, "\r\033[K");
}

void ProgressLine::show(double share, const std::string& text) {
    const double now = watch_.seconds();
    const double interval = terminal_ ? terminal_interval_s : line_interval_s;
    if (shown_ ? now - shown_s_ < interval : now < after_s_) return;
    shown_ = true;
    shown_s_ = now;
    if (terminal_) {
        const int filled = static_cast<int>(bar_width * std::clamp(share, 0.0, 1.0));
        fmt::print(stderr, "\r\033[K[{:#<{}}{:.<{}}] {}", "", filled, "", bar_width - filled, text);
    } else {
        fmt::print(stderr, "{}\n", text);
    }
    std::fflush(stderr);
}

Progress::Progress(int steps) : steps_(steps), line_(0.0, first_line_s) {}

void Progress::begin(std::string_view part) {
    part_ = part;
    show("");
}

void Progress::advance(const std::string& what) {
    ++done_;
    if (done_ - skipped_ == 1) first_s_ = line_.seconds();
    show(what);
}

void Progress::note(const std::string& what) {
    show(what);
}

void Progress::skip(int steps) {
    done_ += steps;
    skipped_ += steps;
}

void Progress::show(const std::string& what) {
    const int paced = done_ - skipped_ - 1;
    const double worked_s = line_.seconds() - first_s_;
    const std::string left = paced > 0 ? time_text(worked_s / paced * (steps_ - done_)) + " left"
                                       : "time left not known yet";
    std::string text = part_;
    if (!what.empty()) text += text.empty() ? what : ": " + what;
    if (!text.empty()) text += ", ";
    text += fmt::format("{} of {}, {}", done_, steps_, left);
    line_.show(static_cast<double>(done_) / std::max(steps_, 1), text);
}

} // namespace vigil
