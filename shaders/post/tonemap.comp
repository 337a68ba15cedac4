#version 460
// SPDX-License-Identifier: GPL-2.0-or-later
// Pass `tonemap`: exposed radiance to 8-bit sRGB. Curves: none (clip), Reinhard et al. 2002 on luminance with white at 4, and
// Narkowicz's 2015 fit of the ACES filmic curve. A debug view, if one is on, is shown as it is.
// Once per side of the picture, because views show what the side's technique knows.
#extension GL_GOOGLE_include_directive : require
#include "shared/extensions.glsl"
#include "post/picture.glsl"
#include "debug/view.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = CONSTANT_VIEW) const bool HAS_VIEW = true; // pt_view is on

vec3 reinhard(vec3 color) {
    const float white = 4.0;
    const float bright = luminance(color);
    return color * ((1.0 + bright / (white * white)) / (1.0 + bright));
}

vec3 filmic(vec3 color) { return (color * (2.51 * color + 0.03)) / (color * (2.43 * color + 0.59) + 0.14); }

/// Exposed and toned, sRGB.
vec3 picture_color(vec3 value) {
    vec3 color = min(value * exposure, vec3(1e4));
    if (frame.settings.pt_tonemap == 1) color = reinhard(color);
    if (frame.settings.pt_tonemap == 2) color = filmic(0.8 * color);
    return srgb_from_linear(clamp(color, 0.0, 1.0));
}

void main() {
    uvec2 pixel;
    if (!pixel_of_side(pixel)) return;
    const uint index = pixel.y * frame.size.x + pixel.x;
    vec3 color = picture_color(mean_radiance[index]);
    if (HAS_VIEW) color = view_color(pixel, color);
    // The line between two sides: a dark column and a bright one, visible on any ground.
    if (pixel.x + 1u == end_column && end_column < frame.size.x) color = vec3(0.0);
    if (pixel.x == first_column && first_column > 0u) color = vec3(1.0);
    display[index] = packUnorm4x8(vec4(color, 1.0));
}
