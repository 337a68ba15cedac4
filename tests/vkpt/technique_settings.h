// SPDX-License-Identifier: GPL-2.0-or-later
// The settings under which the light-sampling techniques are tested: the defaults of every row of
// shared/techniques.h, and more of some, so that lists are longer than what is weighted of them,
// caches have several buckets, and presets are tested too.
#pragma once

#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

namespace vigil::test {

/// What is known about draws that find no light.
struct Blanks {
    /// Lights per walk: a list is walked in equal parts, any of which may hold only lights that
    /// cannot shine. 0: nothing is known, and only the draws themselves tell.
    uint32_t walk = 0;
    uint32_t parts = 1;     // or their number, if that is bounded
    double share = 1.0;     // of the draws that do so; the others always find a light
    bool sun_apart = false; // where the sun can shine, half of the draws are of it alone
};

struct TechniqueSettings {
    std::string_view technique, label;
    std::vector<std::pair<std::string_view, std::string_view>> variables;
    Blanks blanks;
    /// Whether whole pictures are compared, too; it takes some seconds for each.
    bool pictures = true;
    /// Relative bias of five neighbouring blocks that may not hide between such a picture and one
    /// of the first technique: what weighs few lights, or not how near they are, is noisier.
    double five_blocks = 0.15;
    bool caches = true; // `vlc` has them; else it draws from cuts alone, but for light from the sky

    void set() const;
};

/// At least one for every technique, in the order of the techniques.
std::vector<TechniqueSettings> technique_settings();

} // namespace vigil::test
