// SPDX-License-Identifier: GPL-2.0-or-later
// What the frames before knew of the surface point that a pixel shows: found by where the point was then, on that frame's pixels around it that
// showed the same surface.
#ifndef VIGIL_FILTER_PAST_GLSL
#define VIGIL_FILTER_PAST_GLSL

#include "filter/motion.glsl"

const float TURN_OF_LOBE = 0.3; // of the lobe's width, until which a reflection counts as the same

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
    vec4 facing; // as pack_facing()
    uint id;
    float tolerance; // map units that another point of the surface may be off its plane
    vec3 along;      // how far a camera ray goes along the normal, per depth: at the first pixel, and more for each to the right and down
};

Then point_before(PrimaryHit hit, FilterSurface surface) {
    const vec3 normal = normal_before(hit.normal, hit.instance);
    const vec2 step = vec2(2.0, -2.0) / vec2(frame.last_size);
    const vec2 corner = vec2(-1.0, 1.0) + step * turn.last_pixel_point;
    const vec3 first = frame.last_camera_forward + corner.x * frame.last_camera_right + corner.y * frame.last_camera_up;
    return Then(offset_before(hit.position, hit.instance), vec4(normal, unpackSnorm4x8(surface.facing).w), surface.id,
                2.0 * surface.depth * frame.pixel_angle,
                vec3(dot(first, normal), step * vec2(dot(frame.last_camera_right, normal), dot(frame.last_camera_up, normal))));
}

bool shows_plane(uint index, ivec2 pixel, Then then) {
    const FilterSurface surface = load_surface(index);
    if (surface.depth == 0.0 || surface.id != then.id) return false;
    return abs(surface.depth * dot(then.along, vec3(1.0, pixel)) - dot(then.offset, then.facing.xyz)) < then.tolerance;
}

bool shows_same(uint index, ivec2 pixel, Then then) {
    return shows_plane(index, pixel, then) && alike(unpackSnorm4x8(load_surface(index).facing), then.facing) >= 0.2;
}

void add_past(inout Past past, uint index, float weight) {
    const FilterHistory history = load_history(index);
    const FilterStatistics statistics = load_statistics(index);
    const vec2 moments = unpackHalf2x16(statistics.second_moments);
    past.direct += weight * unpack_color(history.direct);
    past.indirect += weight * unpack_color(history.indirect);
    past.second_moments += weight * moments * moments;
    past.frames += weight * unpackHalf2x16(statistics.lengths);
}

/// Direct light at a place `within` the four pixels from `first` on, which all show the surface, by the pixels around as well: a mean of four in every
/// frame would blur shadows by more than a pixel. Catmull-Rom without its corners. Indirect light has no such edges.
void sharpen_past(inout Past past, Then then, ivec2 first, vec2 within) {
    const mat4x2 weights = catmull_rom(within);
    vec3 direct = vec3(0.0);
    vec3 least = vec3(FILTER_MAX), most = vec3(0.0); // of the four
    float sum = 0.0;
    for (int i = 0; i < 12; ++i) {
        // Four between the four, two on each side of them.
        const int side = i < 4 ? 1 + (i & 1) : 3 * (i & 1), other = 1 + ((i >> 1) & 1);
        const ivec2 tap = i < 8 ? ivec2(side, other) : ivec2(other, side);
        const ivec2 at = first + tap - 1;
        if (!inside_last(at)) continue;
        const float weight = weights[tap.x].x * weights[tap.y].y;
        const uint index = last_index(at);
        if (abs(weight) < 1e-3 || i >= 4 && !shows_plane(index, at, then)) continue;
        const vec3 seen = unpack_color(load_history(index).direct);
        if (i < 4) {
            least = min(least, seen);
            most = max(most, seen);
        }
        direct += weight * seen;
        sum += weight;
    }
    past.direct = clamp(direct / sum, least, most);
}

/// How much of a surface a pixel covers, at a place `offset` from a camera, up to a factor.
float pixel_area(vec3 offset, vec3 normal) {
    const float square = dot(offset, offset);
    return square * sqrt(square) / max(abs(dot(offset, normal)), 1e-6);
}

