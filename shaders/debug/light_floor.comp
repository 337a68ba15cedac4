#version 460
// SPDX-License-Identifier: GPL-2.0-or-later
// What each light's own estimator is worth where the camera looks: its mean, and the root of its second moment, shadow ray included. A
// choice of lights in proportion to these roots has the least variance that any choice can have, for this way of drawing points on a light
// (importance sampling's optimum, for a sum of estimators); src/bench/light_floor.cpp adds them up. Not a pass of the frame.
// One invocation per light of the hit's cluster (along x) and pixel (along y); path_index is the number of the first pixel, path_count
// the samples of each light, an even number. Compiled for `sll`, whose lists it reads.
#extension GL_GOOGLE_include_directive : require
#include "shared/extensions.glsl"
#include "pathtrace/path.glsl"
#include "pathtrace/next_event.glsl"
#include "shared/light_floor.h"

layout(set = 3, binding = 0, scalar) restrict readonly buffer PixelBlock { uint pixels[]; };
layout(set = 3, binding = 1, scalar) restrict writeonly buffer ValueBlock { LightFloorValue values[]; };

// A seed apart from those of frames.
const uint FLOOR_SEED = 0x464c4f4fu;

float mean_square(vec3 value) { return dot(value, value) / 3.0; }

void main() {
    const uint number = path_index + gl_GlobalInvocationID.y;
    const uint place = gl_GlobalInvocationID.x;
    const uint row = gl_NumWorkGroups.x * gl_WorkGroupSize.x;
    if (number >= pixels.length()) return;
    const uint index = pixels[number];
    const PrimaryHit hit = load_primary_hit(index);
    LightFloorValue value = LightFloorValue(0.0, 0.0, 0.0, vec3(0.0), vec3(0.0));
    if (hit.primitive != NONE) {
        const Surface surface = load_primary_surface(hit);
        const LightList list = find_light_list(surface);
        if (place < list.count) {
            const LightChoice choice = weighted_choice(light_of_list(list, place), 1.0);
            Random random = random_begin(uvec2(index, place), uint(frame.settings.pt_seed), FLOOR_SEED);
            const uint samples = path_count / 2u;
            vec2 squares = vec2(0.0);
            for (uint i = 0u; i < 2u * samples; ++i) {
                const vec3 u = random_next3(random);
                const uint seed = random_next_words(random).x;
                uint outcome;
                const vec3 radiance = sampled_radiance(surface, choice, u, seed, false, outcome);
                if ((i & 1u) == 0u) {
                    value.even_mean += radiance / float(samples);
                    squares.x += mean_square(radiance) / float(samples);
                } else {
                    value.odd_mean += radiance / float(samples);
                    squares.y += mean_square(radiance) / float(samples);
                }
            }
            value.root = sqrt(0.5 * (squares.x + squares.y));
            value.even_root = sqrt(squares.x);
            value.odd_root = sqrt(squares.y);
        }
    }
    values[gl_GlobalInvocationID.y * row + place] = value;
}
