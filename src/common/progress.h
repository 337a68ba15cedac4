// SPDX-License-Identifier: GPL-2.0-or-later
// Progress of long work on stderr: what is being done, and how long it will still take at the pace
// so far. A bar that changes on a terminal, a line every half minute elsewhere.
#pragma once

#include "common/stopwatch.h"

#include <string>
#include <string_view>

namespace vigil {

class Progress {
public:
    /// `steps` of about the same length will be done.
    explicit Progress(int steps);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// A part of the work begins; its name is shown with what follows.
    void begin(std::string_view part);
    /// One more step is done.
    void advance(const std::string& what);
    /// Something that is not counted is under way.
    void note(const std::string& what);
    /// Removes the bar, for lines that are printed meanwhile; it comes back by itself.
    void clear();
    /// Steps that need no work after all: they do not count for the pace.
    void skip(int steps);

    int done() const { return done_; }

private:
    void show(const std::string& what);

    int steps_;
    int done_ = 0;
    int skipped_ = 0;
    bool terminal_;
    bool shown_ = false;
    std::string part_;
    Stopwatch watch_;
    double shown_s_ = 0.0;
};

} // namespace vigil
