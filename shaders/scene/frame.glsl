// SPDX-License-Identifier: GPL-2.0-or-later
// Set 0: the frame's parameters and per-pixel buffers, and the specialisation constants of the path tracer: a level pays
// only for what it has.
#ifndef VIGIL_SCENE_FRAME_GLSL
#define VIGIL_SCENE_FRAME_GLSL

#include "shared/bindings.h"
#include "shared/filter_types.h"
#include "shared/frame_params.h"
#include "shared/indirect_turn.h"
#include "shared/scene_types.h"
#include "trace/records.glsl"

// Constants 0 and 1 belong to trace/trace.glsl.
layout(constant_id = CONSTANT_SKY) const bool HAS_SKY = true;
layout(constant_id = CONSTANT_GLOSS) const bool HAS_GLOSS = true;
layout(constant_id = CONSTANT_LIGHTS) const bool HAS_LIGHTS = true;
layout(constant_id = CONSTANT_ENVIRONMENT) const bool HAS_ENVIRONMENT = false; // sky and sun are lights
layout(constant_id = CONSTANT_GUIDER_SIZE) const uint GUIDER_SIZE = 0u;        // of what the guider keeps: guiding/guider.glsl

layout(set = SET_SCENE, binding = BINDING_FRAME, scalar) uniform FrameBlock { FrameParams frame; };

layout(set = SET_SCENE, binding = BINDING_SURFACES, scalar) restrict writeonly buffer PrimaryHitBlock { PrimaryHit primary_hits[]; };
layout(set = SET_SCENE, binding = BINDING_SURFACE_RECORDS) uniform utextureBuffer primary_hit_records; // the same to read
layout(set = SET_SCENE, binding = BINDING_PIXEL_FLAGS, scalar) restrict buffer PixelFlagBlock { uint pixel_flags[]; };
// Sum over this frame's paths; divided by pt_spp when it is accumulated.
layout(set = SET_SCENE, binding = BINDING_RADIANCE, scalar) restrict buffer RadianceBlock { vec3 radiance[]; };

// Only with FILTER_ON in frame.filter_flags.
layout(set = SET_SCENE, binding = BINDING_FILTER_INPUT, scalar) restrict buffer FilterInputBlock { FilterInput filter_input[]; };

layout(set = SET_SCENE, binding = BINDING_COUNTERS, scalar) restrict buffer CounterBlock { FrameCounters counters; };

/// Fields that a caller does not use cost no loads.
PrimaryHit load_primary_hit(uint index) {
    const int at = int(index) * PRIMARY_HIT_TEXELS;
    const uvec4 a = texelFetch(primary_hit_records, at), b = texelFetch(primary_hit_records, at + 1),
                c = texelFetch(primary_hit_records, at + 2);
    return PrimaryHit(uintBitsToFloat(a.xyz), a.w, uintBitsToFloat(b.xyz), b.w, uintBitsToFloat(c.xyz), c.w);
}

// The fields of PassConstants (shared/frame_params.h), of which passes that belong to no side need path_count and turn.
layout(push_constant, scalar) uniform PushBlock {
    uint path_index;
    uint path_count;
    uint first_column;
    uint end_column;
    uint samples_lights;
    uint guided;
    uint filter_step;
    uint filter_stride;
    uint indirect_turn;
    FrameTurn turn;
};

/// A camera ray through a place of the picture, in pixels from its corner: 1 along `forward`. The axes are as in FrameParams.
vec3 ray_through(vec2 place, vec3 forward, vec3 right, vec3 up) {
    const vec2 screen = place / vec2(frame.size) * 2.0 - 1.0;
    return forward + screen.x * right - screen.y * up;
}
vec3 camera_ray(vec2 place) { return ray_through(place, frame.camera_forward, frame.camera_right, frame.camera_up); }

bool inside_side(uvec2 pixel) { return pixel.x >= first_column && pixel.x < end_column && pixel.y < frame.size.y; }

/// The pixel of an invocation of a pass that is dispatched over a side's columns: from the work group of the first on. False
/// where it is another side's, or none.
bool pixel_of_side(out uvec2 pixel) {
    pixel = gl_GlobalInvocationID.xy + uvec2(first_column & ~7u, 0u);
    return inside_side(pixel);
}

#endif
