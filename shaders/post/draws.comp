#version 460
// SPDX-License-Identifier: GPL-2.0-or-later
// Pass `draws`: pictures and fills over the finished picture. One layer of work groups per rectangle; those of one dispatch
// have no pixel in common. Texels are taken as they are (no filter), and blended as Quake does, in sRGB.
#extension GL_GOOGLE_include_directive : require
#include "shared/extensions.glsl"
#include "shared/bindings.h"
#include "shared/draw.h"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = BINDING_DRAWS_DISPLAY, scalar) restrict buffer DisplayBlock { uint display[]; };
layout(set = 0, binding = BINDING_DRAWS_RECTS, scalar) restrict readonly buffer DrawBlock { DrawRect draws[]; };
layout(set = 0, binding = BINDING_DRAWS_TEXELS, scalar) restrict readonly buffer TexelBlock { uint texels[]; };

layout(push_constant, scalar) uniform PushBlock {
    uint first_draw;
    uint screen_width;
};

void main() {
    const DrawRect draw = draws[first_draw + gl_WorkGroupID.z];
    const ivec2 pixel = draw.shown_from + ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, draw.shown_to))) return;
    vec4 color = draw.color;
    if (draw.picture_size.x > 0u) {
        const vec2 part = (vec2(pixel - draw.corner) + 0.5) / vec2(draw.size);
        const vec2 uv = mix(draw.from, draw.to, part);
        const ivec2 last = ivec2(draw.picture_size) - 1;
        const ivec2 texel = clamp(ivec2(floor(uv * vec2(draw.picture_size))), ivec2(0), last);
        color *= unpackUnorm4x8(texels[draw.first_texel + uint(texel.y) * draw.picture_size.x + uint(texel.x)]);
    }
    const uint index = uint(pixel.y) * screen_width + uint(pixel.x);
    const vec3 below = unpackUnorm4x8(display[index]).rgb;
    display[index] = packUnorm4x8(vec4(mix(below, min(color.rgb, 1.0), clamp(color.a, 0.0, 1.0)), 1.0));
}
