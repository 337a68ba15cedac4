// SPDX-License-Identifier: GPL-2.0-or-later
// Buffers of the filter (host side: refresh/vkpt/filter/filter.h), and what its passes share: where pixels lie in space and in the frame before, and
// light as the passes over neighbours hand it on.
#ifndef VIGIL_FILTER_FILTER_GLSL
#define VIGIL_FILTER_FILTER_GLSL

#include "scene/frame.glsl"
#include "shared/brdf.h"
#include "shared/filter_types.h"

layout(local_size_x = 8, local_size_y = 8) in;

// Those of two frames have two halves; turn.filter_half says which is this frame's.
layout(set = SET_FILTER, binding = BINDING_FILTER_SURFACES, scalar) restrict writeonly buffer FilterSurfaceBlock {
    FilterSurface filter_surfaces[];
};
layout(set = SET_FILTER, binding = BINDING_FILTER_HISTORY, scalar) restrict writeonly buffer FilterHistoryBlock {
    FilterHistory filter_history[];
};
layout(set = SET_FILTER, binding = BINDING_FILTER_STATISTICS, scalar) restrict writeonly buffer FilterStatisticsBlock {
    FilterStatistics filter_statistics[];
};
layout(set = SET_FILTER, binding = BINDING_FILTER_LIGHT, scalar) restrict writeonly buffer FilterLightBlock {
    uvec4 filter_light[];
}; // pack_light()
layout(set = SET_FILTER, binding = BINDING_FILTER_RESOLVED, scalar) restrict writeonly buffer FilterResolvedBlock {
    uvec2 filter_resolved[];
}; // pack_color()
// The same to read.
layout(set = SET_FILTER, binding = BINDING_FILTER_SURFACE_RECORDS) uniform utextureBuffer surface_records;
layout(set = SET_FILTER, binding = BINDING_FILTER_HISTORY_RECORDS) uniform utextureBuffer history_records;
layout(set = SET_FILTER, binding = BINDING_FILTER_STATISTICS_RECORDS) uniform utextureBuffer statistics_records;
layout(set = SET_FILTER, binding = BINDING_FILTER_LIGHT_RECORDS) uniform utextureBuffer light_records;
layout(set = SET_FILTER, binding = BINDING_FILTER_RESOLVED_RECORDS) uniform utextureBuffer resolved_records; // two pixels each

layout(set = SET_SCENE, binding = BINDING_FILTER_INPUT_RECORDS) uniform utextureBuffer filter_input_records;

/// Fields that a caller does not use cost no loads.
FilterInput load_filter_input(uint index) {
    const int at = int(index) * FILTER_INPUT_TEXELS;
    const uvec4 a = texelFetch(filter_input_records, at), b = texelFetch(filter_input_records, at + 1),
                c = texelFetch(filter_input_records, at + 2);
    return FilterInput(uintBitsToFloat(a.xyz), a.w, uintBitsToFloat(b.xyz), b.w, uintBitsToFloat(c.xyz), c.w);
}

FilterSurface load_surface(uint index) {
    const uvec4 words = texelFetch(surface_records, int(index));
    return FilterSurface(words.x, uintBitsToFloat(words.y), words.z, words.w);
}

FilterHistory load_history(uint index) {
    const uvec4 words = texelFetch(history_records, int(index));
    return FilterHistory(words.xy, words.zw);
}

FilterStatistics load_statistics(uint index) {
    const uvec4 words = texelFetch(statistics_records, int(index));
    return FilterStatistics(words.x, words.y, words.z, words.w);
}

uvec2 load_resolved(uint index) {
    const uvec4 two = texelFetch(resolved_records, int(index >> 1));
    return (index & 1u) == 0u ? two.xy : two.zw;
}

uvec4 load_packed_light(uint index) { return texelFetch(light_records, int(index)); }

uint this_half() { return turn.filter_half * frame.filter_capacity; }
uint last_half() { return (1u - turn.filter_half) * frame.filter_capacity; }
uint pixel_index(ivec2 pixel) { return uint(pixel.y) * frame.size.x + uint(pixel.x); }
/// Of the frame before, which may have been of another size.
uint last_index(ivec2 pixel) { return last_half() + uint(pixel.y) * frame.last_size.x + uint(pixel.x); }
bool inside_last(ivec2 pixel) { return all(greaterThanEqual(pixel, ivec2(0))) && all(lessThan(pixel, ivec2(frame.last_size))); }
bool inside_picture(ivec2 pixel) { return all(greaterThanEqual(pixel, ivec2(0))) && all(lessThan(pixel, ivec2(frame.size))); }

