// SPDX-License-Identifier: GPL-2.0-or-later
// What experiments about quality found, and how it is told: tables for people, JSON for programs.
// Every number has the reference's error beside it, and an interval where there is one. No GPU.
#pragma once

#include "bench/light_floor.h"
#include "bench/quality_estimate.h"
#include "bench/quality_options.h"
#include "bench/quality_places.h"

#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

namespace vigil::bench {

/// One row of a level; every Strata is [view][seed].
struct RowResult {
    QualityRow row;
    Strata mse, trimmed_mse, bright_mse, relative_mse, mean_ratio;
    // Of the reference, in the pixels that trimmed_mse and bright_mse are about. Views without
    // bright pixels are left out of the latter.
    Strata trimmed_variance, bright_variance;
    Strata unlit, explored;      // shares of primary hits
    std::vector<Strata> pass_ms; // by pass
    Strata prepare_ms, path_ms;  // sums: passes of guiding; primary, direct and indirect
    Strata frame_ms;             // whole frames, by the clock of the host
};

/// A place and the reference it was measured against.
struct ViewResult {
    Place place;
    std::string technique; // of the reference
    int paths = 0;         // per pixel
    bool reached = true;   // false: it stopped at the most paths, with more variance than wanted
    double mean = 0.0;     // radiance, over the picture
    double mean_error = 0.0;
    double variance = 0.0; // mean over pixels and channels; taken off every MSE
    double relative_variance = 0.0;
    double smallest_mse = 0.0; // of the rows here
    LightFloor floor;          // with --floor
    std::string pictures;      // folder of those of this view; empty: none
};

struct LevelResult {
    std::string level;
    std::vector<ViewResult> views;
    std::vector<RowResult> rows;
    std::uint32_t nonfinite = 0;
};

/// Error by frame from an empty cache: [frame], then [view][seed].
struct CurveRow {
    QualityRow row;
    std::vector<Strata> mse, trimmed_mse;
};

struct CurveResult {
    std::string level;
    std::vector<ViewResult> views;
    std::vector<CurveRow> rows;
};

/// The settled error of a curve and the frame where it is reached.
Settled settled_of(const std::vector<Strata>& curve);

/// A row's error, one of the Strata above, over the baseline's; all NaN where one of them misses
/// light (misses_light).
struct ErrorRatios {
    double means = 0.0; // ratio_of_means
    Comparison typical; // typical_ratio
    Interval over_views;
};
ErrorRatios error_ratios(const RowResult& row, const RowResult& baseline, Strata RowResult::*error);

/// The same when both rows may take as long: variance falls with the number of samples, so it is
/// error times frame time that is compared, run by run. Without `over_views`; `error` has all
/// views.
ErrorRatios at_equal_time(const RowResult& row, const RowResult& baseline,
                          Strata RowResult::*error);

/// 1 / (error x seconds of a frame), the efficiency of an estimator.
double efficiency(const RowResult& row, Strata RowResult::*error);

/// The floor over a row's error: 1 is a perfect choice of lights.
double share_of_floor(const std::vector<ViewResult>& views, const RowResult& row);

std::string quality_text(const QualityOptions& options, const LevelResult& result);
std::string curve_text(const QualityOptions& options, const CurveResult& result);

nlohmann::ordered_json quality_json(const QualityOptions& options, const LevelResult& result);
nlohmann::ordered_json curve_json(const CurveResult& result);
nlohmann::ordered_json to_json(const Interval& interval);
nlohmann::ordered_json to_json(const Comparison& comparison);
/// The mean and the typical run.
nlohmann::ordered_json values_json(const Strata& values);
nlohmann::ordered_json to_json(const QualityRow& row);
/// Name: value.
nlohmann::ordered_json variables_json(std::span<const Setting> settings);

} // namespace vigil::bench
