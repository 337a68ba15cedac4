// SPDX-License-Identifier: GPL-2.0-or-later
// What trace_rays.comp writes for a ray: shader::Hit without its bool, which has no place in a
// buffer.
#ifndef VIGIL_TRACE_RAY_ANSWER_H
#define VIGIL_TRACE_RAY_ANSWER_H

#include "../shared/glsl.h"

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
