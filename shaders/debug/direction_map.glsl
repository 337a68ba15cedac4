// SPDX-License-Identifier: GPL-2.0-or-later
// The map of light that arrives at the crosshair's surface (pt_view cdq), made by the pass `directions`: luminance per unit
// of the octahedral square, as a running mean over frames.
#ifndef VIGIL_DEBUG_DIRECTION_MAP_GLSL
#define VIGIL_DEBUG_DIRECTION_MAP_GLSL

#include "scene/frame.glsl"
#include "shared/direction_map.h"

layout(set = SET_SCENE, binding = BINDING_DIRECTION_MAP, scalar) restrict buffer DirectionMapBlock {
    float direction_sums[DIRECTION_MAP_GROUPS]; // of the cells of each work group
    float directions[];                         // rows of DIRECTION_MAP_EDGE cells
};

PrimaryHit crosshair_hit() {
    const uvec2 pixel = crosshair_pixel(frame.size);
    return load_primary_hit(pixel.y * frame.size.x + pixel.x);
}

#endif
