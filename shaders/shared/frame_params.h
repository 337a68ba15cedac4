// SPDX-License-Identifier: GPL-2.0-or-later
// What changes from frame to frame and is the same for all pixels: camera, clocks, sky, sun, and
// the variables that shaders read. Scalar layout; the host fills it in
// refresh/vkpt/frame_params.cpp.
#ifndef VIGIL_SHARED_FRAME_PARAMS_H
#define VIGIL_SHARED_FRAME_PARAMS_H

#include "glsl.h"
#include "settings_table.h"

SHADER_BEGIN

struct FrameParams {
    vec3 camera_origin;
    vec3 camera_forward; // unit
    vec3 camera_right;   // length: tan(half horizontal angle)
    vec3 camera_up;      // length: tan(half vertical angle)
    uvec2 size;          // pixels that are traced
    float pixel_angle;   // angle that a pixel covers in the middle of the picture, radians
    uint jitter;         // 1: camera rays pass through random points of the pixel
    uint light_count;    // ids in use, dark ones included
    uint sky_texture;    // first of six textures in the order of formats/sky.h, or NONE
    mat3 sky_from_world; // turns the sky box, not the sun
    vec3 sky_radiance;   // factor on the sky's texels; the radiance itself if there is no texture
    vec3 sun_direction;  // unit, towards the sun
    vec3 sun_radiance;   // of the disc; 0 without a sun, or if it is a point
    float sun_size;      // 1 - cos(half the angular diameter); below 0 there is no sun
    vec3 sun_flux;       // radiance times solid angle of the disc
    uint sun_light;      // id of the sun, or NONE: it is no light
    // What the filter needs; shared/filter_types.h.
    uint filter_flags;       // FILTER_*
    uint filter_capacity;    // pixels in each half
    uvec2 last_size;         // of the frame before, pixels
    uint split_column;       // where the picture's second side begins; its width if there is none
    vec3 last_camera_origin; // of the frame before
    vec3 last_camera_forward;
    vec3 last_camera_right;
    vec3 last_camera_up;
    GpuSettings settings;
};

/// What differs from frame to frame though nothing changes. It goes with each pass, so that FrameParams
/// need not be copied again.
struct FrameTurn {
    uint frame;            // counts rendered frames; the random sequence
    uint accumulated;      // frames in the running mean before this one; 0 starts anew
    uint view_accumulated; // the same of what pt_view takes the mean of
    float time_s;
    uint filter_half;      // 0 or 1: this frame's half of buffers that hold two frames
    vec2 pixel_point;      // where in the pixel camera rays pass unless they are jittered one by one
    vec2 last_pixel_point; // the same of the frame before
    float exposure_part;   // of this frame in an automatic exposure that follows slowly; 1: it does not
};

/// Push constants of the path tracer's passes. A picture has two sides while techniques are
/// compared, else one; passes of a side look at its columns only.
struct PassConstants {
    uint path_index;     // which of the frame's pt_spp paths per pixel a dispatch traces: only path 0 teaches
    uint path_count;     // of them; a dispatch that traces none (views) has path_index == path_count
    uint first_column;   // of the side
    uint end_column;     // the one after its last
    uint samples_lights; // 1: lights are sampled, so that flags of primary hits say what became of it
    uint guided;         // 1: the octree and its light caches are this frame's; 0: set 2 must not be read
    uint filter_step;    // of the passes of the filter: how many steps over neighbours came before
    uint filter_stride;  // of such a step: pixels between those that it joins
    uint indirect_turn;  // whose turn it is to trace indirect light: shared/indirect_turn.h
    FrameTurn turn;
};

/// Counted on the GPU, read back by the host without waiting.
struct FrameCounters {
    uint nonfinite; // radiance values that were not finite and were replaced by 0
};

SHADER_END
#endif
