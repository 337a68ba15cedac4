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
    if (!pixel_of_invocation(pixel, index)) return;
    const PrimaryHit hit = primary_hits[index];
    if (hit.primitive == NONE) return;
    Random random = path_random(pixel, STREAM_DIRECT);
    add_radiance(index, next_event_estimate(load_primary_surface(hit), random), false);
}
