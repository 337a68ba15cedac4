// SPDX-License-Identifier: GPL-2.0-or-later
// How a part of an experiment is measured, and what all of them say about it: JSON for programs,
// from which the tables for people are made. Numbers that do not exist are NaN, in files null.
#pragma once

#include "bench/options.h"
#include "bench/quality_estimate.h"
#include "bench/quality_renderer.h"
#include "common/progress.h"

#include <fmt/format.h>

#include <cstddef>
#include <nlohmann/json.hpp>
#include <span>
#include <string>

namespace vigil::bench {

struct PartReport {
    nlohmann::ordered_json json;
    std::string text;
};

/// Measures a level that is in the renderer. One step of progress for every view, seed and row.
using Measure = PartReport(const QualityOptions& options, QualityRenderer& renderer,
                           const std::string& level, Progress& progress);

/// Errors and times of single frames after a warm-up.
Measure measure_errors;
/// Errors frame by frame from an empty cache, or from when something has changed.
Measure measure_curve;
/// What frames cost while the camera moves to the renderer's first place, pass by pass: the paper's
/// figures 11 and 12.
Measure measure_times;
/// The same, and what shaders, memory and uploads cost by the features that shaders are compiled
/// for. Rows are values of pt_features.
Measure measure_economy;
/// Errors frame by frame after the lamp has turned by the first of the turns: the paper's figure
/// 10.
Measure measure_turn;

/// What `picture` measures (options.h: Measured), each in a file of its own.
Measure measure_route, measure_still, measure_change, measure_cut;

nlohmann::ordered_json to_json(const Interval& interval);
nlohmann::ordered_json to_json(const Comparison& comparison);
/// The mean, the typical run, and the values themselves.
nlohmann::ordered_json to_json(const Strata& values);
/// Its label and variables.
nlohmann::ordered_json to_json(const QualityRow& row);
/// Name: value.
nlohmann::ordered_json variables_json(std::span<const Setting> settings);

/// The tables of measure_errors, from its JSON.
std::string errors_text(const QualityOptions& options, const std::string& level,
                        const nlohmann::ordered_json& report);
/// Those of measure_curve.
std::string curve_text(const QualityOptions& options, const std::string& level,
                       const nlohmann::ordered_json& report);

/// Three digits, or "?".
std::string number_text(double value);
/// "[low, high]".
std::string range_text(const Interval& interval);

/// All rows take turns, so that whatever else the machine does falls on all of them: calls
/// run(row, seed).
template <typename Run>
void take_turns(const QualityOptions& options, Progress& progress, const std::string& what,
                const Run& run) {
    for (int seed = 0; seed < options.seeds; ++seed) {
        for (std::size_t row = 0; row < options.rows.size(); ++row) {
            run(row, options.first_seed + seed);
            progress.advance(fmt::format("{} {} of {}", what, seed + 1, options.seeds));
        }
    }
}

} // namespace vigil::bench
