#version 460
// SPDX-License-Identifier: GPL-2.0-or-later
// Pass `filter_temporal`: joins a frame's light with what the frames before saw of the same surface point (Schied et al., "Spatiotemporal
// Variance-Guided Filtering", 2017, sections 4.1 and 4.2), after samples far brighter than their surroundings were dimmed.
#extension GL_GOOGLE_include_directive : require
#include "shared/extensions.glsl"
#include "filter/filter.glsl"
#include "filter/past.glsl"

/// What the neighbours' samples of this frame say about a pixel without a past.
struct Neighbourhood {
    vec2 brightest;      // luminances, direct and indirect, without the pixel itself
    vec2 mean;           // with it
    vec2 second_moments; // square roots of mean squares, with it
};

const int NEIGHBOURS = 2; // in each direction

Neighbourhood look_around(ivec2 pixel, PrimaryHit hit) {
    Neighbourhood seen = Neighbourhood(vec2(0.0), vec2(0.0), vec2(0.0));
    float count = 0.0;
    for (int y = -NEIGHBOURS; y <= NEIGHBOURS; ++y)
        for (int x = -NEIGHBOURS; x <= NEIGHBOURS; ++x) {
            const ivec2 at = pixel + ivec2(x, y);
            if (!inside_picture(at)) continue;
            const uint index = pixel_index(at);
            if (primary_hits[index].primitive == NONE || dot(primary_hits[index].normal, hit.normal) < 0.8) continue;
            const vec2 bright = min(luminances(filter_input[index].direct, filter_input[index].indirect) / float(path_count), vec2(FILTER_MAX));
            if (x != 0 || y != 0) seen.brightest = max(seen.brightest, bright);
            seen.mean += bright;
            seen.second_moments += bright * bright;
            count += 1.0;
        }
    seen.mean /= count;
    seen.second_moments = sqrt(seen.second_moments / count);
    return seen;
}

vec3 dim(vec3 light, float limit) {
    const float bright = luminance(light);
    return bright > limit ? light * (limit / bright) : light;
}

void main() {
    const uvec2 pixel = gl_GlobalInvocationID.xy;
    if (any(greaterThanEqual(pixel, frame.size))) return;
    const uint index = pixel.y * frame.size.x + pixel.x;
    const PrimaryHit hit = primary_hits[index];
    FilterSurface surface = FilterSurface(0u, 0.0, 0u);
    if (hit.primitive == NONE) {
        filter_surfaces[this_half() + index] = surface;
        filter_light[index] = uvec4(0u);
        return;
    }
    surface.normal = pack_normal(hit.normal);
    surface.depth = dot(hit.position - frame.camera_origin, frame.camera_forward);
    surface.id = hit.instance;
    filter_surfaces[this_half() + index] = surface;

    const Past past = find_past(hit, surface);
    vec3 direct = filter_input[index].direct / float(path_count);
    vec3 indirect = filter_input[index].indirect / float(path_count);

    // Dim what is far brighter than is known of the place.
    const bool young = past.frames < 4.0;
    vec2 limits;
    Neighbourhood around;
    if (young) around = look_around(ivec2(pixel), hit);
    const float fireflies = frame.settings.flt_firefly;
    if (fireflies > 0.0) {
        const vec2 mean = luminances(past.direct, past.indirect);
        const vec2 deviation = sqrt(max(past.second_moments * past.second_moments - mean * mean, vec2(0.0)));
        if (young) limits = around.brightest;
        else limits = mean + fireflies * deviation;
        direct = dim(direct, limits.x);
        indirect = dim(indirect, limits.y);
    }

    // Join both.
    const float length = min(past.frames + 1.0, float(frame.settings.flt_history));
    const float part = 1.0 / length;
    FilterHistory joined;
    joined.direct = mix(past.direct, min(direct, vec3(FILTER_MAX)), part);
    joined.indirect = mix(past.indirect, min(indirect, vec3(FILTER_MAX)), part);
    const vec2 bright = min(luminances(direct, indirect), vec2(FILTER_MAX));
    const vec2 second_moments = sqrt(mix(past.second_moments * past.second_moments, bright * bright, part));
    joined.second_moments = packHalf2x16(second_moments);
    joined.lengths = packHalf2x16(vec2(length));
    filter_history[this_half() + index] = joined;

    // How far the means may be off: from their own past, or, while that is short, from the neighbours.
    const vec2 mean = luminances(joined.direct, joined.indirect);
    vec2 deviation = sqrt(max(second_moments * second_moments - mean * mean, vec2(0.0)) * part);
    if (young) deviation = max(deviation, max(around.second_moments, mean) * sqrt(part));
    filter_light[index] = pack_light(Light2(joined.direct, joined.indirect, deviation));
}
