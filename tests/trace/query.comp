#version 460
// SPDX-License-Identifier: GPL-2.0-or-later
// Answers a list of rays through the interface that the path tracer uses; compiled once per
// backend.
#extension GL_GOOGLE_include_directive : require
#include "shared/extensions.glsl"
#include "trace/trace.glsl"
#include "query_answer.h"

layout(local_size_x = 64) in;

layout(set = SET_TECHNIQUE, binding = 0, scalar) restrict readonly buffer Rays { Ray rays[]; };
layout(set = SET_TECHNIQUE, binding = 1, scalar) restrict writeonly buffer Answers { TraceAnswer answers[]; };
layout(push_constant) uniform Push { uint ray_count; };

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= ray_count) return;
    Hit hit;
    bool found = trace_closest(rays[index], index, hit);
    TraceAnswer answer;
    answer.t = hit.t;
    answer.primitive = found ? hit.primitive : NONE;
    answer.instance = hit.instance;
    answer.front = hit.front ? 1u : 0u;
    answer.barycentrics = hit.barycentrics;
    answer.occluded = trace_occluded(rays[index], index) ? 1u : 0u;
    answers[index] = answer;
}
