// SPDX-License-Identifier: GPL-2.0-or-later
// Keeps what is not finite, or negative, out of caches and means: counts each such value, marks the pixel whose path it was met on
// (pt_view nonfinite), and hands on 0 instead. Nothing that is finite is changed, however bright.
#ifndef VIGIL_SCENE_FIREWALL_GLSL
#define VIGIL_SCENE_FIREWALL_GLSL

#include "scene/frame.glsl"
#include "shared/firewall.h"

/// The pixel whose path this invocation traces; NONE in passes that trace none.
uint firewall_pixel = NONE;

void count_nonfinite() {
    // Stops below the top: a count that has come round to 0 would say that all is well.
    if (counters.nonfinite < 0xf0000000u) atomicAdd(counters.nonfinite, 1u);
    if (firewall_pixel != NONE) pixel_flags[firewall_pixel] |= PIXEL_NONFINITE;
}

float finite_or_zero(float value) {
    if (is_finite_nonnegative(value)) return value;
    count_nonfinite();
    return 0.0;
}

vec3 finite_or_zero(vec3 value) {
    if (is_finite_nonnegative(value)) return value;
    count_nonfinite();
    return vec3(0.0);
}

#endif
