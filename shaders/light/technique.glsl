// SPDX-License-Identifier: GPL-2.0-or-later
// "Choose a light, and say how probable that was": includes the technique this shader is compiled for. A
// technique's file defines two functions:
//   LightChoice choose_light(Surface surface, inout Random random)   draws a light
//   float light_probability(Surface surface, uint light)             probability with which it draws that one
// and declares its buffers in set SET_TECHNIQUE. A technique that defines LEARNS_FROM_LIGHT_SAMPLES as 1 defines a third,
//   void learn_light(LightChoice choice, bool seen)                  what became of a draw: once per pixel, path vertex and frame
// Its host side is refresh/vkpt/light/NAME.cpp, its row
// is in shared/techniques.h. selected_technique.glsl is made by the build, one per row.
#ifndef VIGIL_LIGHT_TECHNIQUE_GLSL
#define VIGIL_LIGHT_TECHNIQUE_GLSL

#include "pathtrace/surface.glsl"
#include "shared/random.h"
#include "shared/triangle_light.h"

struct LightChoice {
    uint light;        // id, or NONE: there is nothing to sample here
    float probability; // of having chosen it, in (0, 1]
    bool explored;     // drawn by a second technique that only looks for new lights
    uint memory;       // where learn_light puts what became of it: the technique's business
};

LightChoice light_choice(uint light, float probability) { return LightChoice(light, probability, false, 0u); }

#include "selected_technique.glsl"

#ifndef LEARNS_FROM_LIGHT_SAMPLES
#define LEARNS_FROM_LIGHT_SAMPLES 0
void learn_light(LightChoice choice, bool seen) {}
#endif

#endif
