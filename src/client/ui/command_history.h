// SPDX-License-Identifier: GPL-2.0-or-later
// Lines typed at the console before, for the up and down keys, kept between runs.
#pragma once

#include <cstddef>
#include <deque>
#include <filesystem>
#include <string>
#include <string_view>

namespace vigil::client {

class CommandHistory {
public:
    /// The oldest lines are forgotten beyond this.
    static constexpr size_t capacity = 500;

    /// Appends a line unless it is empty or repeats the newest one, and goes back to the end.
    void add(std::string_view line);

    /// The next older or newer line. `current` is what stands on the line now; it comes back when
    /// walking down past the newest line. At the oldest line older() stays there.
    std::string older(std::string_view current);
    std::string newer(std::string_view current);

    const std::deque<std::string>& lines() const { return lines_; }

    /// Reads and writes one line of text per entry. A missing file is an empty history. Reading and
    /// writing throw Error with the system's reason.
    void load(const std::filesystem::path& path);
    void save(const std::filesystem::path& path) const;

private:
    std::deque<std::string> lines_;
    size_t position_ = 0; // of the line shown; lines_.size() is the line being typed
    std::string typed_;
};

} // namespace vigil::client
