// SPDX-License-Identifier: GPL-2.0-or-later
// What trace_rays.comp reads and writes, for bench/trace_rig.cpp as well: the bindings of its set 1, and the answer to a ray:
// shader::Hit without its bool, which has no place in a buffer.
#ifndef VIGIL_TRACE_RAY_ANSWER_H
#define VIGIL_TRACE_RAY_ANSWER_H

#include "../shared/glsl.h"

#define BINDING_RAYS 0     // Ray[]
#define BINDING_ANSWERS 1  // RayAnswer[], of closest hits
#define BINDING_OCCLUDED 2 // uint[], 1: something was hit
#define RAY_BINDING_COUNT 3

SHADER_BEGIN

struct RayAnswer {
    float t;
    uint primitive; // NONE: nothing was hit
    uint instance;
    uint front;
    vec2 barycentrics;
};

SHADER_END
#endif
