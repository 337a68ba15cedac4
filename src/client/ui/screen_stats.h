// SPDX-License-Identifier: GPL-2.0-or-later
// The lines of scr_stats: frame time, GPU times by groups of passes or by pass, what lights the
// picture, and its size. They change twice a second, so that they can be read.
#pragma once

#include "client/measure/pass_statistics.h"
#include "console/cvar.h"

#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace vigil::client {

class ScreenStats {
public:
    /// One more frame, of this many seconds.
    void add_frame(double seconds, const PassStatistics& gpu, const CvarRegistry& variables,
                   glm::ivec2 picture_size);
    const std::vector<std::string>& lines() const { return lines_; }

private:
    static constexpr double interval_s = 0.5;
    static constexpr size_t most_frames = 30; // that GPU times are means over

    void add_passes(const std::vector<refresh::PassTime>& passes, bool each);

    int frames_ = 0;
    double seconds_ = 0.0;
    std::vector<std::string> lines_;
};

/// What lights the picture: "vlc+cdq", or "vlc+cdq | sll" while techniques are compared.
std::string technique_text(const CvarRegistry& variables);

} // namespace vigil::client
