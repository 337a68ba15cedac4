// SPDX-License-Identifier: GPL-2.0-or-later
// A rectangle that pass `draws` lays over the finished picture: part of a registered picture, or a
// colour. Scalar layout; the same text is C++ and GLSL.
#ifndef VIGIL_SHARED_DRAW_H
#define VIGIL_SHARED_DRAW_H

#include "glsl.h"

SHADER_BEGIN

struct DrawRect {
    ivec2 corner; // of all of it, in pixels from the top left of the screen
    ivec2 size;
    ivec2 shown_from; // the part that is clipped to; from here up to, without, shown_to
    ivec2 shown_to;
    vec2 from; // the part of the picture, 0..1 from its top left
    vec2 to;
    vec4 color;         // sRGB-encoded factor, and opacity
    uint first_texel;   // of the picture
    uvec2 picture_size; // 0, 0: the colour alone
};

SHADER_END
#endif
