#version 460
// SPDX-License-Identifier: GPL-2.0-or-later
// Pass `directions`, only for pt_view cdq: one path per cell of the map of directions, from the surface under the crosshair through a random
// point of the cell. What the paths bring is what an indirect ray of the path tracer brings. Compiled once per technique.
#extension GL_GOOGLE_include_directive : require
#include "shared/extensions.glsl"
#include "pathtrace/path.glsl"
#include "pathtrace/indirect_ray.glsl"
#include "debug/direction_map.glsl"

shared float tile[64];

/// Radiance that arrives from a direction (unit), without that of lights that next event estimation samples; nothing comes
/// from below the horizon.
vec3 arriving_radiance(Surface surface, vec3 direction, inout Random random) {
    vec3 gathered = vec3(0.0);
    if (!(dot(surface.normal, direction) > 0.0)) return gathered;
    vec3 throughput = vec3(1.0);
    Ray ray = Ray(surface.origin, 0.0, direction, 1e30);
    const int bounces = frame.settings.pt_bounces;
    Guided guided; // nobody learns from these rays
    guided.brdf_pdf = 0.0;
    for (int depth = 0; depth <= bounces; ++depth) {
        if (depth == bounces && !rays_find_light()) break;
        const bool lit = depth < bounces;
        const RayEnd end =
            follow_ray(surface, ray, guided.brdf_pdf, lit, uint(depth + 1), lit && (depth + 1 < bounces || rays_find_light()), random);
        gathered += throughput * (depth + 1 == bounces ? end.taught + end.tail : end.taught);
        vec3 weight;
        if (!end.goes_on || !scatter(end.surface, random, weight, ray, guided)) break;
        throughput *= weight;
        surface = end.surface;
    }
    return gathered;
}

/// One sample of a cell's mean.
float sample_cell(uvec2 cell) {
    const PrimaryHit hit = crosshair_hit();
    if (hit.primitive == NONE) return 0.0;
    Random random = path_random(cell, STREAM_VIEW);
    const vec2 uv = (vec2(cell) + random_next2(random)) / float(DIRECTION_MAP_EDGE);
    const vec3 direction = octahedral_decode(uv);
    const vec3 brought = arriving_radiance(load_primary_surface(hit), direction, random);
    return finite_or_zero(luminance(brought) / octahedral_density(direction));
}

void main() {
    const uvec2 cell = gl_GlobalInvocationID.xy;
    const uint lane = gl_LocalInvocationIndex;
    const uint index = cell.y * DIRECTION_MAP_EDGE + cell.x;
    float value = sample_cell(cell);
    if (turn.view_accumulated > 0u) {
        const float before = directions[index];
        value = before + (value - before) / (float(turn.view_accumulated) + 1.0);
    }
    directions[index] = value;
    tile[lane] = value;
    for (uint step = 32u; step > 0u; step >>= 1) {
        barrier();
        if (lane < step) tile[lane] += tile[lane + step];
    }
    if (lane == 0u) direction_sums[gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x] = tile[0];
}
