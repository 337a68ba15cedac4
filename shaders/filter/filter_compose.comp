#version 460
// SPDX-License-Identifier: GPL-2.0-or-later
// Pass `filter_compose`: filtered light takes on the surfaces' colours again, and what shines by itself is added: the radiance of a picture, in place of
// the path tracer's. Once per filtered side.
#extension GL_GOOGLE_include_directive : require
#include "shared/extensions.glsl"
#include "filter/filter.glsl"

/// What a pixel's surface reflects, filtered.
vec3 lit_surface(uint index) {
    const PrimaryHit hit = load_primary_hit(index);
    if (hit.primitive == NONE) return vec3(0.0);
    const Light2 light = unpack_light(load_packed_light((filter_step & 1u) * frame.filter_capacity + index));
    return filter_albedo(hit) * (light.direct + light.indirect);
}

/// The same where several surfaces lie behind each other: pixels around show others of them (primary.comp, see_layers).
vec3 lit_layers(ivec2 pixel) {
    vec3 sum = vec3(0.0);
    float count = 0.0;
    for (int i = 0; i < 9; ++i) {
        const ivec2 at = pixel + ivec2(i % 3 - 1, i / 3 - 1);
        if (!inside_picture(at) || load_filter_input(pixel_index(at)).layered == 0u) continue;
        sum += lit_surface(pixel_index(at));
        count += 1.0;
    }
    return sum / max(count, 1.0);
}

void main() {
    uvec2 pixel;
    if (!pixel_of_side(pixel)) return;
    const uint index = pixel_index(ivec2(pixel));
    const FilterInput seen = load_filter_input(index);
    const vec3 value = seen.emission / float(path_count) + (seen.layered != 0u ? lit_layers(ivec2(pixel)) : lit_surface(index));
    if ((frame.filter_flags & FILTER_TAA) != 0u) filter_light[composed_index(index)] = uvec4(pack_color(value), 0u, 0u);
    else radiance[index] = value * float(path_count);
}
