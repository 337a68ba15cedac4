#version 460
// SPDX-License-Identifier: GPL-2.0-or-later
// What a light-sampling technique claims and what it does, at the primary hits of the frame that was rendered last. Compiled once per
// technique; the host (light_technique_test.cpp) does the statistics. What `path_index` selects:
//   0 probabilities   of every light, as the technique tells them; path_count lights per invocation, along z
//   1 draws           how often each light is drawn; one draw per invocation, along z, as the path tracer does it; of a technique
//                     that draws beside, either the first or the second. After 0
//   2 sampled         radiance by next event estimation: a mean of path_count draws per pixel; independent ones along z
//   3 reference       the same without a choice: the sum over all lights of the level, a point on each; path_count of them per
//                     invocation, parts of one sum after each other along z
// No invocation goes through all lights: an old driver ends shaders after 65,535 turns of their loops together.
#extension GL_GOOGLE_include_directive : require
#include "shared/extensions.glsl"
#include "pathtrace/path.glsl"
#include "pathtrace/next_event.glsl"

struct Answer {
    float probability;
    uint draws;
};
// One row of light_count + 1 per pixel; the last one stands for "no light".
layout(set = 3, binding = 0, scalar) restrict buffer AnswerBlock { Answer answers[]; };
// Radiance by (z, pixel).
layout(set = 3, binding = 1, scalar) restrict writeonly buffer RadianceOutBlock { vec3 means[]; };
// Draws that each light may come from, or 0 if probabilities are not exact; then, by pixel, the largest relative difference between
// 1 / weight of a draw and the probability that was told for its light, as bits.
layout(set = 3, binding = 2, scalar) restrict buffer FactBlock {
    uint exact_draws;
    uint errors[];
};

// Random streams apart from each other, and from those of frames: draws must not be the ones that a cache was learned from.
const uint STREAMS_APART = 1000000u;

void ask_probabilities(Surface surface, uint row) {
    exact_draws = PROBABILITY_IS_EXACT * (1u + DRAWS_BESIDE);
    const uint first = gl_GlobalInvocationID.z * path_count;
    for (uint light = first; light < min(first + path_count, frame.light_count); ++light)
        answers[row + light].probability = light_probability(surface, light);
}

void count_draw(LightChoice choice, uint index, uint row) {
    atomicAdd(answers[row + min(choice.light, frame.light_count)].draws, 1u);
    if (choice.light == NONE || PROBABILITY_IS_EXACT == 0) return;
    const float probability = answers[row + choice.light].probability;
    const float error = abs(1.0 / choice.weight - probability) / max(probability, 1e-30);
    atomicMax(errors[index], floatBitsToUint(error));
}

// One loop for drawing and for going through all lights: what a technique inlines is long.
void go_through_lights(Surface surface, uvec2 pixel, uint index, uint row) {
    const bool counts = path_index == 1u;
    const bool chooses = path_index != 3u;
    Random random = random_begin(pixel, gl_GlobalInvocationID.z + path_index * STREAMS_APART, uint(frame.settings.pt_seed));
    uint first = 0u;
    uint end = path_count;
    if (!chooses) {
        const uint parts = max((frame.light_count + path_count - 1u) / path_count, 1u);
        first = gl_GlobalInvocationID.z % parts * path_count;
        end = min(first + path_count, frame.light_count);
    }
    vec3 sum = vec3(0.0);
    const bool counts_second = DRAWS_BESIDE != 0 && counts && random_next(random) < 0.5;
    float beside = 0.0;
    for (uint i = first; i < end;) {
        LightChoice choice = weighted_choice(i, 1.0);
        if (chooses) choice = draw_light(surface, beside, random);
        const bool again = DRAWS_BESIDE != 0 && chooses && beside == 0.0 && random_next(random) < choice.beside;
        if (!counts) {
            const vec3 u = random_next3(random);
            const uint seed = random_next_words(random).x;
            uint outcome;
            sum += sampled_radiance(surface, choice, u, seed, false, outcome);
        } else if ((beside > 0.0) == counts_second || !again) {
            if ((beside > 0.0) != counts_second) choice.light = NONE;
            count_draw(choice, index, row);
            return;
        }
        beside = again ? choice.beside : 0.0;
        if (!again) ++i;
    }
    if (!counts) means[gl_GlobalInvocationID.z * frame.size.x * frame.size.y + index] = chooses ? sum / float(path_count) : sum;
}

void main() {
    uvec2 pixel;
    uint index;
    if (!pixel_of_invocation(pixel, index)) return;
    const PrimaryHit hit = load_primary_hit(index);
    if (hit.primitive == NONE) return;
    const Surface surface = load_primary_surface(hit);
    const uint row = index * (frame.light_count + 1u);
    if (path_index == 0u) ask_probabilities(surface, row);
    else go_through_lights(surface, pixel, index, row);
}
