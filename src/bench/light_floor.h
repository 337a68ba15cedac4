// SPDX-License-Identifier: GPL-2.0-or-later
// The floor under next event estimation: the variance that the best possible choice of one light
// would leave at each pixel. With E_i the estimator by way of light i (a point on it, the shadow
// ray), choosing i with probability p_i has the second moment sum E[E_i^2] / p_i, which is least,
// (sum sqrt E[E_i^2])^2, for p_i in proportion to the roots. What is left is the noise of points
// and shadows on the lights.
#pragma once

#include "refresh/vkpt/renderer.h"

#include <cstdint>

namespace vigil::bench {

struct LightFloor {
    double variance = 0.0; // mean over pixels and channels
    // By every second pixel and by the others. How far they are apart tells how much to believe;
    // few pixels may hold most of the variance, so a standard error would be too small.
    double halves[2] = {};
    int pixels = 0; // looked at
};

struct LightFloorPlan {
    int samples = 32;  // of every light at every pixel; at least 4, even
    int pixels = 2048; // spread evenly over the picture; at most so many
};

/// The floor at the primary hits of the frame rendered last, by the present variables of the light
/// points. The frame must have been rendered with pt_nee sll, whose lists say which lights can be
/// seen.
///
/// The root of a mean of n squares is too small on average, by a share that falls with 1 / n; the
/// same with half of the samples tells how much, and it is added (Richardson's extrapolation). What
/// is left of it makes the floor a little too low where single samples are rare and large.
LightFloor measure_light_floor(vkpt::VkptRenderer& renderer, const LightFloorPlan& plan);

} // namespace vigil::bench
