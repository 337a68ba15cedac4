// SPDX-License-Identifier: GPL-2.0-or-later
// Views of what the path tracer knows (pt_view), as colours for the display. They read the primary hits of the frame.
#ifndef VIGIL_DEBUG_VIEW_GLSL
#define VIGIL_DEBUG_VIEW_GLSL

#include "pathtrace/surface.glsl"
#include "shared/random.h"

// In the order of pt_view in shared/cvar_table.h.
const int VIEW_NONE = 0;
const int VIEW_ALBEDO = 1;
const int VIEW_NORMAL = 2;
const int VIEW_DEPTH = 3;
const int VIEW_CLUSTER = 4;
const int VIEW_TRIANGLE = 5;
const int VIEW_LIGHT = 6;
const int VIEW_NONFINITE = 7;

/// A colour per number, bright enough to tell neighbours apart.
vec3 number_color(uint number) {
    const uvec3 words = hash_pcg3d(uvec3(number, 17u, 4711u));
    return 0.25 + 0.75 * vec3(unit_float(words.x), unit_float(words.y), unit_float(words.z));
}

vec3 view_color(uint index) {
    const PrimaryHit hit = primary_hits[index];
    if (frame.cvars.pt_view == VIEW_NONFINITE)
        return (hit.flags & PRIMARY_HIT_NONFINITE) != 0u ? vec3(1.0, 0.0, 1.0) : vec3(0.05);
    if (hit.primitive == NONE) return vec3(0.0);
    Surface surface;
    surface.position = hit.position;
    surface.origin = hit.position;
    surface.normal = hit.normal;
    surface.primitive = hit.primitive;
    surface.instance = hit.instance;
    const float facing = abs(dot(hit.normal, normalize(frame.camera_origin - hit.position)));
    switch (frame.cvars.pt_view) {
    case VIEW_ALBEDO: return pow(hit.albedo, vec3(1.0 / 2.2));
    case VIEW_NORMAL: return 0.5 + 0.5 * hit.normal;
    case VIEW_DEPTH: return vec3(1.0 / (1.0 + distance(frame.camera_origin, hit.position) / 256.0));
    case VIEW_CLUSTER: {
        const uint cluster = surface_cluster(surface);
        return (0.4 + 0.6 * facing) * (cluster == NONE ? vec3(1.0, 0.0, 0.0) : number_color(cluster));
    }
    case VIEW_TRIANGLE: return (0.4 + 0.6 * facing) * number_color(hit.primitive);
    case VIEW_LIGHT: {
        const uint light = primitives[hit.primitive].light;
        if (light == NONE) return vec3(0.15 * facing);
        return number_color((HAS_INSTANCES ? instances[hit.instance].first_light : 0u) + light);
    }
    default: return vec3(0.0);
    }
}

#endif
