// SPDX-License-Identifier: GPL-2.0-or-later
// Buffers of the passes after the path tracer: the running mean, the exposure, the finished picture.
#ifndef VIGIL_POST_PICTURE_GLSL
#define VIGIL_POST_PICTURE_GLSL

#include "scene/frame.glsl"
#include "shared/brdf.h"

layout(set = SET_SCENE, binding = BINDING_ACCUMULATION, scalar) restrict buffer AccumulationBlock {
    vec3 mean_radiance[]; // by pixel; then, by pixel again, what rounding has left out (shared/running_mean.h)
};
// Result first, then one partial sum per tile.
layout(set = SET_SCENE, binding = BINDING_EXPOSURE, scalar) restrict buffer ExposureBlock {
    float exposure;
    vec2 exposure_tiles[]; // cube root of the mean luminance and 1; (0, 0) where the tile is black
};
layout(set = SET_SCENE, binding = BINDING_DISPLAY, scalar) restrict buffer DisplayBlock {
    uint display[]; // RGBA8, sRGB
};

#endif
