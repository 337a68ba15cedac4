// SPDX-License-Identifier: GPL-2.0-or-later
#include "common/progress.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <unistd.h>

namespace vigil {

namespace {

// Work that ends before the first of them is not worth a line.
constexpr double terminal_interval_s = 0.2, line_interval_s = 30.0, first_line_s = 5.0;
constexpr int bar_width = 20;

std::string time_text(double seconds) {
    const auto whole = static_cast<int>(seconds);
    return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

} // namespace

Progress::Progress(int steps) : steps_(steps), terminal_(isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
    clear();
}

void Progress::clear() {
    if (terminal_ && shown_) fmt::print(stderr, "\r\033[K");
}

void Progress::begin(std::string_view part) {
    part_ = part;
    show("");
}

void Progress::advance(const std::string& what) {
    ++done_;
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
    const double now = watch_.seconds();
    const double interval = terminal_ ? terminal_interval_s : line_interval_s;
    if (shown_ ? now - shown_s_ < interval : !terminal_ && now < first_line_s) return;
    shown_ = true;
    shown_s_ = now;
    const int worked = done_ - skipped_;
    const std::string left = worked > 0 ? time_text(now / worked * (steps_ - done_)) + " left"
                                        : "time left not known yet";
    std::string text = part_;
    if (!what.empty()) text += text.empty() ? what : ": " + what;
    if (!text.empty()) text += ", ";
    text += fmt::format("{} of {}, {}", done_, steps_, left);
    if (terminal_) {
        const int filled = bar_width * std::min(done_, steps_) / std::max(steps_, 1);
        fmt::print(stderr, "\r\033[K[{:#<{}}{:.<{}}] {}", "", filled, "", bar_width - filled, text);
    } else {
        fmt::print(stderr, "{}\n", text);
    }
    std::fflush(stderr);
}

} // namespace vigil
