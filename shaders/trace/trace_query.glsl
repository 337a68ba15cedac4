// SPDX-License-Identifier: GPL-2.0-or-later
// The backend of devices that trace rays themselves: VK_KHR_ray_query over the structures of
// scene/acceleration_structure.h. What stops a ray is the same as in trace_bvh.glsl, down to the
// coverage hash; hits differ by the rounding of the device's own triangle test, and where two
// triangles meet either may win. Include trace.glsl, not this.
#ifndef VIGIL_TRACE_QUERY_GLSL
#define VIGIL_TRACE_QUERY_GLSL

#extension GL_EXT_ray_query : require

layout(set = SET_SCENE, binding = BINDING_ACCELERATION_STRUCTURE) uniform accelerationStructureEXT top_structure;

// How the structures are numbered: the n-th instance of the top level is Instance[n], its custom
// index is its model's first triangle, and a model's triangles keep their order in all geometries.
// Its binding table offset, which queries do not need, is its opacity.
// A side is the front when the triangle faces the ray in object space, so mirroring transforms
// change nothing, as in the compute backend.
bool trace_backend(Ray ray, uint seed, uint mask, bool any_hit, out Hit hit) {
    hit = Hit(ray.t_max, NONE, NONE, vec2(0.0), false);
    // Queries with an empty interval are invalid.
    if (!(ray.t_min < ray.t_max)) return false;
    uint flags = any_hit ? gl_RayFlagsTerminateOnFirstHitEXT : gl_RayFlagsNoneEXT;
    if (!HAS_TRANSLUCENT) flags |= gl_RayFlagsOpaqueEXT;
    rayQueryEXT query;
    rayQueryInitializeEXT(query, top_structure, flags, mask, ray.origin, ray.t_min, ray.direction, ray.t_max);
    // Only translucent triangles come up here; the device settles opaque ones alone.
    while (rayQueryProceedEXT(query)) {
        if (!HAS_TRANSLUCENT) continue;
        uint primitive =
            rayQueryGetIntersectionInstanceCustomIndexEXT(query, false) + rayQueryGetIntersectionPrimitiveIndexEXT(query, false);
        bool front = rayQueryGetIntersectionFrontFaceEXT(query, false);
        uint instance = rayQueryGetIntersectionInstanceIdEXT(query, false);
        uint coverage = bvh_load_triangle(primitive).flags;
        if (HAS_EFFECTS) coverage = bvh_faded(coverage, rayQueryGetIntersectionInstanceShaderBindingTableRecordOffsetEXT(query, false));
        if (bvh_covered(coverage, front, seed, instance, primitive)) rayQueryConfirmIntersectionEXT(query);
    }
    if (rayQueryGetIntersectionTypeEXT(query, true) == gl_RayQueryCommittedIntersectionNoneEXT) return false;
    hit.t = rayQueryGetIntersectionTEXT(query, true);
    hit.primitive = rayQueryGetIntersectionInstanceCustomIndexEXT(query, true) + rayQueryGetIntersectionPrimitiveIndexEXT(query, true);
    hit.instance = rayQueryGetIntersectionInstanceIdEXT(query, true);
    hit.barycentrics = rayQueryGetIntersectionBarycentricsEXT(query, true);
    hit.front = rayQueryGetIntersectionFrontFaceEXT(query, true);
    return true;
}

#endif
