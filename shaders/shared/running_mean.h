// SPDX-License-Identifier: GPL-2.0-or-later
// The mean of values that come one after the other, for hours if need be. A step towards the newest
// of a million values is a few units in the last place of the mean: rounded to whole ones,
// fireflies that come once in a thousand frames shifted it by 0.2% in four hours. So what rounding
// leaves out is carried to the next step (Kahan 1965).
#ifndef VIGIL_SHARED_RUNNING_MEAN_H
#define VIGIL_SHARED_RUNNING_MEAN_H

#include "glsl.h"

SHADER_BEGIN

/// Moves the mean of `count` values to that of these and one more. With none, `mean` and `carry`
/// may hold anything. `carry` is what the mean lacks of its exact value.
SHADER_FN void add_to_mean(INOUT(vec3) mean, INOUT(vec3) carry, uint count, vec3 value) {
    if (count == 0u) {
        mean = value;
        carry = vec3(0.0f);
        return;
    }
    PRECISE vec3 step = (value - mean) / (float(count) + 1.0f) + carry;
    PRECISE vec3 moved = mean + step;
    PRECISE vec3 rounded = moved - mean;
    PRECISE vec3 rest = step - rounded;
    mean = moved;
    carry = rest;
}

SHADER_END
#endif
