#version 460
// SPDX-License-Identifier: GPL-2.0-or-later
// Asks guiding/octree.glsl, as the path tracer does, for the leaves of surfaces, and stores one light
// sample for each. Answers are the leaf of the cache and the leaf of the sample; there are as many as
// paths (scene/frame.glsl).
#extension GL_GOOGLE_include_directive : require
#include "shared/extensions.glsl"
#include "guiding/octree.glsl"
#include "scene/surface.glsl"
#include "lookup_query.h"

layout(local_size_x = 64) in;

layout(set = 1, binding = 0, scalar) restrict readonly buffer QueryBlock { LookupQuery queries[]; };
layout(set = 1, binding = 1, scalar) restrict writeonly buffer AnswerBlock { uvec2 answers[]; };

void main() {
    const uint index = gl_GlobalInvocationID.x;
    if (index >= path_count) return;
    const LookupQuery query = queries[index];
    Surface surface;
    surface.position = query.position;
    surface.instance = query.instance;
    const SurfaceLeaves found = find_leaves(surface.position, previous_position(surface));
    store_light_sample(found.samples, query.light | (query.visible != 0u ? LIGHT_SAMPLE_VISIBLE : 0u));
    answers[index] = uvec2(found.cache, found.samples);
}
