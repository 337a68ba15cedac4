// SPDX-License-Identifier: GPL-2.0-or-later
// The ray-tracing interface: trace_camera, trace_closest and trace_occluded, the only names other
// shaders use. Compiled with TRACE_QUERY=1 the backend is VK_KHR_ray_query, else the compute hierarchy. It
// declares what it reads (nodes, triangles, top level or acceleration structure), and nothing about
// materials.
#ifndef VIGIL_TRACE_GLSL
#define VIGIL_TRACE_GLSL

#include "../shared/bindings.h"
#include "../shared/bvh.h"
#include "records.glsl"

/// False: the scene is instance 0 alone, in place; the top level is neither bound nor walked.
layout(constant_id = CONSTANT_INSTANCES) const bool HAS_INSTANCES = true;
/// False: every triangle is opaque and no coverage test is compiled.
layout(constant_id = CONSTANT_TRANSLUCENT) const bool HAS_TRANSLUCENT = true;
/// False: every instance is opaque and met by all rays.
layout(constant_id = CONSTANT_EFFECTS) const bool HAS_EFFECTS = true;

layout(set = SET_SCENE, binding = BINDING_BVH_TRIANGLES) uniform utextureBuffer bvh_triangles; // BvhTriangle[]

BvhTriangle bvh_load_triangle(uint index) {
    const int at = int(index) * TRIANGLE_TEXELS;
    const uvec4 a = texelFetch(bvh_triangles, at);
    const vec4 b = load_floats(bvh_triangles, at + 1), c = load_floats(bvh_triangles, at + 2);
    return BvhTriangle(uintBitsToFloat(a.xyz), a.w, b.xyz, vec3(b.w, c.xy));
}

#if TRACE_QUERY
#include "trace_query.glsl"
#else
#include "trace_bvh.glsl"
#endif

/// Closest hit in (ray.t_min, ray.t_max). Opaque triangles stop rays from both sides; translucent
/// ones only from their front, with probability coverage / 255 decided by a hash of (seed,
/// instance, primitive).
bool trace_closest(Ray ray, uint seed, out Hit hit) { return trace_backend(ray, seed, INSTANCE_LIT, false, hit); }

/// The same for a camera ray, of what has a flag of `mask`: INSTANCE_SEEN or INSTANCE_FRONT.
bool trace_camera(Ray ray, uint seed, uint mask, out Hit hit) { return trace_backend(ray, seed, mask, false, hit); }

/// True if anything stops the ray in (ray.t_min, ray.t_max).
bool trace_occluded(Ray ray, uint seed) {
    Hit hit;
    return trace_backend(ray, seed, INSTANCE_LIT, true, hit);
}

#endif
