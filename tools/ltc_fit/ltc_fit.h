// SPDX-License-Identifier: GPL-2.0-or-later
// Fits linearly transformed cosines to the GGX lobe of shaders/shared/brdf.h (Heitz et al. 2016 has
// the idea; the objective here is our own). The fit serves the choice of lights, so it minimises
// the cross entropy to the lobe under the very mixture that light selection uses. It knows nothing
// of Fresnel beyond Schlick's split.
#pragma once

#include "shared/ltc.h"

#include <vector>

namespace vigil {

/// One table entry with how good it is.
struct LtcFit {
    shader::LtcEntry entry;
    double excess; // variance of directions drawn from the fit, over the squared lobe: 0 = perfect
};

/// The fit at a GGX width in (0, 1] and a view cosine in (0, 1]. Deterministic.
LtcFit fit_ltc(double alpha, double view_cosine);

/// Width and view cosine of a table's row and column: the inverse of shader::ltc_cell.
double ltc_table_alpha(unsigned column);
double ltc_table_view_cosine(unsigned row);

/// All LTC_TABLE_SIZE^2 entries, in the order that shader::ltc_cell states.
std::vector<LtcFit> fit_ltc_table();

} // namespace vigil
