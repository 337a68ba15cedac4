#version 460
// SPDX-License-Identifier: GPL-2.0-or-later
// Pass `filter_temporal`: joins a frame's light with what the frames before saw of the same surface point (Schied et al., "Spatiotemporal
// Variance-Guided Filtering", 2017, sections 4.1 and 4.2), after samples far brighter than their surroundings were dimmed.
#extension GL_GOOGLE_include_directive : require
#include "shared/extensions.glsl"
#include "filter/past.glsl"
#include "filter/tiles.glsl"

const float YOUNG = 4.0;       // frames; a shorter past does not say how much light varies
const float OUTSTANDING = 3.0; // times as bright as samples around, as the root of their mean square

vec3 dim(vec3 light, float limit) {
    const float bright = luminance(light);
    return bright > limit ? light * (limit / bright) : light;
}

/// Indirect light of the pixels around that traced it in this frame, on the surface that a pixel shows; where there are none, of as much as `brightness`.
vec3 indirect_around(ivec2 pixel, PrimaryHit hit, FilterSurface surface, float brightness) {
    const float tolerance = 2.0 * surface.depth * frame.pixel_angle;
    float count = 0.0;
    vec3 sum = vec3(0.0);
    for (int i = 0; i < 4; ++i) {
        const int side = 2 * (i >> 1) - 1;
        const ivec2 at = pixel + ((i & 1) == 0 ? ivec2(side, 0) : ivec2(0, side));
        if (!same_side(at, pixel)) continue;
        const uint index = pixel_index(at);
        const PrimaryHit other = load_primary_hit(index);
        if (other.primitive == NONE || other.instance != hit.instance) continue;
        if (abs(dot(other.position - hit.position, hit.normal)) > tolerance) continue;
        sum += load_filter_input(index).indirect;
        count += 1.0;
    }
    return count > 0.0 ? sum / (count * float(path_count)) : vec3(brightness);
}

void main() {
    const uvec2 pixel = gl_GlobalInvocationID.xy;
    if (any(greaterThanEqual(pixel, frame.size))) return;
    const uint index = pixel_index(ivec2(pixel));
    const PrimaryHit hit = load_primary_hit(index);
    FilterSurface surface = FilterSurface(0u, 0.0, 0u, 0u);
    if (hit.primitive == NONE) {
        filter_surfaces[this_half() + index] = surface;
        filter_light[index] = uvec4(0u);
        return;
    }
    surface.facing = pack_facing(hit.normal, hit.gloss);
    surface.depth = max(dot(hit.position - frame.camera_origin, frame.camera_forward), 1e-3);
    // Places in the list of instances change from frame to frame, numbers of entities do not.
    surface.id = hit.instance == 0u ? 0u : load_instance(hit.instance).entity + 1u;
    const FilterInput seen_now = load_filter_input(index);
    surface.brightness = packHalf2x16(sample_brightness(seen_now));
    filter_surfaces[this_half() + index] = surface;

    // Dim what is far brighter than what is known of the place.
    Past past = find_past(hit, surface);
    vec3 direct = seen_now.direct / float(path_count);
    vec3 indirect = seen_now.indirect / float(path_count);
    vec2 changed = vec2(0.0);
    if ((frame.filter_flags & FILTER_CHANGES) != 0u) changed = vec2(changed_around(ivec2(pixel), 1).x, changed_around(ivec2(pixel), 3).y);
    past.frames *= vec2(1.0) - step(vec2(0.95), changed);
    const vec2 past_mean = luminances(past.direct, past.indirect);
    vec2 limits = vec2(FILTER_MAX);
    if (frame.settings.flt_firefly > 0.0)
        limits = past_mean + frame.settings.flt_firefly * sqrt(max(past.second_moments - past_mean * past_mean, vec2(0.0)));
    // A pixel whose turn it was not to trace indirect light keeps what is known. While that is little, it asks those around.
    const bool traced = has_indirect_turn(pixel, indirect_turn), asks = !traced && (past.frames.y < YOUNG || changed.y > 0.1);
    const vec2 seen = vec2(1.0, traced || asks ? 1.0 : 0.0);
    // Most pixels need not know how bright it is around.
    vec2 around_mean = vec2(0.0), around_second_moments = vec2(0.0);
    if (asks || any(lessThan(past.frames, vec2(YOUNG))) || any(greaterThan(luminances(direct, indirect), limits))) {
        brightness_around(ivec2(pixel), around_mean, around_second_moments);
        const vec2 by_tiles =
            around_mean + frame.settings.flt_firefly * sqrt(max(around_second_moments - around_mean * around_mean, vec2(0.0)));
        // What was seen before says little about lamps that have just come.
        limits = mix(min(max(limits, by_tiles), vec2(FILTER_MAX)), vec2(FILTER_MAX), greaterThan(changed, vec2(0.1)));
    }
    if (asks) indirect = indirect_around(ivec2(pixel), hit, surface, around_mean.y);
    direct = dim(direct, limits.x);
    indirect = dim(indirect, limits.y);

    // Join both. Where lamps have changed, what is new counts the more.
    const vec2 frames = min(past.frames + seen, vec2(float(frame.settings.flt_history)));
    const vec2 share = clamp(max(1.0 / frames, 1.5 * changed), vec2(0.0), vec2(1.0)); // of one frame
    const vec2 part = seen * share;
    FilterHistory joined;
    const vec3 mean_direct = mix(past.direct, direct, part.x), mean_indirect = mix(past.indirect, indirect, part.y);
    const vec2 bright = luminances(direct, indirect);
    const vec2 second_moments = mix(past.second_moments, bright * bright, part);
    joined.direct = pack_color(mean_direct);
    joined.indirect = pack_color(mean_indirect);
    filter_history[this_half() + index] = joined;
    filter_statistics[this_half() + index] =
        FilterStatistics(packHalf2x16(sqrt(second_moments)), packHalf2x16(1.0 / share), seen_now.direct_light, seen_now.indirect_light);

    // How far the means may be off: from their own past, or, while that is short, from the tiles around.
    const bvec2 young = lessThan(frames, vec2(YOUNG));
    const vec2 mean = luminances(mean_direct, mean_indirect);
    const vec2 known = max(second_moments - mean * mean, vec2(0.0));
    // A sample that is far brighter than those around may be off by as much as it is bright. So may any of indirect light, which has no sharp edges.
    const vec2 rare = mean * mean * step(vec2(OUTSTANDING * OUTSTANDING, 0.0) * around_second_moments, mean * mean);
    const vec2 variance = mix(known, max(max(known, around_second_moments), rare), young) * share;
    filter_light[index] = pack_light(Light2(mean_direct, mean_indirect, sqrt(variance)));
}
