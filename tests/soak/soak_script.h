// SPDX-License-Identifier: GPL-2.0-or-later
// What random play typed, written down as a cfg file that types it again at the same frames. It is
// on the disk before it is run, so that a crash leaves what led to it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string_view>

namespace vigil::client {

class SoakScript {
public:
    /// Begins the file anew with the comment `title` (one line). Throws Error when it cannot be
    /// written.
    SoakScript(std::filesystem::path path, std::string_view title);

    /// Commands that run before the next frame (lines, often none). Throws Error when they cannot
    /// be written.
    void add_frame(std::string_view commands);

private:
    void write(std::string_view text);

    std::filesystem::path path_;
    std::ofstream file_;
    uint64_t frames_ = 0; // since the last commands
};

} // namespace vigil::client
