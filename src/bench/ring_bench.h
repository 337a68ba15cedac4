// SPDX-License-Identifier: GPL-2.0-or-later
// `ring`: how long directional quadtrees take to follow a light that turns at once, and what the
// picture looks like until then (the paper's section 7.3 and figure 10).
#pragma once

#include <span>
#include <string>

namespace vigil::bench {

/// Runs it with the words after its name; the exit status. Throws Error.
int run_ring_bench(std::span<const std::string> arguments);

} // namespace vigil::bench
