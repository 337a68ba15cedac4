// SPDX-License-Identifier: GPL-2.0-or-later
// Guider `lobe`: one lobe per node of the octree, around the mean direction m (unit) of what rays brought. Its density is
// (n + 1) / 4 pi * ((1 + m.w) / 2)^n. The mean of m.w is then n / (n + 2), so that a mean vector of length r asks for
// n = 2 r / (1 - r). Without rays n is 0: all directions alike.
#ifndef VIGIL_GUIDING_LOBE_GLSL
#define VIGIL_GUIDING_LOBE_GLSL

#include "shared/sampling.h"

#define GUIDES 1

const float LOBE_SHARPEST = 64.0;

struct Guide {
    vec3 mean; // unit
    float power;
};

/// `words` are the sum of directions, weighted, and the sum of weights.
Guide guide_prepare(uvec4 words) {
    const vec4 sums = uintBitsToFloat(words);
    Guide guide = Guide(vec3(0.0, 0.0, 1.0), 0.0);
    const vec3 mean = sums.xyz / sums.w; // first: squares of the sums may overflow
    const float size = length(mean);
    if (!(size > 1e-6)) return guide;
    guide.mean = mean / size;
    const float r = min(size, 1.0);
    guide.power = min(2.0 * r / max(1.0 - r, 1e-6), LOBE_SHARPEST);
    return guide;
}

float guide_pdf(Guide guide, vec3 direction) {
    // |m + w| / 2 is the root of t: close to -m it keeps its digits, and 1 + m.w does not.
    const vec3 half_sum = 0.5 * (guide.mean + direction);
    return (guide.power + 1.0) / (4.0 * PI) * pow(min(dot(half_sum, half_sum), 1.0), guide.power);
}

vec3 guide_sample(Guide guide, vec3 u, out float pdf) {
    // t = (1 + m.w) / 2 has the distribution function t^(n + 1).
    const float t = pow(u.x, 1.0 / (guide.power + 1.0));
    const float cosine = 2.0 * t - 1.0;
    const float sine = 2.0 * sqrt(max(t * (1.0 - t), 0.0));
    const float angle = 2.0 * PI * u.y;
    const vec3 direction = normalize(to_world(make_basis(guide.mean), vec3(sine * cos(angle), sine * sin(angle), cosine)));
    pdf = guide_pdf(guide, direction);
    return direction;
}

bool guide_border(Guide guide, vec2 uv, float edge) { return false; }

#ifdef GUIDE_LEARNS
/// Directions weigh by what they contribute to the square of the estimate.
void guide_learn(uint node, uint rays) {
    vec4 sums = vec4(0.0);
    const NodeRays own = rays_of(node, rays);
    for (uint i = gl_LocalInvocationID.x; i < own.count; i += LANES) {
        const uint ray = ray_samples[ray_word(own, i)];
        const float contribution = ray_sample_contribution(ray);
        const vec2 uv = (vec2(ray_sample_grid(ray)) + 0.5) / float(1u << CDQ_MAX_DEPTH);
        sums += contribution * contribution * vec4(octahedral_decode(uv), 1.0);
    }
    sums = group_sum(sums);
    if (gl_LocalInvocationID.x != 0u) return;
    const uint words = node_word(NODE_GUIDE, node);
    const float kept = guide_kept(settings, rays);
    for (uint word = 0u; word < 4u; ++word) {
        const float sum = kept * uintBitsToFloat(old_leaves[words + word]) + sums[word];
        old_leaves[words + word] = floatBitsToUint(clamp(sum, -1e37, 1e37));
    }
}
#endif

#endif
