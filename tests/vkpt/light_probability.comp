#version 460
// SPDX-License-Identifier: GPL-2.0-or-later
// What a light-sampling technique claims and what it does, at the primary hits of the frame that was rendered last: the
// probability of every light (path_index 0), and how often it is drawn (path_index 1; one draw per invocation, along z, as the
// path tracer does it). Compiled once per technique; the host (light_probability_test.cpp) does the statistics.
#extension GL_GOOGLE_include_directive : require
#include "shared/extensions.glsl"
#include "pathtrace/path.glsl"
#include "light/technique.glsl"

// One row of light_count + 1 numbers per pixel; the last one stands for "no light".
layout(set = 3, binding = 0, scalar) restrict writeonly buffer ProbabilityBlock { float probabilities[]; };
layout(set = 3, binding = 1, scalar) restrict buffer CountBlock { uint draws[]; };
// Largest relative difference between the probability that came with a draw and the one asked for afterwards; as bits.
layout(set = 3, binding = 2, scalar) restrict buffer ErrorBlock { uint errors[]; };

void main() {
    uvec2 pixel;
    uint index;
    if (!pixel_of_invocation(pixel, index)) return;
    const PrimaryHit hit = primary_hits[index];
    if (hit.primitive == NONE) return;
    const Surface surface = load_primary_surface(hit);
    const uint row = index * (frame.light_count + 1u);
    if (path_index == 0u) {
        float sum = 0.0;
        for (uint light = 0u; light < frame.light_count; ++light) {
            const float probability = light_probability(surface, light);
            probabilities[row + light] = probability;
            sum += probability;
        }
        probabilities[row + frame.light_count] = 1.0 - sum;
        return;
    }
    Random random = random_begin(pixel, gl_GlobalInvocationID.z, uint(frame.cvars.pt_seed));
    const LightChoice choice = choose_light(surface, random);
    atomicAdd(draws[row + min(choice.light, frame.light_count)], 1u);
    if (choice.light == NONE) return;
    const float probability = light_probability(surface, choice.light);
    const float error = abs(choice.probability - probability) / max(probability, 1e-30);
    atomicMax(errors[index], floatBitsToUint(error));
}
