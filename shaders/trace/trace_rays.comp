#version 460
// SPDX-License-Identifier: GPL-2.0-or-later
// Answers a list of rays: the tracing functions alone, for tests and the trace benchmark. Compiled per
// backend like the path tracer's passes; it samples and shades nothing.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require

#include "trace/trace.glsl"
#include "trace/ray_answer.h"

layout(local_size_x = 64) in;

/// False: the closest hit of each ray. True: only whether anything stops it.
layout(constant_id = CONSTANT_ANY_HIT) const bool ANY_HIT = false;

layout(set = SET_TECHNIQUE, binding = BINDING_RAYS, scalar) restrict readonly buffer Rays { Ray rays[]; };
layout(set = SET_TECHNIQUE, binding = BINDING_ANSWERS, scalar) restrict writeonly buffer Answers { RayAnswer answers[]; };
layout(set = SET_TECHNIQUE, binding = BINDING_OCCLUDED, scalar) restrict writeonly buffer Occluded { uint occluded[]; };
layout(push_constant) uniform Push { uint ray_count; };

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= ray_count) return;
    if (ANY_HIT) {
        occluded[index] = trace_occluded(rays[index], index) ? 1u : 0u;
        return;
    }
    Hit hit;
    trace_closest(rays[index], index, hit);
    answers[index] = RayAnswer(hit.t, hit.primitive, hit.instance, hit.front ? 1u : 0u, hit.barycentrics);
}
