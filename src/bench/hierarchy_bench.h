// SPDX-License-Identifier: GPL-2.0-or-later
// Benchmark `hierarchy`: how long the Light Hierarchy takes to build on the host, and how large it
// is, for 100 to 100,000 lamps in a hall; the best of 15 builds. Its table is in
// docs/light-sampling.md.
#pragma once

#include <span>
#include <string>

namespace vigil::bench {

/// Prints the table; there are no options. Throws Error if there are words after the name. Returns
/// 0.
int run_hierarchy_bench(std::span<const std::string> arguments);

} // namespace vigil::bench
