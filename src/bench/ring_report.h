// SPDX-License-Identifier: GPL-2.0-or-later
// What the ring experiment found, and how it is told: a table for people, JSON for programs, CSV
// for anything else. No GPU.
#pragma once

#include "bench/quality_estimate.h"
#include "bench/ring_options.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace vigil::bench {

/// Errors of one row: before the turn, and in every frame after it.
struct RingRow {
    QualityRow row;
    std::vector<double> before;              // [seed]: mean over the last ring_tail frames
    std::vector<std::vector<double>> frames; // [frame][seed]
};

struct RingTurn {
    int degrees = 0;
    double reference_variance = 0.0; // of the picture after the turn; taken off every error
    std::vector<RingRow> rows;       // as ring_rows()
};

/// Means over the seeds.
double before(const RingRow& row);
double in_frame(const RingRow& row, std::size_t frame);
/// The error that the row settles at, and from which frame after the turn on (counted from 1).
Settled settled_after(const RingRow& row);
/// From which frame after the turn on the error is that before the turn again, within ring_factor;
/// one more than there are if it is not.
int readapted_after(const RingRow& row);

std::string ring_text(const RingTurn& turn);
/// The table of a report whose parts are ring_json().
std::string ring_csv(const nlohmann::ordered_json& report);
nlohmann::ordered_json ring_json(const RingTurn& turn);

} // namespace vigil::bench
