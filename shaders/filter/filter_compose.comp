#version 460
// SPDX-License-Identifier: GPL-2.0-or-later
// Pass `filter_compose`: filtered light takes on the surfaces' colours again, and what shines by itself is added: the radiance of a picture, in place of
// the path tracer's. Once per filtered side.
#extension GL_GOOGLE_include_directive : require
#include "shared/extensions.glsl"
#include "filter/filter.glsl"

void main() {
    uvec2 pixel;
    if (!pixel_of_side(pixel)) return;
    const uint index = pixel.y * frame.size.x + pixel.x;
    const PrimaryHit hit = primary_hits[index];
    vec3 value = filter_input[index].emission / float(path_count);
    if (hit.primitive != NONE) {
        const Light2 light = unpack_light(filter_light[(filter_step & 1u) * pixel_count() + index]);
        value += filter_albedo(hit.albedo, unpackHalf2x16(hit.gloss).y) * (light.direct + light.indirect);
    }
    if ((frame.filter_flags & FILTER_TAA) != 0u) filter_light[composed_index(index)] = uvec4(floatBitsToUint(value), 0u);
    else radiance[index] = value * float(path_count);
}
