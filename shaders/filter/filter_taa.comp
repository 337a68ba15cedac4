#version 460
// SPDX-License-Identifier: GPL-2.0-or-later
// Pass `filter_taa`: temporal anti-aliasing (Karis, "High Quality Temporal Supersampling", 2014). Camera rays pass through another point of the pixel in
// every frame; the mean over frames follows what moves, within the colours that are around the pixel now (Salvi 2016).
#extension GL_GOOGLE_include_directive : require
#include "shared/extensions.glsl"
#include "filter/filter.glsl"
#include "filter/motion.glsl"
#include "post/picture.glsl"
#include "shared/firewall.h"

const float NEW_PART = 0.1;    // of this frame in the mean
const float DEVIATIONS = 1.25; // that the mean may be off the colours around

/// Pixels of the frame before per pixel of this one.
vec2 last_scale() { return vec2(frame.last_size) / vec2(frame.size); }

/// Bright pixels count less than their radiance, so that edges next to lamps are smooth as well. To and fro.
vec3 compress(vec3 value, float factor) { return value / (1.0 + factor * luminance(value)); }
vec3 expand(vec3 value, float factor) { return value / max(1.0 - factor * luminance(value), 1e-4); }

/// The mean of the frame before at a place between its pixels; false outside of the side.
bool resolved_before(vec2 place, float factor, out vec3 value) {
    const vec2 corner = place - 0.5;
    const ivec2 first = ivec2(floor(corner));
    const vec2 within = corner - vec2(first);
    value = vec3(0.0);
    const ivec2 least = ivec2(last_scale().x * float(first_column), 0),
                most = ivec2(last_scale().x * float(end_column), frame.last_size.y) - 1;
    if (any(lessThan(ivec2(floor(place)), least)) || any(greaterThan(ivec2(floor(place)), most))) return false;
    if (all(lessThan(abs(within - 0.5), vec2(0.4999)))) {
        const mat4x2 weights = catmull_rom(within);
        float sum = 0.0;
        for (int y = -1; y <= 2; ++y)
            for (int x = -1; x <= 2; ++x) {
                const ivec2 at = clamp(first + ivec2(x, y), least, most);
                if ((x == -1 || x == 2) && (y == -1 || y == 2)) continue; // corners weigh next to nothing
                const float weight = weights[x + 1].x * weights[y + 1].y;
                value += weight * compress(unpack_color(load_resolved(last_index(at))), factor);
                sum += weight;
            }
        value = max(value / sum, vec3(0.0));
    } else {
        const ivec2 at = clamp(ivec2(floor(place)), least, most);
        value = compress(unpack_color(load_resolved(last_index(at))), factor);
    }
    return is_finite_nonnegative(value);
}

void main() {
    uvec2 pixel;
    if (!pixel_of_side(pixel)) return;
    const uint index = pixel_index(ivec2(pixel));
    const float factor = exposure > 0.0 && exposure < 1e7 ? exposure : 1.0;

    // The colours around, and the nearest surface there: edges move with what is in front.
    vec3 middle = vec3(0.0), sum = vec3(0.0), squares = vec3(0.0);
    vec3 darkest = vec3(1e30), brightest = vec3(0.0);
    float count = 0.0, nearest = 1e30;
    ivec2 front = ivec2(pixel);
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) {
            const ivec2 at = ivec2(pixel) + ivec2(x, y);
            if (!inside_side(uvec2(at))) continue;
            const vec3 color = compress(unpack_color(load_packed_light(composed_index(pixel_index(at))).xy), factor);
            if (x == 0 && y == 0) middle = color;
            sum += color;
            squares += color * color;
            darkest = min(darkest, color);
            brightest = max(brightest, color);
            count += 1.0;
            if (x != 0 && y != 0) continue;
            const float depth = load_surface(this_half() + pixel_index(at)).depth;
            if (depth > 0.0 && depth < nearest) {
                nearest = depth;
                front = at;
            }
        }
    const vec3 mean = sum / count;
    const vec3 allowed = DEVIATIONS * sqrt(max(squares / count - mean * mean, vec3(0.0)));
    // The pixel's own colour is always allowed: small lamps are far from the mean.
    darkest = min(max(mean - allowed, darkest), middle);
    brightest = max(min(mean + allowed, brightest), middle);

    // Light that is new, at a place or altogether, is shown at once.
    float new_part = NEW_PART;
    if (load_surface(this_half() + index).depth > 0.0)
        new_part = max(NEW_PART, 1.0 / max(unpackHalf2x16(load_statistics(this_half() + index).lengths).x, 1.0));
    vec3 value = middle;
    vec2 place;
    vec3 before;
    if ((frame.filter_flags & FILTER_HISTORY) != 0u && place_before(front, place) &&
        resolved_before(place + last_scale() * (vec2(pixel) + 0.5 - (vec2(front) + turn.pixel_point)), factor, before))
        value = mix(clamp(before, darkest, brightest), middle, new_part);
    value = expand(max(value, vec3(0.0)), factor);
    if (!is_finite_nonnegative(value)) value = vec3(0.0);
    filter_resolved[this_half() + index] = pack_color(value);
    radiance[index] = value * float(path_count);
}
