// SPDX-License-Identifier: GPL-2.0-or-later
// Radiance of the sky box and the sun's disc.
#ifndef VIGIL_PATHTRACE_SKY_GLSL
#define VIGIL_PATHTRACE_SKY_GLSL

#include "scene/scene.glsl"
#include "shared/sampling.h"

/// Side (0..5 in the order rt bk lf ft up dn) and picture coordinates of a direction: the inverse of formats/sky.h.
void sky_coordinates(vec3 direction, out uint side, out vec2 uv) {
    const vec3 size = abs(direction);
    vec2 plane; // right, up
    float depth;
    if (size.x >= size.y && size.x >= size.z) {
        side = direction.x > 0.0 ? 0u : 2u;
        plane = vec2(direction.x > 0.0 ? -direction.y : direction.y, direction.z);
        depth = size.x;
    } else if (size.y >= size.z) {
        side = direction.y > 0.0 ? 1u : 3u;
        plane = vec2(direction.y > 0.0 ? direction.x : -direction.x, direction.z);
        depth = size.y;
    } else {
        side = direction.z > 0.0 ? 4u : 5u;
        plane = vec2(-direction.y, direction.z > 0.0 ? -direction.x : direction.x);
        depth = size.z;
    }
    plane /= depth;
    uv = vec2(0.5 + 0.5 * plane.x, 0.5 - 0.5 * plane.y);
}

vec3 sky_texel(Texture header, vec2 uv) {
    const vec2 size = vec2(header.width, header.height);
    const vec2 place = clamp(uv * size - 0.5, vec2(0.0), size - 1.0);
    const ivec2 low = ivec2(place);
    const ivec2 high = min(low + 1, ivec2(size) - 1);
    const vec2 weight = place - vec2(low);
    return mix(mix(fetch_texel(header, 0u, low), fetch_texel(header, 0u, ivec2(high.x, low.y)), weight.x),
               mix(fetch_texel(header, 0u, ivec2(low.x, high.y)), fetch_texel(header, 0u, high), weight.x), weight.y);
}

/// Radiance of the sky box from a unit direction.
vec3 sky_box_radiance(vec3 direction) {
    vec3 value = frame.sky_radiance;
    if (frame.sky_texture != NONE) {
        uint side;
        vec2 uv;
        sky_coordinates(frame.sky_from_world * direction, side, uv);
        value *= sky_texel(load_texture(frame.sky_texture + side), uv);
    }
    return value;
}

bool meets_sun(vec3 direction) { return in_cone(direction, frame.sun_direction, frame.sun_size); }

/// Radiance of both.
vec3 sky_radiance(vec3 direction) {
    if (!HAS_SKY) return vec3(0.0);
    return sky_box_radiance(direction) + (meets_sun(direction) ? frame.sun_radiance : vec3(0.0));
}

#endif
