#version 460
// SPDX-License-Identifier: GPL-2.0-or-later
// Calls single functions of the path tracer on the host's arguments, for agreement_test.cpp. What `path_index` selects:
//   0 sky_coordinates   in: direction                  out: side, u, v
//   1 sample_texture    in: header, u, v, footprint    out: colour
//   2 fetch_texel       in: header, level, x, y        out: colour
//   3 surface_cluster   in: pixel index                out: cluster as bits
//   4 sky_radiance      in: direction                  out: radiance
#extension GL_GOOGLE_include_directive : require
#include "shared/extensions.glsl"
#include "pathtrace/path.glsl"
#include "pathtrace/sky.glsl"

layout(set = 3, binding = 0, scalar) restrict readonly buffer ArgumentBlock { vec4 arguments[]; };
layout(set = 3, binding = 1, scalar) restrict writeonly buffer ResultBlock { vec4 results[]; };

void main() {
    const uint index = gl_WorkGroupID.x * 64u + gl_LocalInvocationIndex;
    if (index >= path_count) return;
    const vec4 given = arguments[index];
    vec4 result = vec4(0.0);
    switch (path_index) {
    case 0u: {
        uint side;
        vec2 uv;
        sky_coordinates(given.xyz, side, uv);
        result = vec4(float(side), uv, 0.0);
        break;
    }
    case 1u: result.xyz = sample_texture(load_texture(uint(given.x)), given.yz, given.w); break;
    case 2u: result.xyz = fetch_texel(load_texture(uint(given.x)), uint(given.y), ivec2(given.zw)); break;
    case 3u: result.x = uintBitsToFloat(surface_cluster(load_primary_surface(load_primary_hit(uint(given.x))))); break;
    case 4u: result.xyz = sky_radiance(given.xyz); break;
    }
    results[index] = result;
}
