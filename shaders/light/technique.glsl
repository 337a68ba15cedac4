// SPDX-License-Identifier: GPL-2.0-or-later
// "Choose a light, and say with which weight it counts": includes the technique this shader is compiled for. A
// technique's file defines two functions:
//   LightChoice choose_light(Surface surface, inout Random random)   draws a light
//   float light_probability(Surface surface, uint light)             probability with which it draws that one
// and declares its buffers in set SET_TECHNIQUE. What else there is to know about it, it says by defining
//   PROBABILITY_IS_EXACT 0        a draw's probability has no closed form: it comes with an estimated weight, and light_probability is
//                                 that of a candidate: above 0 for the same lights, and no more is promised
//   LEARNS_FROM_LIGHT_SAMPLES 1   there is a third function,
//     void learn_light(LightChoice choice, uint outcome)             what became of a draw, of the first path of a pixel
//   DRAWS_BESIDE 1                instead of choose_light there is
//     LightChoice draw_light(Surface surface, float beside, inout Random random)
//                                 The first draw of a surface has `beside` 0, and says in LightChoice.beside with which probability a second one
//                                 is to be made; that gets this as `beside`. A light's probability counts both
//   STORES_LIGHT_SAMPLES 1        learn_light stores every draw in the octree, which counts surfaces by them
//   LIGHTS_FOUND_BY_RAYS 1        rays bring the emission that they run into; no light is drawn
// Its host side is refresh/vkpt/light/NAME.cpp, its row is in shared/techniques.h. selected_technique.glsl is made by the build, one
// per row. docs/research/adding-a-sampler.md leads through an example.
#ifndef VIGIL_LIGHT_TECHNIQUE_GLSL
#define VIGIL_LIGHT_TECHNIQUE_GLSL

#include "scene/surface.glsl"
#include "shared/random.h"
#include "shared/triangle_light.h"

/// A draw. Its contract, which the tests hold every technique to: for each light that can shine on the surface, `weight`, taken as 0
/// in draws of other lights, has the mean 1; with a draw beside it, the sum of both weights has.
struct LightChoice {
    uint light;    // id, or NONE: there is nothing to sample here
    float weight;  // above 0: 1 / probability of the draw, or an unbiased estimate of that
    float beside;  // probability of a second draw
    float least;   // of it: how probable it stays where fewer are made
    bool explored; // drawn by a second technique that only looks for new lights
    uvec2 memory;  // where learn_light puts what became of it: the technique's business
};

/// A draw with an estimated weight.
LightChoice weighted_choice(uint light, float weight) { return LightChoice(light, weight, 0.0, 0.0, false, uvec2(0u)); }

/// A draw whose probability is known, in (0, 1]; any for NONE.
LightChoice light_choice(uint light, float probability) { return weighted_choice(light, light == NONE ? 0.0 : 1.0 / probability); }

/// No draw.
LightChoice no_light() { return weighted_choice(NONE, 0.0); }

// What became of a draw.
const uint LIGHT_UNTRIED = 0u;  // no shadow ray: no light was drawn, or the point on it contributes nothing here
const uint LIGHT_SHADOWED = 1u; // something is in between
const uint LIGHT_SEEN = 2u;

#include "selected_technique.glsl"

#ifndef PROBABILITY_IS_EXACT
#define PROBABILITY_IS_EXACT 1
#endif
#ifndef DRAWS_BESIDE
#define DRAWS_BESIDE 0
LightChoice draw_light(Surface surface, float beside, inout Random random) { return choose_light(surface, random); }
#endif
#ifndef LEARNS_FROM_LIGHT_SAMPLES
#define LEARNS_FROM_LIGHT_SAMPLES 0
void learn_light(LightChoice choice, uint outcome) {}
#endif
#ifndef STORES_LIGHT_SAMPLES
#define STORES_LIGHT_SAMPLES 0
#endif
#ifndef LIGHTS_FOUND_BY_RAYS
#define LIGHTS_FOUND_BY_RAYS 0
#endif

#endif
