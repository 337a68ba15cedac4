// SPDX-License-Identifier: GPL-2.0-or-later
// What the filter keeps per pixel (shaders/filter, refresh/vkpt/filter), in scalar layout, and what of it is arithmetic.
#ifndef VIGIL_SHARED_FILTER_TYPES_H
#define VIGIL_SHARED_FILTER_TYPES_H

#include "glsl.h"
#include "scene_types.h"

SHADER_BEGIN

/// What the path tracer writes for the filter: sums over the frame's paths.
struct FilterInput {
    vec3 emission;     // seen directly
    uint layered;      // 1 where the pixel shows one of several surfaces behind each other
    vec3 direct;       // light that the primary hit reflects, divided by its filter_albedo()
    uint direct_light; // id of the light that the first path's sample drew at the primary hit, or NONE
    vec3 indirect;
    uint indirect_light; // the same where its first indirect ray ended
};
SHADER_CONST int FILTER_INPUT_TEXELS = 3;

/// What a pixel shows, of this frame and of the one before.
struct FilterSurface {
    uint facing;     // pack_facing() of filter/filter.glsl
    float depth;     // along the camera's forward axis, map units; 0: nothing to filter (sky)
    uint id;         // instance
    uint brightness; // packHalf2x16: luminances of the frame's samples, direct and indirect
};

/// Light of a surface, averaged over frames.
struct FilterHistory {
    uvec2 direct; // means: pack_color() of filter/filter.glsl
    uvec2 indirect;
};

/// What else is known of that light, and which lamps the frame's samples drew.
struct FilterStatistics {
    uint second_moments; // packHalf2x16: square roots of the mean squared luminances, direct and indirect
    uint lengths;        // packHalf2x16: how many frames the means are of, direct and indirect
    uint direct_light;   // as FilterInput
    uint indirect_light;
};

/// FrameParams::filter_flags
SHADER_CONST uint FILTER_ON = 1u;      // the path tracer writes FilterInput
SHADER_CONST uint FILTER_HISTORY = 2u; // the frame before left its half of the buffers
SHADER_CONST uint FILTER_TAA = 4u;     // camera rays are moved within the pixel from frame to frame

SHADER_CONST uint FILTER_CHANGES = 8u; // a lamp has changed since the frame before

/// What is known of the samples in a square of FILTER_TILE pixels; luminances of light without albedo.
struct FilterTile {
    vec4 changed;        // sums of two frames: of lamps that have changed, direct and indirect; of all
    vec2 mean;           // direct and indirect
    vec2 second_moments; // means of squares
};
SHADER_CONST int FILTER_TILE = 4;

/// Brightest light that the filter keeps: halves end at 65504.
SHADER_CONST float FILTER_MAX = 60000.0f;

/// What light is divided by before it is filtered, so that textures stay sharp: what a surface reflects of even light, at
/// least a hundredth.
SHADER_FN vec3 filter_albedo(PrimaryHit hit) { return max(hit.albedo + unpackHalf2x16(hit.gloss).y, vec3(0.01f)); }

SHADER_END
#endif
