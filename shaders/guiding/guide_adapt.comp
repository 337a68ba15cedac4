#version 460
// SPDX-License-Identifier: GPL-2.0-or-later
// Pass `guide_adapt`: one work group per old node whose leaves sent rays. Its guider learns from them, how large a
// part of the rays it should draw, and with pt_tail how much light they bring. Compiled once per guider.
#extension GL_GOOGLE_include_directive : require
#include "shared/extensions.glsl"
#include "guiding/passes.glsl"

layout(local_size_x_id = CONSTANT_GROUP_SIZE) in;
layout(constant_id = CONSTANT_GUIDER_SIZE) const uint GUIDER_SIZE = 0u;
const uint LANES = gl_WorkGroupSize.x;

const uint MOST_LANES = 128u;
shared vec4 lane_values[MOST_LANES];

/// The sum of a value over all invocations, in their order.
vec4 group_sum(vec4 value) {
    lane_values[gl_LocalInvocationID.x] = value;
    barrier();
    vec4 sum = vec4(0.0);
    for (uint lane = 0u; lane < LANES; ++lane) sum += lane_values[lane];
    barrier();
    return sum;
}

/// The rays of a node that its guider looks at: of very many some, evenly.
struct NodeRays {
    uint first; // stored one
    uint stored;
    uint count;
};

uint stored_rays(uint node) { return min(old_node_rays(node).x, old_leaves[node_word(NODE_RAY_STORAGE, node) + 1u]); }

/// Those of a node that has `rays` > 0, blank ones among them.
NodeRays rays_of(uint node, uint rays) {
    const uint stored = stored_rays(node);
    return NodeRays(old_leaves[node_word(NODE_RAY_STORAGE, node)], stored, stored / guide_stride(rays));
}

/// First word of one of them.
uint ray_word(NodeRays rays, uint i) { return RAY_SAMPLE_WORDS * (rays.first + spread_place(i, rays.stored, rays.count)); }

/// Part of a node's rays that its guider drew.
float guided_share(uint node) { return share_of(load_share(node), settings.first_share); }

#define GUIDE_LEARNS
#include "guiding/guider.glsl"

void add_spread(uint kind, float moment, float rays) {
    const float value = sqrt(moment) * sqrt(rays);
    uint seen = work.spreads[kind];
    for (;;) {
        const uint before = atomicCompSwap(work.spreads[kind], seen, floatBitsToUint(uintBitsToFloat(seen) + value));
        if (before == seen) return;
        seen = before;
    }
}

/// How well the BRDF and the guider drew a node's rays, of which there are `rays` > 0.
void learn_share(uint node, uint rays) {
    vec3 sums = vec3(0.0); // of the BRDF, of the guider; and of what rays of the BRDF alone would have
    const float used = guided_share(node);
    const NodeRays own = rays_of(node, rays);
    for (uint i = gl_LocalInvocationID.x; i < own.count; i += LANES) {
        const uint word = ray_samples[ray_word(own, i) + 1u];
        const float part = unpack_sum(word, 1u);
        sums += unpack_sum(word, 0u) * vec3(1.0 - part, part, (1.0 - used) / max(1.0 - part, 1e-3));
    }
    sums = min(group_sum(vec4(sums, 0.0)).xyz, EXPLORE_LARGEST_SUM);
    if (gl_LocalInvocationID.x != 0u) return;
    add_spread(GUIDE_SPREAD_PLAIN, sums.z, float(rays));
    add_spread(GUIDE_SPREAD_GUIDED, sums.x + sums.y, float(rays));
    const uvec2 memory =
        share_pack(share_update(load_share(node), guide_kept(settings, rays), float(rays), sums.x, sums.y, settings.first_share));
    const uint words = node_word(NODE_SHARE, node);
    old_leaves[words] = memory.x;
    old_leaves[words + 1u] = memory.y;
}

/// What the surfaces of a node with `rays` > 0 rays reflect of indirect light.
void learn_tail(uint node, uint rays) {
    float sum = 0.0;
    const NodeRays own = rays_of(node, rays);
    for (uint i = gl_LocalInvocationID.x; i < own.count; i += LANES) sum += sqrt(unpack_sum(ray_samples[ray_word(own, i) + 1u], 0u));
    sum = group_sum(vec4(sum, 0.0, 0.0, 0.0)).x;
    if (gl_LocalInvocationID.x != 0u) return;
    // Those without room count as those that are stored.
    const vec2 counts = vec2(old_node_rays(node));
    if (own.count == 0u && counts.x > 0.0) return;
    const float mean = sum / float(max(own.count, 1u)) * counts.x / (counts.x + counts.y);
    const uint words = node_word(NODE_TAIL, node);
    const uvec2 memory = tail_pack(tail_update(tail_unpack(uvec2(old_leaves[words], old_leaves[words + 1u])), float(rays), mean));
    old_leaves[words] = memory.x;
    old_leaves[words + 1u] = memory.y;
}

void main() {
    const uint node = lists[guide_entry(gl_WorkGroupID.x)];
    const uint rays = stored_rays(node) + old_node_rays(node).y;
    if (rays == 0u) return;
    guide_learn(node, rays);
    if (settings.adapt_share != 0u) learn_share(node, rays);
    if (settings.tail != 0u) learn_tail(node, rays);
}
