#version 460
// SPDX-License-Identifier: GPL-2.0-or-later
// Pass `filter_temporal`: joins a frame's light with what the frames before saw of the same surface point (Schied et al., "Spatiotemporal
// Variance-Guided Filtering", 2017, sections 4.1 and 4.2), after samples far brighter than their surroundings were dimmed.
#extension GL_GOOGLE_include_directive : require
#include "shared/extensions.glsl"
#include "filter/past.glsl"
#include "filter/tiles.glsl"

const float YOUNG = 4.0; // frames; a shorter past does not say how much light varies

vec3 dim(vec3 light, float limit) {
    const float bright = luminance(light);
    return bright > limit ? light * (limit / bright) : light;
}

void main() {
    const uvec2 pixel = gl_GlobalInvocationID.xy;
    if (any(greaterThanEqual(pixel, frame.size))) return;
    const uint index = pixel_index(ivec2(pixel));
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
    if ((frame.filter_flags & FILTER_CHANGES) != 0u) changed = vec2(changed_around(ivec2(pixel), 1).x, changed_around(ivec2(pixel), 3).y);
    past.frames *= vec2(1.0) - step(vec2(0.95), changed);
    const FilterTile around = brightness_around(ivec2(pixel));
    const vec2 past_mean = luminances(past.direct, past.indirect);
    vec2 limits = vec2(FILTER_MAX);
    if (frame.settings.flt_firefly > 0.0) {
        const vec2 by_past = past_mean + frame.settings.flt_firefly * sqrt(max(past.second_moments - past_mean * past_mean, vec2(0.0)));
        const vec2 by_tiles =
            around.mean + frame.settings.flt_firefly * sqrt(max(around.second_moments - around.mean * around.mean, vec2(0.0)));
        // What was seen before says little about lamps that have just come.
        limits = mix(min(limits, max(by_past, by_tiles)), limits, greaterThan(changed, vec2(0.1)));
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

    // How far the means may be off: from their own past, or, while that is short, from the tiles around.
    const bvec2 young = lessThan(frames, vec2(YOUNG));
    const vec2 mean = luminances(joined.direct, joined.indirect);
    const vec2 known = max(second_moments - mean * mean, vec2(0.0));
    const vec2 variance = mix(known, max(known, around.second_moments), young) * part;
    filter_light[index] = pack_light(Light2(joined.direct, joined.indirect, sqrt(variance)));
}
