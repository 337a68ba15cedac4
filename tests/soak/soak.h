// SPDX-License-Identifier: GPL-2.0-or-later
// Random play: keys, levels, demos, techniques and all variables of the path tracer, switched at
// random for minutes or hours, in search of what no test thought of. It types at the console as a
// person would; same seed, same words.
#pragma once

#include "common/stopwatch.h"
#include "console/cvar.h"

#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace vigil::client {

/// What random play may choose from.
struct SoakChoices {
    std::vector<std::string> levels;
    std::vector<std::string> demos; // with their endings
};

class Soak {
public:
    /// Makes the renderer anew: typed alone in its frame.
    static constexpr std::string_view restart = "vid_restart\n";

    Soak(SoakChoices choices, uint32_t seed);

    /// Console commands to run before the next frame; often none. `walks`: a player walks or flies
    /// in a level, rather than a demo's.
    std::string next(bool walks);

    uint64_t frames() const { return frames_; }
    uint64_t switches() const { return switches_; }
    uint64_t levels() const { return levels_; }

private:
    bool chance(double probability);
    size_t pick(size_t count);
    std::string random_variable();
    std::string random_value(const CvarInfo& info);
    std::string random_key();
    std::string random_level();

    SoakChoices choices_;
    std::mt19937 random_;
    std::vector<const CvarInfo*> variables_; // that it turns
    uint64_t frames_ = 0, switches_ = 0, levels_ = 0;
};

} // namespace vigil::client
