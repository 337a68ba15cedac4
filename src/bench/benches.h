// SPDX-License-Identifier: GPL-2.0-or-later
// The benchmarks that are no experiments about quality (plan.h). Each parses the words after its
// name, throws Error where they are wrong, prints a table and returns the exit status.
#pragma once

#include <span>
#include <string>

namespace vigil::bench {

/// How long the Light Hierarchy takes to build on the host, and how large it is, for 100 to 100,000
/// lamps in a hall; the best of 15 builds. Its table is in docs/internals/light-sampling.md.
int run_hierarchy_bench(std::span<const std::string> arguments);

/// Rays per second of the compute backend and of Embree on the same rays in the same run. Returns 1
/// when answers differ from Embree's by more than edges explain.
int run_trace_bench(std::span<const std::string> arguments);

} // namespace vigil::bench
