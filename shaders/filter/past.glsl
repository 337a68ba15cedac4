// SPDX-License-Identifier: GPL-2.0-or-later
// What the frames before knew of the surface point that a pixel shows: found by where the point was then, on that frame's pixels around it that
// showed the same surface.
#ifndef VIGIL_FILTER_PAST_GLSL
#define VIGIL_FILTER_PAST_GLSL

#include "filter/filter.glsl"
#include "scene/scene.glsl"

struct Past {
    vec3 direct;
    vec3 indirect;
    vec2 second_moments;
    float frames; // that it is of; 0: nothing is known
};

/// Whether a pixel of the frame before showed the surface at `offset` from that frame's camera; `footprint` is the width of a pixel there.
bool shows_same(uint last_index, ivec2 last_pixel, vec3 offset, vec3 normal, uint id, float footprint) {
    const FilterSurface last = filter_surfaces[last_index];
    if (last.depth == 0.0 || last.id != id) return false;
    if (dot(unpack_normal(last.normal), normal) < 0.9) return false;
    const vec3 there = last.depth * last_pixel_ray(vec2(last_pixel));
    return abs(dot(there - offset, normal)) < 2.0 * footprint;
}

Past find_past(PrimaryHit hit, FilterSurface surface) {
    Past past = Past(vec3(0.0), vec3(0.0), vec2(0.0), 0.0);
    if ((frame.filter_flags & FILTER_HISTORY) == 0u) return past;
    vec3 then = hit.position;
    vec3 normal = hit.normal;
    if (hit.instance != 0u) {
        const Instance instance = instances[hit.instance];
        then = instance.previous_world_from_object * vec4(instance.object_from_world * vec4(hit.position, 1.0), 1.0);
        normal = normalize(mat3(instance.previous_world_from_object) * (mat3(instance.object_from_world) * hit.normal));
    }
    const vec3 offset = then - frame.last_camera_origin;
    vec2 place;
    if (!project_last(offset, place)) return past;
    const vec2 corner = place - frame.last_pixel_point;
    const ivec2 first = ivec2(floor(corner));
    const vec2 within = corner - vec2(first);
    const float footprint = surface.depth * frame.pixel_angle;
    float sum = 0.0;
    for (int i = 0; i < 4; ++i) {
        const ivec2 step = ivec2(i & 1, i >> 1);
        const ivec2 at = first + step;
        const vec2 parts = mix(1.0 - within, within, vec2(step));
        const float weight = parts.x * parts.y;
        if (weight < 1e-3 || !inside_picture(at)) continue;
        const uint index = last_half() + pixel_index(at);
        if (!shows_same(index, at, offset, normal, surface.id, footprint)) continue;
        const FilterHistory last = filter_history[index];
        const vec2 moments = unpackHalf2x16(last.second_moments);
        past.direct += weight * last.direct;
        past.indirect += weight * last.indirect;
        past.second_moments += weight * moments * moments;
        past.frames += weight * unpackHalf2x16(last.lengths).x;
        sum += weight;
    }
    if (sum < 0.05) return Past(vec3(0.0), vec3(0.0), vec2(0.0), 0.0);
    past.direct /= sum;
    past.indirect /= sum;
    past.second_moments = sqrt(past.second_moments / sum);
    past.frames /= sum;
    return past;
}

#endif
