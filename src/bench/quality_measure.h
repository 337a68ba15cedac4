// SPDX-License-Identifier: GPL-2.0-or-later
// How one part of an experiment is measured: for every view all frames of all rows, then a
// reference that is good enough for the best of them, then the errors.
#pragma once

#include "bench/quality_renderer.h"
#include "bench/quality_report.h"
#include "common/progress.h"

#include <string>

namespace vigil::bench {

/// Errors and times of single frames. One step of progress for every view, seed and row.
LevelResult measure_errors(const QualityOptions& options, QualityRenderer& renderer,
                           const std::string& level, Progress& progress);

/// Errors frame by frame from an empty cache; steps as above.
CurveResult measure_curve(const QualityOptions& options, QualityRenderer& renderer,
                          const std::string& level, Progress& progress);

} // namespace vigil::bench