/// For how many frames a past may count. What a glossy surface reflected is what it reflects now until the view has turned by a part of the lobe's width.
/// Where the lobe brings little of the light, the view may turn farther. Pixels that covered more of the surface say less about what this one covers.
vec2 valid_frames(vec2 frames, PrimaryHit hit, Then then) {
    const vec3 now = hit.position - frame.camera_origin;
    frames *= min(pixel_area(now, hit.normal) / pixel_area(then.offset, then.facing.xyz), 1.0);
    const vec2 alpha_f0 = unpackHalf2x16(hit.gloss);
    if (alpha_f0.y == 0.0) return frames;
    const vec3 view = normalize(now);
    const float share = specular_share(Brdf(hit.albedo, alpha_f0.y, alpha_f0.x), abs(dot(view, hit.normal)));
    const float turned = length(view - normalize(then.offset));
    return min(frames, vec2(TURN_OF_LOBE * alpha_f0.x / max(share * turned, 1e-6)));
}

/// Sums of the four pixels from floor(corner) on that showed the surface. Returns how many there are; `sum` is that of their weights.
int add_four(inout Past past, Then then, vec2 corner, out float sum) {
    const ivec2 first = ivec2(floor(corner));
    const vec2 within = corner - vec2(first);
    int found = 0;
    sum = 0.0;
    for (int i = 0; i < 4; ++i) {
        const ivec2 at = first + ivec2(i & 1, i >> 1);
        if (!inside_last(at)) continue;
        const uint index = last_index(at);
        if (!shows_same(index, at, then)) continue;
        const vec2 parts = mix(1.0 - within, within, vec2(i & 1, i >> 1));
        add_past(past, index, parts.x * parts.y);
        sum += parts.x * parts.y;
        ++found;
    }
    return found;
}

/// The same of the nine around a place: whichever showed the surface.
float add_nine(inout Past past, Then then, vec2 corner) {
    const ivec2 nearest = ivec2(floor(corner + 0.5));
    float sum = 0.0;
    for (int i = 0; i < 9; ++i) {
        const ivec2 at = nearest + ivec2(i % 3 - 1, i / 3 - 1);
        if (!inside_last(at)) continue;
        const uint index = last_index(at);
        if (!shows_same(index, at, then)) continue;
        add_past(past, index, 1.0);
        sum += 1.0;
    }
    return sum;
}

const float LEAST_SUM = 0.05; // of the weights of four, below which they say too little

Past find_past(PrimaryHit hit, FilterSurface surface) {
    Past past = NO_PAST;
    if ((frame.filter_flags & FILTER_HISTORY) == 0u) return past;
    const Then then = point_before(hit, surface);
    vec2 place;
    if (!project_last(then.offset, place)) return past;
    // A pixel's past is of all points that camera rays passed through. So without motion it is the pixel's own, and is not resampled in each frame.
    const vec2 corner = place - turn.pixel_point, within = fract(corner);
    float sum;
    const int found = add_four(past, then, corner, sum);
    // Edges and thin things: where this point was seen, or whichever pixel around showed the surface.
    if (sum < LEAST_SUM) {
        past = NO_PAST;
        add_four(past, then, place - turn.last_pixel_point, sum);
    }
    if (sum < LEAST_SUM) {
        past = NO_PAST;
        sum = add_nine(past, then, corner);
    }
    if (sum == 0.0) return NO_PAST;
    past.direct /= sum;
    past.indirect /= sum;
    past.second_moments /= sum;
    past.frames = valid_frames(past.frames / sum, hit, then);
    if (all(lessThan(abs(within - round(within)), vec2(0.01)))) return past;
    // Each frame of a moving picture resamples the one before, and edges of direct light grow softer by it.
    past.frames.x = min(past.frames.x, float(frame.settings.flt_history_moving));
    if (found == 4) sharpen_past(past, then, ivec2(floor(corner)), within);
    return past;
}

#endif
