// SPDX-License-Identifier: GPL-2.0-or-later
// Views of what the path tracer knows (pt_view), as colours for the display. They read the primary hits of the frame, and
// the octree and light caches that it used. Legends are drawn by the host (refresh/vkpt/debug/legend.h).
#ifndef VIGIL_DEBUG_VIEW_GLSL
#define VIGIL_DEBUG_VIEW_GLSL

#include "debug/directions_view.glsl"
#include "debug/octree_view.glsl"
#include "shared/views.h"

/// A colour per number, bright enough to tell neighbours apart.
vec3 number_color(uint number) {
    const uvec3 words = hash_pcg3d(uvec3(number, 17u, 4711u));
    return 0.25 + 0.75 * vec3(unit_float(words.x), unit_float(words.y), unit_float(words.z));
}

/// A count on its logarithmic scale. Shading is faint: lightness says how many.
vec3 count_color(uint count, float most, float facing) {
    if (count == 0u) return VIEW_EMPTY;
    return (0.8 + 0.2 * facing) * color_map(count_on_scale(float(count), most));
}

vec3 octree_color(Surface surface, float facing) {
    const OctreeCell cell = find_cell(surface.position);
    const float width = frame.pixel_angle * distance(frame.camera_origin, surface.position) / max(sqrt(facing), 0.3);
    const float line = on_cell_border(cell, surface.position, surface.normal, width) ? 0.35 : 1.0;
    return line * (0.5 + 0.5 * facing) * cell_color(cell);
}

vec3 technique_color(uint flags) {
    if (samples_lights == 0u) return VIEW_OFF;
    const bool zero = (flags & PIXEL_UNLIT) != 0u;
    if ((flags & PIXEL_EXPLORED) != 0u) return zero ? VIEW_EXPLORED_ZERO : VIEW_EXPLORED;
    return zero ? VIEW_CACHE_ZERO : VIEW_CACHE;
}

vec3 zero_color(uint flags, float facing) {
    if (samples_lights == 0u) return VIEW_OFF;
    if ((flags & PIXEL_UNLIT) != 0u) return VIEW_ZERO_SAMPLE;
    return (0.5 + 0.5 * facing) * VIEW_LIT_SAMPLE;
}

/// Views of the octree and its caches, which exist only where guiding is on.
vec3 guiding_color(int view, Surface surface, float facing) {
    if (guided == 0u) return VIEW_OFF;
    switch (view) {
    case VIEW_OCTREE: return octree_color(surface, facing);
    case VIEW_SAMPLES: return count_color(sample_count(surface), view_most_samples(frame.size), facing);
    case VIEW_VLC_LIGHTS: return count_color(cached_light_count(surface), VIEW_MOST_LIGHTS, facing);
    default: return count_color(bucket_count(surface), VIEW_MOST_BUCKETS, facing);
    }
}

/// Colour of a pixel, sRGB. `picture` is what it would be without a view.
vec3 view_color(uvec2 pixel, vec3 picture) {
    const PrimaryHit hit = load_primary_hit(pixel.y * frame.size.x + pixel.x);
    const uint flags = pixel_flags[pixel.y * frame.size.x + pixel.x];
    const int view = frame.settings.pt_view;
    if (view == VIEW_NONFINITE) return (flags & PIXEL_NONFINITE) != 0u ? VIEW_BAD : VIEW_GOOD;
    const Surface surface = load_primary_surface(hit);
    if (view == VIEW_CDQ) {
        const PrimaryHit middle = crosshair_hit();
        return directions_color(pixel, picture, load_primary_surface(middle), middle.primitive != NONE, surface, hit.primitive != NONE);
    }
    if (hit.primitive == NONE) return vec3(0.0);
    const float facing = abs(dot(hit.normal, normalize(frame.camera_origin - hit.position)));
    switch (view) {
    case VIEW_OCTREE:
    case VIEW_SAMPLES:
    case VIEW_VLC_LIGHTS:
    case VIEW_VLC_BUCKETS: return guiding_color(view, surface, facing);
    case VIEW_TECHNIQUE: return technique_color(flags);
    case VIEW_ZERO: return zero_color(flags, facing);
    case VIEW_ALBEDO: return pow(hit.albedo, vec3(1.0 / 2.2));
    case VIEW_NORMAL: return 0.5 + 0.5 * hit.normal;
    case VIEW_DEPTH: return vec3(view_depth_grey(distance(frame.camera_origin, hit.position)));
    case VIEW_CLUSTER: {
        const uint cluster = surface_cluster(surface);
        return (0.4 + 0.6 * facing) * (cluster == NONE ? VIEW_NO_CLUSTER : number_color(cluster));
    }
    case VIEW_TRIANGLE: return (0.4 + 0.6 * facing) * number_color(hit.primitive);
    case VIEW_LIGHT: {
        const uint light = load_primitive(hit.primitive).light;
        if (light == NONE) return facing * VIEW_NO_LIGHT;
        return number_color((HAS_INSTANCES ? load_instance(hit.instance).first_light : 0u) + light);
    }
    default: return vec3(0.0);
    }
}

#endif
