#version 460
// SPDX-License-Identifier: GPL-2.0-or-later
// Pass `primary`: one camera ray per pixel. Writes what it hit, and starts the pixel's radiance with what can be seen
// directly: sky, sun and lamps.
#extension GL_GOOGLE_include_directive : require
#include "shared/extensions.glsl"
#include "pathtrace/path.glsl"
#include "pathtrace/sky.glsl"

/// What a camera ray sees: what stands before all else, then the nearest. Cutouts let it pass by chance.
bool see(Ray ray, uint seed, inout Random random, out Hit hit) {
    if (!HAS_EFFECTS) return trace_camera(ray, seed, INSTANCE_SEEN, hit);
    const float start = ray.t_min;
    uint mask = INSTANCE_FRONT;
    while (true) {
        if (trace_camera(ray, seed, mask, hit)) {
            const float share = cutout_share(ray, hit);
            if (share == 1.0 || random_next(random) < share) return true;
            ray.t_min = uintBitsToFloat(floatBitsToUint(hit.t) + 4u); // just behind
        } else if (mask == INSTANCE_FRONT) {
            mask = INSTANCE_SEEN;
            ray.t_min = start;
        } else {
            return false;
        }
    }
    return false;
}

/// Steps that a pixel chooses one of several surfaces by, so that 3 x 3 pixels show each by its share.
const float LAYER_STEPS[9] = float[](0.0, 7.0, 3.0, 6.0, 5.0, 2.0, 4.0, 1.0, 8.0);
const int MOST_LAYERS = 16;

/// Follows a camera ray through translucent surfaces for the filter: what shines, of all of them by their shares, and one surface to light, which is
/// chosen by the pixel's place, so that it is the same in the next frame. The mean is that of see(), without its noise. The last of MOST_LAYERS counts
/// as opaque.
bool see_layers(Ray ray, uvec2 pixel, uint seed, out Vertex chosen, out vec3 emission, out bool layered) {
    const float choice = (LAYER_STEPS[(pixel.y % 3u) * 3u + pixel.x % 3u] + 0.5) / 9.0;
    float passes = 1.0; // of what lies behind, this part is seen
    bool found = false;
    emission = vec3(0.0);
    layered = false;
    chosen.lit = false;
    Hit hit;
    if (HAS_EFFECTS && trace_camera(ray, seed, INSTANCE_FRONT, hit)) {
        chosen = describe_hit(ray, hit, frame.pixel_angle, true);
        emission = chosen.emission;
        return true;
    }
    for (int layer = 0; layer < MOST_LAYERS; ++layer) {
        if (!trace_camera(ray, BVH_STOP_AT_ALL, INSTANCE_SEEN, hit)) break;
        float share = hit_coverage(hit);
        if (HAS_EFFECTS) share *= cutout_share(ray, hit);
        if (layer + 1 == MOST_LAYERS) share = 1.0;
        const Vertex vertex = describe_hit(ray, hit, frame.pixel_angle, true);
        emission += passes * share * (vertex.sky ? sky_radiance(ray.direction) : vertex.emission);
        if (!found && choice < 1.0 - passes * (1.0 - share)) {
            chosen = vertex;
            found = true;
        }
        if (share < 1.0) layered = true;
        passes *= 1.0 - share;
        if (passes < 1e-3) break;
        ray.t_min = uintBitsToFloat(floatBitsToUint(hit.t) + 4u); // just behind
    }
    return found;
}

void main() {
    uvec2 pixel;
    uint index;
    if (!pixel_of_invocation(pixel, index)) return;
    Random random = path_random(pixel, STREAM_PRIMARY);
    const vec2 inside = frame.jitter != 0u ? random_next2(random) : turn.pixel_point;
    const Ray ray = Ray(frame.camera_origin, 0.0, normalize(camera_ray(vec2(pixel) + inside)), 1e30);

    PrimaryHit stored;
    stored.primitive = NONE;
    vec3 emission = vec3(0.0);
    Hit hit;
    const uint seed = random_next_words(random).x;
    Vertex vertex;
    bool seen, layered = false;
    if (HAS_TRANSLUCENT && frame.filter_flags != 0u) {
        seen = see_layers(ray, pixel, seed, vertex, emission, layered);
    } else {
        seen = see(ray, seed, random, hit);
        if (seen) {
            vertex = describe_hit(ray, hit, frame.pixel_angle, true);
            emission = vertex.sky ? sky_radiance(ray.direction) : vertex.emission;
        }
    }
    if (seen && vertex.lit) {
        stored.position = vertex.surface.position;
        stored.normal = vertex.surface.normal;
        stored.albedo = vertex.surface.brdf.albedo;
        stored.primitive = vertex.surface.primitive;
        stored.instance = vertex.surface.instance;
        stored.gloss = packHalf2x16(vec2(vertex.surface.brdf.alpha, vertex.surface.brdf.f0));
    }
    // What was found not to be finite stays marked while its frame, or its mean, is made.
    pixel_flags[index] = path_index > 0u || turn.accumulated > 0u ? pixel_flags[index] & PIXEL_NONFINITE : 0u;
    primary_hits[index] = stored;
    add_radiance(index, emission, path_index == 0u);
    if (frame.filter_flags != 0u) {
        FilterInput start = FilterInput(vec3(0.0), 0u, vec3(0.0), NONE, vec3(0.0), NONE);
        if (path_index > 0u) start = filter_input[index];
        start.emission = radiance_sum(start.emission, emission);
        start.layered = layered ? 1u : 0u;
        filter_input[index] = start;
    }
}
