// SPDX-License-Identifier: GPL-2.0-or-later
// What a screen shows of radiance, as the renderer's pass tonemap does it (filmic), with an
// exposure that all pictures of a view share. Before sRGB's curve, which FLIP undoes.
#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace vigil::bench {

/// The factor from radiance to brightness: 0.18 over the geometric mean of the mean luminances of
/// 8 x 8 tiles (Reinhard et al. 2002); black tiles do not count. Pass `exposure` has another rule
/// today; with this one reports of all commits compare. `rgb`: 3 values per pixel, rows from the
/// top.
double exposure_of(std::span<const float> rgb, glm::ivec2 size);

/// Linear display values, 0 to 1.
std::vector<float> displayed(std::span<const float> rgb, double exposure);

} // namespace vigil::bench
