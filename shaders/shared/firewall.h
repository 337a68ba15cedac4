// SPDX-License-Identifier: GPL-2.0-or-later
// What may enter a cache or a mean. A value that is not finite stays in every sum it enters, and
// spreads from there. scene/firewall.glsl counts what is kept out.
#ifndef VIGIL_SHARED_FIREWALL_H
#define VIGIL_SHARED_FIREWALL_H

#include "glsl.h"

SHADER_BEGIN

/// Finite and not negative; -0 counts as 0. Asked of the bits: a driver may take it that floats are
/// never NaN, and drop comparisons that look for them.
SHADER_FN bool is_finite_nonnegative(float value) {
    const uint bits = floatBitsToUint(value);
    return bits <= 0x7f7fffffu || bits == 0x80000000u;
}

SHADER_FN bool is_finite_nonnegative(vec3 value) {
    return is_finite_nonnegative(value.x) && is_finite_nonnegative(value.y) && is_finite_nonnegative(value.z);
}

SHADER_END
#endif
