// SPDX-License-Identifier: GPL-2.0-or-later
// What the ring experiment is asked to do. docs/quality.md lists it.
#pragma once

#include "bench/quality_options.h"

#include <span>
#include <string>
#include <vector>

namespace vigil::bench {

/// What counts as settled after a turn: the mean of so many last frames, reached at ring_factor
/// times that.
inline constexpr int ring_tail = 20;
inline constexpr double ring_factor = 1.1;

struct RingOptions {
    glm::ivec2 size{240, 136};
    // Turns of the lamp, degrees, and quadtree sizes, bits: those of the paper.
    std::vector<int> turns = {9, 36};
    std::vector<int> bits = {32, 64, 96, 128};
    int seeds = 6;
    int settle = 100;          // frames before the turn
    int frames = 60;           // frames after it
    int reference_paths = 512; // per pixel
    bool fresh = false;        // references are made anew
    bool keep = false;         // a finished report of the same measurement is left as it is
    std::vector<Setting> settings;
    std::string json; // empty: outdir/ring.json
};

/// Parses the words after `ring`. Throws Error that lists the options when one is unknown, and when
/// a value is no number or out of range.
RingOptions parse_ring_options(std::span<const std::string> arguments);

/// One row per size of quadtree, bits, and one with rays drawn by the BRDF alone, the last.
std::vector<QualityRow> ring_rows(std::span<const int> sizes);

} // namespace vigil::bench
