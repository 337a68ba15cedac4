#version 460
// SPDX-License-Identifier: GPL-2.0-or-later
// Pass `filter_temporal`: joins a frame's light with what the frames before saw of the same surface point (Schied et al., "Spatiotemporal
// Variance-Guided Filtering", 2017, sections 4.1 and 4.2), after samples far brighter than their surroundings were dimmed.
#extension GL_GOOGLE_include_directive : require
#include "shared/extensions.glsl"
#include "filter/past.glsl"

const float YOUNG = 4.0;  // frames; a shorter past does not say how much light varies
const int NEIGHBOURS = 2; // pixels in each direction, that are asked then

/// What the neighbours' samples of this frame say; luminances, direct and indirect.
struct Neighbourhood {
    vec2 brightest;      // without the pixel itself
    vec2 second_moments; // means of squares, with it
};

vec2 sample_brightness(uint index) {
    return min(luminances(filter_input[index].direct, filter_input[index].indirect) / float(path_count), vec2(FILTER_MAX));
}

Neighbourhood look_around(ivec2 pixel, PrimaryHit hit) {
    Neighbourhood seen = Neighbourhood(vec2(0.0), vec2(0.0));
    float count = 0.0;
    for (int y = -NEIGHBOURS; y <= NEIGHBOURS; ++y)
        for (int x = -NEIGHBOURS; x <= NEIGHBOURS; ++x) {
            const ivec2 at = pixel + ivec2(x, y);
            if (!inside_picture(at)) continue;
            const uint index = pixel_index(at);
            if (primary_hits[index].primitive == NONE || dot(primary_hits[index].normal, hit.normal) < 0.5) continue;
            const vec2 bright = sample_brightness(index);
            if (x != 0 || y != 0) seen.brightest = max(seen.brightest, bright);
            seen.second_moments += bright * bright;
            count += 1.0;
        }
    seen.second_moments /= max(count, 1.0);
    return seen;
}

vec3 dim(vec3 light, float limit) {
    const float bright = luminance(light);
    return bright > limit ? light * (limit / bright) : light;
}

/// Part of the light around a pixel that comes from lamps that have changed, in tiles `apart` from each other.
vec2 changed_around(ivec2 pixel, int apart) {
    vec4 sum = vec4(0.0);
    const ivec2 tiles = ivec2(change_tiles());
    for (int i = 0; i < 9; ++i) {
        const ivec2 tile = clamp(pixel / CHANGE_TILE + apart * ivec2(i % 3 - 1, i / 3 - 1), ivec2(0), tiles - 1);
        sum += filter_tiles[tile.y * tiles.x + tile.x];
    }
    return sum.xz / max(sum.yw, vec2(1e-6));
}

void main() {
    const uvec2 pixel = gl_GlobalInvocationID.xy;
    if (any(greaterThanEqual(pixel, frame.size))) return;
    const uint index = pixel.y * frame.size.x + pixel.x;
    const PrimaryHit hit = primary_hits[index];
    FilterSurface surface = FilterSurface(0u, 0.0, 0u, NONE, NONE, 0u);
    if (hit.primitive == NONE) {
        filter_surfaces[this_half() + index] = surface;
        filter_light[index] = uvec4(0u);
        return;
    }
    surface.normal = pack_normal(hit.normal);
    surface.depth = max(dot(hit.position - frame.camera_origin, frame.camera_forward), 1e-3);
    surface.id = hit.instance;
    surface.direct_light = filter_input[index].direct_light;
    surface.indirect_light = filter_input[index].indirect_light;
    surface.brightness = packHalf2x16(sample_brightness(index));
    filter_surfaces[this_half() + index] = surface;

    // Dim what is far brighter than what is known of the place.
    Past past = find_past(hit, surface);
    vec3 direct = filter_input[index].direct / float(path_count);
    vec3 indirect = filter_input[index].indirect / float(path_count);
    vec2 changed = vec2(0.0);
    if ((frame.filter_flags & FILTER_CHANGES) != 0u)
        changed = vec2(changed_around(ivec2(pixel), 1).x, changed_around(ivec2(pixel), 3).y);
    past.frames *= vec2(1.0) - step(vec2(0.95), changed);
    const bvec2 young = lessThan(past.frames, vec2(YOUNG));
    Neighbourhood around = Neighbourhood(vec2(0.0), vec2(0.0));
    if (any(young)) around = look_around(ivec2(pixel), hit);
    vec2 limits = vec2(FILTER_MAX);
    if (frame.settings.flt_firefly > 0.0) {
        const vec2 mean = luminances(past.direct, past.indirect);
        const vec2 known = mean + frame.settings.flt_firefly * sqrt(max(past.second_moments - mean * mean, vec2(0.0)));
        limits = min(limits, mix(known, around.brightest, young));
    }
    direct = dim(direct, limits.x);
    indirect = dim(indirect, limits.y);

    // Join both. Where lamps have changed, what is new counts the more.
    const vec2 frames = min(past.frames + 1.0, vec2(float(frame.settings.flt_history)));
    const vec2 part = clamp(max(1.0 / frames, 1.5 * changed), vec2(0.0), vec2(1.0));
    FilterHistory joined;
    joined.direct = mix(past.direct, direct, part.x);
    joined.indirect = mix(past.indirect, indirect, part.y);
    const vec2 bright = luminances(direct, indirect);
    const vec2 second_moments = mix(past.second_moments, bright * bright, part);
    joined.second_moments = packHalf2x16(sqrt(second_moments));
    joined.lengths = packHalf2x16(1.0 / part);
    filter_history[this_half() + index] = joined;

    // How far the means may be off: from their own past, or, while that is short, from the neighbours.
    const vec2 mean = luminances(joined.direct, joined.indirect);
    const vec2 known = max(second_moments - mean * mean, vec2(0.0));
    const vec2 variance = mix(known, max(known, around.second_moments), young) * part;
    filter_light[index] = pack_light(Light2(joined.direct, joined.indirect, sqrt(variance)));
}
