// SPDX-License-Identifier: GPL-2.0-or-later
// `vigil_bench trace`: rays per second of the compute backend and of Embree on the same rays in the
// same run.
#pragma once

#include <span>
#include <string>

namespace vigil::bench {

/// Options: --quick (fewer rays), --json FILE, --basedir FOLDER (more than one: tried in order),
/// --level NAME (more than one; without it warehouse, gallery, e3m6 and random triangles),
/// --storage (nodes as a storage buffer). Returns the exit code: 1 when answers differ from
/// Embree's by more than edges explain.
int run_trace_bench(std::span<const std::string> arguments);

} // namespace vigil::bench
