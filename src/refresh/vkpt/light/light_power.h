// SPDX-License-Identifier: GPL-2.0-or-later
// What a light emits, as tables of lights weigh it.
#pragma once

#include "shared/brdf.h"
#include "shared/triangle_light.h"

#include <algorithm>

namespace vigil {

/// Keeps a weight finite and not negative, whatever a level holds: in [0, 1e30].
inline float finite_weight(float weight) {
    return weight > 0.0f ? std::min(weight, 1e30f) : 0.0f; // also for NaN
}

/// Area times luminance of a light: its power over pi. In [0, 1e30].
inline float light_power(const shader::Light& light) {
    return finite_weight(shader::light_area(light) * shader::luminance(light.radiance));
}

} // namespace vigil
