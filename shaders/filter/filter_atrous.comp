#version 460
// SPDX-License-Identifier: GPL-2.0-or-later
// Pass `filter_atrous`: one step of an edge-avoiding wavelet filter (Dammertz et al. 2010) whose tolerance for differences in brightness is what
// noise explains (Schied et al. 2017, section 4.3). It runs several times, over pixels filter_stride apart: each time twice as far, and at last over those
// beside again, or a grid as wide as the strides would show.
#extension GL_GOOGLE_include_directive : require
#include "shared/extensions.glsl"
#include "filter/filter.glsl"

const uint FAR = 8u;     // pixels apart, from which on calm pixels are left alone
const float ALONE = 1.0; // sum of the weights around, of 12, below which a pixel has no surface in common with any other

float kernel_weight(ivec2 step) { return (step.x == 0 ? 2.0 : 1.0) * (step.y == 0 ? 2.0 : 1.0); }

/// About exp(-x), and 0 from x = 4 on: cheaper.
vec2 falls_off(vec2 x) {
    const vec2 root = max(1.0 - 0.25 * x, vec2(0.0));
    return root * root * root * root;
}

/// Variances around a pixel, smoothed: one pixel's own is itself a guess, until a first step has averaged it.
vec2 smooth_variance(ivec2 pixel, uint source, vec2 deviation) {
    if (filter_step > 0u) return deviation * deviation;
    vec2 sum = vec2(0.0);
    float weights = 0.0;
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) {
            const ivec2 step = ivec2(x, y);
            if (!inside_picture(pixel + step)) continue;
            const vec2 near = unpackHalf2x16(load_packed_light(source + pixel_index(pixel + step)).w);
            sum += kernel_weight(step) * near * near;
            weights += kernel_weight(step);
        }
    return sum / weights;
}

/// Light of the eight around a pixel, whatever they show. The brighter, the less it counts: a lamp's own surface tells little of others.
Light2 light_around(ivec2 pixel, uint source, Light2 middle) {
    Light2 sum = Light2(vec3(0.0), vec3(0.0), vec2(0.0));
    vec2 weights = vec2(0.0);
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) {
            const ivec2 at = pixel + ivec2(x, y);
            if (x == 0 && y == 0 || !same_side(at, pixel) || load_surface(this_half() + pixel_index(at)).depth == 0.0) continue;
            const Light2 light = unpack_light(load_packed_light(source + pixel_index(at)));
            const vec2 weight = 1.0 / (middle.deviation + luminances(light.direct, light.indirect) + 1e-6);
            sum.direct += weight.x * light.direct;
            sum.indirect += weight.y * light.indirect;
            weights += weight;
        }
    if (weights.x == 0.0) return middle;
    return Light2(sum.direct / weights.x, sum.indirect / weights.y, middle.deviation);
}

/// Standard deviations that a neighbour's brightness may be off: flt_sigma up to two pixels away, half as many at twice as far, or shadows would be lost.
float tolerance() { return frame.settings.flt_sigma * min(2.0 / float(filter_stride), 1.0); }

/// Whether the noise that is left in a pixel may stay.
bool is_calm(Light2 light) { return length(light.deviation) <= frame.settings.flt_noise * luminance(light.direct + light.indirect); }

void main() {
    const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (!inside_picture(pixel)) return;
    const uint index = pixel_index(pixel);
    const uint source = (filter_step & 1u) * frame.filter_capacity;
    const uint target = frame.filter_capacity - source;
    const FilterSurface surface = load_surface(this_half() + index);
    const uvec4 packed = load_packed_light(source + index);
    const Light2 middle = unpack_light(packed);
    if (surface.depth == 0.0 || filter_stride >= FAR && is_calm(middle)) {
        filter_light[target + index] = packed;
        return;
    }
    const vec4 facing = unpackSnorm4x8(surface.facing);
    const vec3 normal = facing.xyz;
    const vec2 bright = luminances(middle.direct, middle.indirect);
    const vec2 variance = smooth_variance(pixel, source, middle.deviation);
    const int stride = int(filter_stride);
    // Distance from the surface's plane, in widths of the step: depths times the rays' parts along the normal.
    const float along = dot(camera_ray(vec2(pixel) + turn.pixel_point), normal);
    const vec2 along_step = 2.0 * float(stride) / vec2(frame.size) * vec2(dot(frame.camera_right, normal), -dot(frame.camera_up, normal));
    const float own_distance = surface.depth * along;
    const float per_distance = 1.0 / (surface.depth * frame.pixel_angle * float(stride));

    const float own = 4.0;
    vec2 weights = vec2(own);
    Light2 sum = Light2(own * middle.direct, own * middle.indirect, own * own * middle.deviation * middle.deviation);
    for (int i = 0; i < 9; ++i) {
        if (i == 4) continue;
        const ivec2 step = ivec2(i % 3 - 1, i / 3 - 1);
        const ivec2 at = pixel + stride * step;
        if (!same_side(at, pixel)) continue;
        const uint there = pixel_index(at);
        const FilterSurface other = load_surface(this_half() + there);
        if (other.depth == 0.0) continue;
        const Light2 light = unpack_light(load_packed_light(source + there));
        // How much the other surface is like this one, and how much its light may be the same.
        const float off_plane = abs(other.depth * (along + dot(vec2(step), along_step)) - own_distance) * per_distance;
        // The noise of both explains a difference: if one's alone did, dark pixels would refuse what bright ones give, and light be lost.
        const vec2 noise = sqrt(variance + light.deviation * light.deviation);
        const vec2 apart = abs(luminances(light.direct, light.indirect) - bright) / (tolerance() * noise + 1e-4 + 1e-3 * bright);
        const vec2 weight = kernel_weight(step) * alike(facing, unpackSnorm4x8(other.facing)) * falls_off(apart + off_plane);
        sum.direct += weight.x * light.direct;
        sum.indirect += weight.y * light.indirect;
        sum.deviation += weight * weight * light.deviation * light.deviation;
        weights += weight;
    }
    sum.direct /= weights.x;
    sum.indirect /= weights.y;
    // Nobody around shows this surface, and its own light is little known: any surface's is better. Edges of a pixel's width would be black or bright.
    const bvec2 alone = lessThan(weights, vec2(own + ALONE)), unknown = greaterThan(middle.deviation, 0.5 * bright);
    if (filter_step == 0u && (alone.x && unknown.x || alone.y && unknown.y)) {
        const Light2 any = light_around(pixel, source, middle);
        if (alone.x && unknown.x) sum.direct = any.direct;
        if (alone.y && unknown.y) sum.indirect = any.indirect;
    }
    sum.deviation = sqrt(sum.deviation) / weights;
    filter_light[target + index] = pack_light(sum);
}
