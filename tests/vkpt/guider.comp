#version 460
// SPDX-License-Identifier: GPL-2.0-or-later
// Calls the functions of a guider on the host's arguments, for guider_test.cpp, with what leaves of the octree have learned.
// Compiled once per guider. What `path_index` selects:
//   0 guide_sample      in: u, leaf            out: direction, density
//   1 guide_pdf         in: direction, leaf    out: density
#extension GL_GOOGLE_include_directive : require
#include "shared/extensions.glsl"
#include "pathtrace/path.glsl"
#include "guiding/octree.glsl"
#include "guiding/guider.glsl"

layout(set = 3, binding = 0, scalar) restrict readonly buffer ArgumentBlock { vec4 arguments[]; };
layout(set = 3, binding = 1, scalar) restrict writeonly buffer ResultBlock { vec4 results[]; };

void main() {
    const uint index = gl_WorkGroupID.x * 64u + gl_LocalInvocationIndex;
    if (index >= path_count) return;
    const vec4 given = arguments[index];
    const Guide guide = guide_prepare(load_guide(octree_node_of(uint(given.w))));
    if (path_index == 0u) {
        float pdf;
        const vec3 direction = guide_sample(guide, given.xyz, pdf);
        results[index] = vec4(direction, pdf);
    } else {
        results[index] = vec4(guide_pdf(guide, given.xyz));
    }
}