/// Whether a place is in the picture, on the same side of it as a pixel.
bool same_side(ivec2 at, ivec2 pixel) {
    return inside_picture(at) && (at.x < int(frame.split_column)) == (pixel.x < int(frame.split_column));
}

/// A normal to within 0.4% of its length, the cheapest to unpack, which a step over neighbours does nine times; and how shiny its surface is, 0..1:
/// surfaces that reflect differently share no light.
uint pack_facing(vec3 normal, uint gloss) {
    const vec2 alpha_f0 = unpackHalf2x16(gloss);
    return packSnorm4x8(vec4(normal, sqrt(alpha_f0.y) * (1.0 - 0.5 * alpha_f0.x)));
}

/// How far two surfaces are alike in what pack_facing() holds: 1 as one, 0 where no light may be shared.
float alike(vec4 facing, vec4 other) {
    const float aligned = max(dot(facing.xyz, other.xyz), 0.0);
    const float aligned2 = aligned * aligned;
    const float aligned8 = aligned2 * aligned2 * aligned2 * aligned2;
    return aligned8 * aligned8 * max(1.0 - 8.0 * abs(facing.w - other.w), 0.0);
}

/// Direct and indirect light of a pixel, and the standard deviations of their luminances.
struct Light2 {
    vec3 direct;
    vec3 indirect;
    vec2 deviation;
};

uvec4 pack_light(Light2 light) {
    const vec3 direct = min(light.direct, vec3(FILTER_MAX)), indirect = min(light.indirect, vec3(FILTER_MAX));
    return uvec4(packHalf2x16(direct.xy), packHalf2x16(vec2(direct.z, indirect.x)), packHalf2x16(indirect.yz),
                 packHalf2x16(min(light.deviation, vec2(FILTER_MAX))));
}

Light2 unpack_light(uvec4 packed) {
    const vec2 middle = unpackHalf2x16(packed.y);
    return Light2(vec3(unpackHalf2x16(packed.x), middle.x), vec3(middle.y, unpackHalf2x16(packed.z)), unpackHalf2x16(packed.w));
}

/// A colour to within 2^-14 of itself, rounded to the nearest: a mean over frames that is kept in halves, which some devices cut off, would stay too dark.
uvec2 pack_color(vec3 color) {
    const uvec3 bits = (floatBitsToUint(color) + 0x200u) >> 10;
    return uvec2(bits.x | bits.y << 21, bits.y >> 11 | bits.z << 10);
}
vec3 unpack_color(uvec2 packed) {
    return uintBitsToFloat(uvec3(packed.x, packed.x >> 21 | packed.y << 11, packed.y >> 10) << 10 & 0x7fffffffu);
}

/// What filter_compose leaves for filter_taa, where the last step over neighbours read: pack_color() in its first half.
uint composed_index(uint index) { return ((filter_step + 1u) & 1u) * frame.filter_capacity + index; }

/// Catmull-Rom weights of four pixels in a row, right and down, for a place `within` the middle two.
mat4x2 catmull_rom(vec2 within) {
    const vec2 rest = 1.0 - within;
    return mat4x2(-0.5 * within * rest * rest, (1.5 * within - 2.5) * within * within + 1.0, (1.5 * rest - 2.5) * rest * rest + 1.0,
                  -0.5 * rest * within * within);
}

vec2 luminances(vec3 direct, vec3 indirect) { return vec2(luminance(direct), luminance(indirect)); }

/// Where in the frame before, in pixels from the corner of the picture, a point at `offset` from that frame's camera was. The first pixel's middle is
/// 0.5. False behind the camera.
bool project_last(vec3 offset, out vec2 place) {
    const float depth = dot(offset, frame.last_camera_forward);
    const vec2 screen = vec2(dot(offset, frame.last_camera_right) / dot(frame.last_camera_right, frame.last_camera_right),
                             -dot(offset, frame.last_camera_up) / dot(frame.last_camera_up, frame.last_camera_up)) /
                        depth;
    place = (0.5 * screen + 0.5) * vec2(frame.last_size);
    return depth > 0.0;
}

#endif
