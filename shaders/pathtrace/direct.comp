#version 460
// SPDX-License-Identifier: GPL-2.0-or-later
// Pass `direct`: next event estimation at the primary hit. Compiled once per technique.
#extension GL_GOOGLE_include_directive : require
#include "shared/extensions.glsl"
#include "pathtrace/path.glsl"
#include "pathtrace/next_event.glsl"

void main() {
    uvec2 pixel;
    uint index;
    if (!pixel_of_side_invocation(pixel, index)) return;
    const PrimaryHit hit = load_primary_hit(index);
    if (hit.primitive == NONE) return;
    Random random = path_random(pixel, STREAM_DIRECT);
    const DirectLight light = next_event_estimate(load_primary_surface(hit), 0u, frame.settings.pt_bounces > 0, random);
    pixel_flags[index] |= (light.radiance == vec3(0.0) ? PIXEL_UNLIT : 0u) | (light.explored ? PIXEL_EXPLORED : 0u);
    add_radiance(index, light.radiance, false);
    if (frame.filter_flags == 0u) return;
    const vec3 before = path_index > 0u ? filter_input[index].direct : vec3(0.0);
    filter_input[index].direct = radiance_sum(before, light.radiance / filter_albedo(hit));
    if (path_index == 0u) filter_input[index].direct_light = light.light;
}
