// SPDX-License-Identifier: GPL-2.0-or-later
// How much of a change pictures show: light that comes or goes from one frame to the next, against
// references of before and after. No GPU, no files.
#pragma once

#include "bench/reference.h"

#include <glm/vec2.hpp>
#include <span>

namespace vigil::bench {

/// Share of the change that a picture shows: 0 as before, 1 as after. NaN where too little of the
/// picture changes.
struct ChangeShown {
    double brighter = 0.0; // where light comes
    double darker = 0.0;   // where it goes: a trail is what is missing here
};

/// With a, b and x the sums of both references and of the picture over a tile of 8 x 8 pixels, each
/// divided by the larger of a and b: sum of x - a over sum of b - a. Linear in the picture, so its
/// noise averages out; for a filter that mixes the pictures of before and after it is the weight of
/// the latter. Counted are tiles that change by at least a tenth and by 5 times the error of that.
ChangeShown change_shown(std::span<const float> picture, const Reference& before,
                         const Reference& after, glm::ivec2 size);

/// What counts as shown.
inline constexpr double shown_share = 0.9;

/// Number, from 1, of the first frame that shows it; one more than there are where none does. NaN
/// where a value is.
double lag_of(std::span<const double> shown);

} // namespace vigil::bench
