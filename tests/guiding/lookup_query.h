// SPDX-License-Identifier: GPL-2.0-or-later
// What lookup.comp is asked; the same text is C++ and GLSL. No answers: those are two leaves each.
#ifndef VIGIL_TESTS_LOOKUP_QUERY_H
#define VIGIL_TESTS_LOOKUP_QUERY_H

#include "shared/glsl.h"

SHADER_BEGIN

/// A surface and what happened to its light sample.
struct LookupQuery {
    vec3 position;
    uint instance; // 0 does not move
    uint light;
    uint visible; // 1: it was seen
};

SHADER_END
#endif
