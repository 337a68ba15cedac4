// SPDX-License-Identifier: GPL-2.0-or-later
// What debug/light_floor.comp says about one light at one pixel.
#ifndef VIGIL_SHARED_LIGHT_FLOOR_H
#define VIGIL_SHARED_LIGHT_FLOOR_H

#include "glsl.h"

SHADER_BEGIN

/// Of the estimator `radiance by way of this light`, from all samples and from every second one.
struct LightFloorValue {
    float root; // of the second moment, averaged over the channels
    float even_root;
    float odd_root;
    vec3 even_mean;
    vec3 odd_mean;
};

SHADER_END

#endif
