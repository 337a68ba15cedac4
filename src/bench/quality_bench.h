// SPDX-License-Identifier: GPL-2.0-or-later
// `vigil_bench quality`: how much noise every technique leaves at one sample per pixel, and what it
// costs, after the experiments of the paper's sections 7.1 and 7.2. docs/quality.md explains the
// numbers.
#pragma once

#include <span>
#include <string>

namespace vigil::bench {

/// Prints tables and writes the JSON report. Returns 0; 1 when a level could not be measured.
/// Throws Error for options it does not understand.
int run_quality_bench(std::span<const std::string> arguments);

} // namespace vigil::bench
