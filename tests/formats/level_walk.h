// SPDX-License-Identifier: GPL-2.0-or-later
// Touches everything a checked level offers, as the rest of the program does: for tests that feed
// damaged files to parse_bsp and let the sanitizers watch.
#pragma once

#include "formats/bsp.h"

namespace vigil {

/// Follows every index, range, chain and tree. Returns a number made of all it saw.
float walk_level(const Bsp& bsp);

} // namespace vigil
