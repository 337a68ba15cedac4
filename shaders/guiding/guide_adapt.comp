#version 460
// SPDX-License-Identifier: GPL-2.0-or-later
// Pass `guide_adapt`: one work group, of one subgroup, per old leaf with samples. The leaf's guider learns from the rays
// that brought light. Compiled once per guider.
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#extension GL_KHR_shader_subgroup_ballot : require
#include "shared/extensions.glsl"
#include "guiding/passes.glsl"

layout(local_size_x_id = CONSTANT_GROUP_SIZE) in;
layout(constant_id = CONSTANT_GUIDER_SIZE) const uint GUIDER_SIZE = 0u;
const uint LANES = gl_WorkGroupSize.x;

/// Rays that an octree leaf has stored.
uint stored_rays(uint leaf) { return min(old_leaves[leaf_word(LEAF_RAYS, leaf)], old_leaves[leaf_word(LEAF_STORAGE, leaf) + 1u]); }

#define GUIDE_LEARNS
#include "guiding/guider.glsl"

void main() {
    const uint leaf = leaf_lists[gl_WorkGroupID.x];
    const uint rays = stored_rays(leaf);
    if (rays > 0u) guide_learn(leaf, rays);
}
