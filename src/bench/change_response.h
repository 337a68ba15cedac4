// SPDX-License-Identifier: GPL-2.0-or-later
// How much of a change pictures show: light that comes or goes from one frame to the next, against
// references of before and after. No GPU, no files.
#pragma once

#include "bench/reference.h"

#include <cstddef>
#include <span>

namespace vigil::bench {

/// Share of the change that a picture shows: 0 as before, 1 as after. NaN where too few pixels
/// change.
struct ChangeShown {
    double brighter = 0.0; // over the pixels that become brighter
    double darker = 0.0;   // the others: a trail of light is what is missing here
};

/// With a and b the references, x the picture, all divided by the brighter reference of the pixel:
/// sum of x - a over sum of b - a. Linear in the picture, so its noise averages out; for a filter
/// that mixes the pictures of before and after it is the weight of the latter. Counted are pixels
/// that change by at least a tenth and by 5 times the error of that. The references' noise is also
/// in the divisor: with variance v it makes a share too large by v / (b (b - a)), 2% at most.
ChangeShown change_shown(std::span<const float> picture, const Reference& before,
                         const Reference& after);

/// What counts as shown.
inline constexpr double shown_share = 0.9;

/// Number, from 1, of the first frame that shows it; one more than there are where none does. NaN
/// where a value is.
double lag_of(std::span<const double> shown);

} // namespace vigil::bench
