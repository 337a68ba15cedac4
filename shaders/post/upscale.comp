#version 460
// SPDX-License-Identifier: GPL-2.0-or-later
// Pass `upscale`: a picture of more pixels than were traced. Each pixel is a mean of twelve traced ones around it, by a kernel of Lanczos's shape that is
// drawn out along edges, so that these stay straight (an idea of Lottes, "FidelityFX Super Resolution 1.0", 2021; the formulas are others). Values stay within the four
// nearest, so that nothing rings. Colours are as displayed, sRGB.
#extension GL_GOOGLE_include_directive : require
#include "shared/extensions.glsl"
#include "shared/bindings.h"
#include "shared/brdf.h"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = BINDING_UPSCALE_TRACED, scalar) restrict readonly buffer TracedBlock { uint traced[]; };
layout(set = 0, binding = BINDING_UPSCALE_DISPLAY, scalar) restrict writeonly buffer DisplayBlock { uint display[]; };

layout(push_constant, scalar) uniform PushBlock {
    uvec2 traced_size;
    uvec2 size;
};

vec3 color_at(ivec2 pixel) {
    const ivec2 inside = clamp(pixel, ivec2(0), ivec2(traced_size) - 1);
    return unpackUnorm4x8(traced[uint(inside.y) * traced_size.x + uint(inside.x)]).rgb;
}

/// Like Lanczos's kernel with two lobes, by the squared distance: 0 at 1 and from 2 on.
float lobes(float square) {
    const float window = max(1.0 - 0.25 * square, 0.0);
    const float window2 = window * window;
    return (1.0 - square) * window2 * window2;
}

void main() {
    const uvec2 pixel = gl_GlobalInvocationID.xy;
    if (any(greaterThanEqual(pixel, size))) return;
    if (traced_size == size) {
        display[pixel.y * size.x + pixel.x] = traced[pixel.y * size.x + pixel.x];
        return;
    }
    const vec2 place = (vec2(pixel) + 0.5) * vec2(traced_size) / vec2(size) - 0.5;
    const ivec2 first = ivec2(floor(place));
    const vec2 within = place - vec2(first);

    // The twelve: four in the middle, two on each side.
    vec3 colors[12];
    float brights[12];
    const ivec2 taps[12] = ivec2[12](ivec2(0, 0), ivec2(1, 0), ivec2(0, 1), ivec2(1, 1), ivec2(0, -1), ivec2(1, -1), ivec2(-1, 0),
                                     ivec2(2, 0), ivec2(-1, 1), ivec2(2, 1), ivec2(0, 2), ivec2(1, 2));
    for (int i = 0; i < 12; ++i) {
        colors[i] = color_at(first + taps[i]);
        brights[i] = luminance(colors[i]);
    }
    // How brightness rises at the four, each by its neighbours left, right, above and below, and what of it is an edge.
    const vec4 rise_x = vec4(brights[1] - brights[6], brights[7] - brights[0], brights[3] - brights[8], brights[9] - brights[2]);
    const vec4 rise_y = vec4(brights[2] - brights[4], brights[3] - brights[5], brights[10] - brights[0], brights[11] - brights[1]);
    const vec2 rest = 1.0 - within;
    const vec4 parts = vec4(rest.x * rest.y, within.x * rest.y, rest.x * within.y, within.x * within.y);
    const vec2 rise = vec2(dot(rise_x, parts), dot(rise_y, parts));
    const float steepness = length(rise), all_rises = dot(sqrt(rise_x * rise_x + rise_y * rise_y), parts);
    // 1 where all four rise the same way, and by more than nothing.
    const float straight = steepness / max(all_rises, 1e-4) * smoothstep(0.02, 0.1, steepness);
    const vec2 across = steepness > 1e-4 ? rise / steepness : vec2(1.0, 0.0);
    const float along_scale = mix(1.0, 0.55, straight);

    vec3 sum = vec3(0.0), least = vec3(1.0), most = vec3(0.0);
    float weights = 0.0;
    for (int i = 0; i < 12; ++i) {
        const vec2 offset = vec2(taps[i]) - within;
        const vec2 turned = vec2(dot(offset, across), along_scale * dot(offset, vec2(-across.y, across.x)));
        const float weight = lobes(dot(turned, turned));
        sum += weight * colors[i];
        weights += weight;
        if (i >= 4) continue;
        least = min(least, colors[i]);
        most = max(most, colors[i]);
    }
    display[pixel.y * size.x + pixel.x] = packUnorm4x8(vec4(clamp(sum / weights, least, most), 1.0));
}
