// SPDX-License-Identifier: GPL-2.0-or-later
// What the frames before knew of the surface point that a pixel shows: found by where the point was then, on that frame's pixels around it that
// showed the same surface.
#ifndef VIGIL_FILTER_PAST_GLSL
#define VIGIL_FILTER_PAST_GLSL

#include "filter/motion.glsl"

struct Past {
    vec3 direct;
    vec3 indirect;
    vec2 second_moments; // means of squared luminances, direct and indirect
    vec2 frames;         // that the means are of; 0: nothing is known
};

const Past NO_PAST = Past(vec3(0.0), vec3(0.0), vec2(0.0), vec2(0.0));

/// A surface point in the frame before.
struct Then {
    vec3 offset; // from that frame's camera
    vec3 normal;
    uint id;
    float tolerance; // map units that another point of the surface may be off its plane
};

bool shows_same(uint index, ivec2 pixel, Then then) {
    const FilterSurface last = filter_surfaces[index];
    if (last.depth == 0.0 || last.id != then.id || dot(unpack_normal(last.normal), then.normal) < 0.9) return false;
    const vec3 ray =
        ray_through(vec2(pixel) + frame.last_pixel_point, frame.last_camera_forward, frame.last_camera_right, frame.last_camera_up);
    return abs(dot(last.depth * ray - then.offset, then.normal)) < then.tolerance;
}

void add_past(inout Past past, uint index, float weight) {
    const FilterHistory last = filter_history[index];
    const vec2 moments = unpackHalf2x16(last.second_moments);
    past.direct += weight * last.direct;
    past.indirect += weight * last.indirect;
    past.second_moments += weight * moments * moments;
    past.frames += weight * unpackHalf2x16(last.lengths);
}

Past find_past(PrimaryHit hit, FilterSurface surface) {
    Past past = NO_PAST;
    if ((frame.filter_flags & FILTER_HISTORY) == 0u) return past;
    const Then then = Then(offset_before(hit.position, hit.instance), normal_before(hit.normal, hit.instance), surface.id,
                           2.0 * surface.depth * frame.pixel_angle);
    vec2 place;
    if (!project_last(then.offset, place)) return past;
    const vec2 corner = place - frame.last_pixel_point;
    const ivec2 first = ivec2(floor(corner));
    const vec2 within = corner - vec2(first);
    float sum = 0.0;
    for (int i = 0; i < 4; ++i) {
        const ivec2 at = first + ivec2(i & 1, i >> 1);
        const vec2 parts = mix(1.0 - within, within, vec2(i & 1, i >> 1));
        const float weight = parts.x * parts.y;
        if (weight < 1e-3 || !inside_picture(at)) continue;
        const uint index = last_half() + pixel_index(at);
        if (!shows_same(index, at, then)) continue;
        add_past(past, index, weight);
        sum += weight;
    }
    // Edges and thin things: whichever pixel around showed the surface.
    if (sum < 0.05) {
        past = NO_PAST;
        sum = 0.0;
        const ivec2 nearest = ivec2(floor(corner + 0.5));
        for (int i = 0; i < 9; ++i) {
            const ivec2 at = nearest + ivec2(i % 3 - 1, i / 3 - 1);
            if (!inside_picture(at)) continue;
            const uint index = last_half() + pixel_index(at);
            if (!shows_same(index, at, then)) continue;
            add_past(past, index, 1.0);
            sum += 1.0;
        }
        if (sum == 0.0) return NO_PAST;
    }
    past.direct /= sum;
    past.indirect /= sum;
    past.second_moments /= sum;
    past.frames /= sum;
    return past;
}

#endif
