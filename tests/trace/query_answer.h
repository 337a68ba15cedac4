// SPDX-License-Identifier: GPL-2.0-or-later
// What query.comp answers for a ray; compiled by both sides. The bool of shader::Hit has no place
// in a buffer.
#ifndef VIGIL_TESTS_QUERY_ANSWER_H
#define VIGIL_TESTS_QUERY_ANSWER_H

#include "shared/glsl.h"

SHADER_BEGIN

struct TraceAnswer {
    float t;
    uint primitive; // NONE: nothing was hit
    uint instance;
    uint front;
    vec2 barycentrics;
    uint occluded;
};

SHADER_END
#endif
