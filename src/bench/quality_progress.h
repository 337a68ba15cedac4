// SPDX-License-Identifier: GPL-2.0-or-later
// Progress of the quality benchmark on stderr: what is being done, and how long it will still take
// at the pace so far. One line that changes on a terminal, a line every half minute elsewhere.
#pragma once

#include "bench/quality_options.h"
#include "common/stopwatch.h"

#include <string>
#include <string_view>

namespace vigil::bench {

class Progress {
public:
    explicit Progress(const QualityOptions& options);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void begin(std::string_view level);
    /// One more run of one row is done.
    void advance(const std::string& what);
    /// Something that is not counted, such as a reference, is under way.
    void note(const std::string& what);
    /// The level that began last will not be measured any further.
    void skip_level();

private:
    void show(const std::string& what);

    int runs_per_level_;
    int runs_;
    int done_ = 0;
    int levels_ = 0;
    bool terminal_;
    std::string level_;
    Stopwatch watch_;
    double shown_s_ = 0.0;
};

} // namespace vigil::bench
