// SPDX-License-Identifier: GPL-2.0-or-later
// What a filter leaves of texture and of shadows' edges: steps between neighbouring pixels of one
// surface, against those of the reference. No GPU, no files.
#pragma once

#include "bench/reference.h"
#include "shared/scene_types.h"

#include <cstddef>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace vigil::bench {

/// 1: steps are as in the reference; 0: none is left. NaN where there are too few.
struct Detail {
    double texture = 0.0; // pairs of pixels whose surface has different colours
    double shadow = 0.0;  // pairs of one colour between which the reference's light changes
    std::size_t texture_pairs = 0, shadow_pairs = 0;
};

/// With x and r the steps of luminance over the reference's mean luminance of the pair, and v the
/// variance of r by the reference's own noise: sum of x r over sum of r^2 - v. Linear in the
/// picture, so its noise makes no detail. Steps count from a tenth on, those at shadows only where
/// they are 5 times their own error. `hits` belongs to the picture, a pixel each.
Detail detail_kept(std::span<const float> picture, const Reference& reference,
                   std::span<const shader::PrimaryHit> hits, glm::ivec2 size);

} // namespace vigil::bench
