// SPDX-License-Identifier: GPL-2.0-or-later
// The second half of parse_bsp: verifies everything that one lump says about another. Not for use
// outside src/formats.
#pragma once

#include "formats/bsp.h"

namespace vigil {

/// Throws Error naming the first fault: an index or range outside its lump, a number that is not
/// finite or too large, a cluster that does not exist, a node tree with loops or too deep.
void check_bsp(const Bsp& bsp);

} // namespace vigil
