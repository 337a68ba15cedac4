// SPDX-License-Identifier: GPL-2.0-or-later
// The fitted table of linearly transformed cosines for the GGX lobe, and its look-up on the host.
// The values are written by tools/ltc_fit; shaders/light/ltc.glsl reads the same bytes on the GPU.
#pragma once

#include "shared/ltc.h"

#include <span>

namespace vigil {

/// All LTC_TABLE_SIZE^2 entries in the order that shader::ltc_cell states; the bytes of buffer
/// BINDING_LTC.
std::span<const shader::LtcEntry> ltc_table();

/// The table at a GGX width and the cosine of the view, interpolated as in ltc.glsl.
shader::LtcEntry ltc_lookup(float alpha, float view_cosine);

} // namespace vigil
