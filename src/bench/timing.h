// SPDX-License-Identifier: GPL-2.0-or-later
// What frames cost while the camera moves, pass by pass: the experiment of the paper's figures 11
// and 12. Rows take turns; what a repeat loses to other work on the machine, the median over
// repeats of the same frame does not show.
#pragma once

#include "bench/quality_estimate.h"
#include "bench/quality_renderer.h"
#include "client/measure/pass_statistics.h"
#include "common/progress.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace vigil::bench {

struct TimingRow {
    QualityRow row;
    // Median over the repeats, [frame][pass] in the order of refresh/vkpt/gpu/passes.h,
    // milliseconds.
    std::vector<std::vector<double>> pass_ms;
    Strata prepare_ms, path_ms, frame_ms; // [frame][repeat]
};

struct TimingResult {
    std::string level;
    std::vector<TimingRow> rows;
};

/// Times of the frames that lead to the renderer's first place. One step of progress for every
/// seed and row.
TimingResult measure_times(const QualityOptions& options, QualityRenderer& renderer,
                           const std::string& level, Progress& progress);

std::string timing_text(const QualityOptions& options, const TimingResult& result);
nlohmann::ordered_json timing_json(const QualityOptions& options, const TimingResult& result);

} // namespace vigil::bench
