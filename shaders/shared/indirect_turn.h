// SPDX-License-Identifier: GPL-2.0-or-later
// Indirect light at half rate (pt_indirect_rate): in a filtered frame half of the pixels trace it,
// one colour of a chequerboard, and the other half in the next frame. The filter knows the missing
// half from frames before, or from the four pixels around.
#ifndef VIGIL_SHARED_INDIRECT_TURN_H
#define VIGIL_SHARED_INDIRECT_TURN_H

#include "glsl.h"

SHADER_BEGIN

/// Whose turn it is: all pixels', or those whose coordinates have an even or an odd sum.
SHADER_CONST uint INDIRECT_ALL = 0u;
SHADER_CONST uint INDIRECT_EVEN = 1u;
SHADER_CONST uint INDIRECT_ODD = 2u;

SHADER_FN bool has_indirect_turn(uvec2 pixel, uint turn) { return turn == INDIRECT_ALL || ((pixel.x + pixel.y + turn) & 1u) == 1u; }

/// The pixel of an invocation, so that no lane idles: while only a half has its turn, each stands
/// for two pixels, one above the other.
SHADER_FN uvec2 indirect_pixel(uvec2 invocation, uint turn) {
    if (turn == INDIRECT_ALL) return invocation;
    return uvec2(invocation.x, 2u * invocation.y + ((invocation.x + turn + 1u) & 1u));
}

/// The turn of a filtered frame. Camera rays pass through `points` points of a pixel, an even
/// number, one after the other: the turns change places with each round, so that every pixel sees
/// all points.
SHADER_FN uint indirect_turn_of_frame(uint frame_number, uint points) {
    return ((frame_number + frame_number / points) & 1u) == 0u ? INDIRECT_EVEN : INDIRECT_ODD;
}

SHADER_END
#endif
