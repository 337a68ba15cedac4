// SPDX-License-Identifier: GPL-2.0-or-later
// Progress of long work on stderr: what is being done, and how long it will still take at the pace
// so far. A bar that changes on a terminal, a line every half minute elsewhere.
#pragma once

#include "common/stopwatch.h"

#include <string>
#include <string_view>

namespace vigil {

/// Says on stderr how far work is: a bar on a terminal, now and then a line elsewhere.
class ProgressLine {
public:
    /// Nothing is said of work that ends before `bar_after_s` on a terminal, elsewhere before
    /// `line_after_s`.
    ProgressLine(double bar_after_s, double line_after_s);
    ~ProgressLine() { clear(); }
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    /// `share` of the work is done, 0..1.
    void show(double share, const std::string& text);
    /// Removes the bar, for lines that are printed meanwhile; it comes back by itself.
    void clear();
    double seconds() const { return watch_.seconds(); }

private:
    bool terminal_;
    double after_s_;
    bool shown_ = false;
    Stopwatch watch_;
    double shown_s_ = 0.0;
};

class Progress {
public:
    /// `steps` of about the same length will be done.
    explicit Progress(int steps);

    /// A part of the work begins; its name is shown with what follows.
    void begin(std::string_view part);
    /// One more step is done.
    void advance(const std::string& what);
    /// Something that is not counted is under way.
    void note(const std::string& what);
    /// As ProgressLine::clear().
    void clear() { line_.clear(); }
    /// Steps that need no work after all: they do not count for the pace. Nor does the first step
    /// that is done: it also prepares what the others use.
    void skip(int steps);

    int done() const { return done_; }

private:
    void show(const std::string& what);

    int steps_;
    int done_ = 0;
    int skipped_ = 0;
    double first_s_ = 0.0; // when the first step that is not skipped was done
    std::string part_;
    ProgressLine line_;
};

} // namespace vigil
