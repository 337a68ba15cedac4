// SPDX-License-Identifier: GPL-2.0-or-later
// Buffers of the filter (host side: refresh/vkpt/filter/filter.h), and what its passes share: where pixels lie in space and in the frame before, and
// light as the passes over neighbours hand it on.
#ifndef VIGIL_FILTER_FILTER_GLSL
#define VIGIL_FILTER_FILTER_GLSL

#include "scene/frame.glsl"
#include "shared/brdf.h"
#include "shared/filter_types.h"

layout(local_size_x = 8, local_size_y = 8) in;

// Those of two frames have two halves; frame.filter_half says which is this frame's.
layout(set = SET_FILTER, binding = BINDING_FILTER_SURFACES, scalar) restrict buffer FilterSurfaceBlock { FilterSurface filter_surfaces[]; };
layout(set = SET_FILTER, binding = BINDING_FILTER_HISTORY, scalar) restrict buffer FilterHistoryBlock { FilterHistory filter_history[]; };
layout(set = SET_FILTER, binding = BINDING_FILTER_LIGHT, scalar) restrict buffer FilterLightBlock { uvec4 filter_light[]; }; // pack_light()
layout(set = SET_FILTER, binding = BINDING_FILTER_RESOLVED, scalar) restrict buffer FilterResolvedBlock { vec3 filter_resolved[]; };

uint pixel_count() { return frame.size.x * frame.size.y; }
uint this_half() { return frame.filter_half * pixel_count(); }
uint last_half() { return (1u - frame.filter_half) * pixel_count(); }
uint pixel_index(ivec2 pixel) { return uint(pixel.y) * frame.size.x + uint(pixel.x); }
bool inside_picture(ivec2 pixel) { return all(greaterThanEqual(pixel, ivec2(0))) && all(lessThan(pixel, ivec2(frame.size))); }

/// To within 0.4% of its length: the cheapest to unpack, which a step over neighbours does nine times.
uint pack_normal(vec3 normal) { return packSnorm4x8(vec4(normal, 0.0)); }
vec3 unpack_normal(uint packed) { return unpackSnorm4x8(packed).xyz; }

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

/// What filter_compose leaves for filter_taa: a colour as bits of floats, where the last step over neighbours read.
uint composed_index(uint index) { return ((filter_step + 1u) & 1u) * pixel_count() + index; }
uvec4 composed(uint index) { return filter_light[composed_index(index)]; }

vec2 luminances(vec3 direct, vec3 indirect) { return vec2(luminance(direct), luminance(indirect)); }

/// Where in the frame before, in pixels from the corner of the picture, a point at `offset` from that frame's camera was. The first pixel's middle is
/// 0.5. False behind the camera.
bool project_last(vec3 offset, out vec2 place) {
    const float depth = dot(offset, frame.last_camera_forward);
    const vec2 screen = vec2(dot(offset, frame.last_camera_right) / dot(frame.last_camera_right, frame.last_camera_right),
                             -dot(offset, frame.last_camera_up) / dot(frame.last_camera_up, frame.last_camera_up)) /
                        depth;
    place = (0.5 * screen + 0.5) * vec2(frame.size);
    return depth > 0.0;
}

#endif
