// SPDX-License-Identifier: GPL-2.0-or-later
// Nodes of the Light Hierarchy and what their children may add to a surface: the tree of Conty
// Estevez and Kulla, "Importance Sampling of Many Lights with Adaptive Tree Splitting", 2018, with
// the importance of Moreau and Clarberg, "Importance Sampling of Many Lights on the GPU", 2019
// (energy, distance, orientation cone, surface normal), compressed in the manner of Ylitie et al.
// 2017. Four children are weighed at once, without trigonometry. Building is the host's business
// (refresh/vkpt/light/light_hierarchy.h), walking light/lh.glsl's.
#ifndef VIGIL_SHARED_LIGHT_HIERARCHY_H
#define VIGIL_SHARED_LIGHT_HIERARCHY_H

#include "glsl.h"

SHADER_BEGIN

// A node is a head and one or two groups of four children, in words of 4 x 32 bits: 4 words, 64
// bytes, for up to four children, else 8 words, 128 bytes, of which the last is unused. A group has
// one byte of each number for each of its children.
//   head     x y z: lower corner of the box around all children; w: exponents of the three
//            quantisation steps (a byte each), and a byte with one bit for each inner child
//   group, word 0  middles of the children's boxes x, y, z in steps from the corner;
//                  their half extents x in half steps
//          word 1  half extents y, z; cone axes x, y in 1 / 127, signed
//          word 2  cone axes z; largest distance of a normal from the axis in 1 / 127;
//                  energies, see below; number of the first inner child, after which the
//                  others follow (of the whole node, in group 0)

/// What all nodes of a hierarchy have in common.
struct LightHierarchyHeader {
    uint groups;      // of four children in a node: 1 or 2
    uint leaf_size;   // room for lights in a leaf
    uint light_count; // lights that have a place; 0: the hierarchy has no nodes
    uint node_count;
};

/// Words of 16 bytes from node to node.
SHADER_FN uint light_node_stride(uint groups) { return 4u * groups; }

/// Head of a node.
struct LightNode {
    vec3 origin;
    vec3 step;  // powers of two, map units
    uint inner; // bit i: child i is an inner node
};

SHADER_FN LightNode light_node(uvec4 head) {
    LightNode node;
    node.origin = uintBitsToFloat(uvec3(head.x, head.y, head.z));
    node.step = uintBitsToFloat((uvec3(head.w, head.w >> 8u, head.w >> 16u) & uvec3(255u)) << 23u);
    node.inner = head.w >> 24u;
    return node;
}

/// The four bytes of a word as numbers.
SHADER_FN vec4 light_node_bytes(uint word) {
    // Signed conversion is one instruction on CPUs, unsigned is several.
    return vec4(ivec4((uvec4(word) >> uvec4(0u, 8u, 16u, 24u)) & uvec4(255u)));
}
SHADER_FN vec4 light_node_signed_bytes(uint word) { return vec4(ivec4(uvec4(word) << uvec4(24u, 16u, 8u, 0u)) >> 24); }

/// Energies are relative to the largest of a node: 6 bits exponent (from 2^-63 to 1) and 2 bits
/// mantissa, of the energy + 2^-63. Off by at most 1/8 from 2^-60 on; 0: there is no such child.
SHADER_FN vec4 light_node_energies(uint word) {
    uvec4 codes = (uvec4(word) >> uvec4(0u, 8u, 16u, 24u)) & uvec4(255u);
    return uintBitsToFloat((codes << 21u) + uvec4(64u << 23u)) - uintBitsToFloat(64u << 23u);
}

/// What rounding may do to a signed distance, as a part of the coordinates: 6e-8 in each of a
/// handful of operations, here and where importance decides whether a light faces a surface; and
/// the angle of 2e-7 that cones leave out.
SHADER_CONST float LIGHT_NODE_SLACK = 1e-6f;
/// Least squared distance, and least importance per energy of a child that may contribute: no
/// quotient of what follows overflows, and no product vanishes. Distances are parts of the farthest
/// in the node.
SHADER_CONST float LIGHT_NODE_NEAREST = 1e-8f;
SHADER_CONST float LIGHT_NODE_LEAST = 1e-15f;

/// A mean of max(x, 0) over x in middle - reach .. middle + reach, times 4 * reach where 0 is in
/// that interval; light_mean_divisor is what it has to be divided by.
SHADER_FN vec4 light_mean_dividend(vec4 middle, vec4 reach) {
    vec4 top = max(middle + reach, vec4(0.0f));
    return mix(top * top, middle, greaterThanEqual(middle, reach));
}
SHADER_FN vec4 light_mean_divisor(vec4 middle, vec4 reach) {
    return mix(4.0f * max(reach, vec4(1e-7f)), vec4(1.0f), greaterThanEqual(middle, reach));
}

/// What each of four children may add to a surface, in a unit of the node's; in [0, 1e31]. Zero
/// only for children that do not exist, lie wholly below the horizon of the surface or wholly face
/// away from it.
///   energy * mean cosine at the surface * mean cosine at the lights / mean squared distance
/// with means over the child's box and cone of normals, as if they were filled evenly (the cone's
/// by rule of thumb). Conservative: what is cut off are boxes below the horizon, exactly, and boxes
/// from which no normal of the cone sees the surface (exactly where all normals are equal).
SHADER_FN vec4 light_group_importance(LightNode node, uvec4 word0, uvec4 word1, uvec4 word2, vec3 position, vec3 normal) {
    // Boxes as seen from the surface: middle and half extent, as parts of the farthest coordinates.
    vec3 offset = node.origin - position;
    vec3 step = node.step;
    float unit = 1.0f / (abs(offset.x) + abs(offset.y) + abs(offset.z) + 255.0f * (step.x + step.y + step.z));
    offset *= unit;
    step *= unit;
    vec4 x = light_node_bytes(word0.x) * step.x + offset.x;
    vec4 y = light_node_bytes(word0.y) * step.y + offset.y;
    vec4 z = light_node_bytes(word0.z) * step.z + offset.z;
    vec4 size_x = light_node_bytes(word0.w) * (0.5f * step.x);
    vec4 size_y = light_node_bytes(word1.x) * (0.5f * step.y);
    vec4 size_z = light_node_bytes(word1.y) * (0.5f * step.z);
    vec4 squared = x * x + y * y + z * z + (size_x * size_x + size_y * size_y + size_z * size_z) * (1.0f / 3.0f);
    squared = max(squared, vec4(LIGHT_NODE_NEAREST));

    // The surface: heights above its horizon.
    vec4 height = normal.x * x + normal.y * y + normal.z * z;
    vec4 height_reach = abs(normal.x) * size_x + abs(normal.y) * size_y + abs(normal.z) * size_z;

    // The lights: distance in front of the plane across the cone's axis.
    vec4 axis_x = light_node_signed_bytes(word1.z);
    vec4 axis_y = light_node_signed_bytes(word1.w);
    vec4 axis_z = light_node_signed_bytes(word2.x);
    vec4 facing = (axis_x * x + axis_y * y + axis_z * z) * (-1.0f / 127.0f);
    vec4 facing_reach = (abs(axis_x) * size_x + abs(axis_y) * size_y + abs(axis_z) * size_z) * (1.0f / 127.0f);
    // No normal of the cone turns more than its distance from the axis towards the surface, for a
    // point at distance 1; no point of the box is farther than this.
    vec4 spread = light_node_bytes(word2.y) * (1.0f / 127.0f);
    vec4 farthest = abs(x) + abs(y) + abs(z) + size_x + size_y + size_z;
    vec4 turned = spread * farthest;
    vec4 visible = min(height + height_reach, facing + facing_reach + turned);

    // The mean normal of an evenly filled cone has this part of the length.
    vec4 mean = facing * (1.0f - 0.25f * spread * spread);
    vec4 mean_reach = facing_reach + 0.4f * turned;
    vec4 per_energy = light_mean_dividend(height, height_reach) * light_mean_dividend(mean, mean_reach) /
                      (light_mean_divisor(height, height_reach) * light_mean_divisor(mean, mean_reach) * (squared * squared));
    return mix(vec4(0.0f), light_node_energies(word2.z) * max(per_energy, vec4(LIGHT_NODE_LEAST)),
               greaterThan(visible, vec4(-LIGHT_NODE_SLACK)));
}

/// No child that may contribute is weighed as less than this part of its node's largest: importance
/// is an estimate, and what it all but excludes would be very bright when drawn. Costs other
/// children at most 0.2% of their share.
SHADER_CONST float LIGHT_NODE_DEFENSIVE = 1.0f / 4096.0f;

/// Weights by which children are drawn; those of group 1 are 0 if there is none.
struct LightNodeWeights {
    vec4 group0;
    vec4 group1;
};

SHADER_FN LightNodeWeights light_node_weights(vec4 importance0, vec4 importance1) {
    vec4 both = max(importance0, importance1);
    float least = LIGHT_NODE_DEFENSIVE * max(max(both.x, both.y), max(both.z, both.w));
    LightNodeWeights weights;
    weights.group0 = mix(vec4(0.0f), max(importance0, vec4(least)), greaterThan(importance0, vec4(0.0f)));
    weights.group1 = mix(vec4(0.0f), max(importance1, vec4(least)), greaterThan(importance1, vec4(0.0f)));
    return weights;
}

SHADER_FN float light_node_sum(LightNodeWeights weights) {
    vec4 first = weights.group0;
    vec4 second = weights.group1;
    return ((first.x + first.y) + (first.z + first.w)) + ((second.x + second.y) + (second.z + second.w));
}

SHADER_FN float light_node_weight(LightNodeWeights weights, uint child) {
    return child < 4u ? weights.group0[child] : weights.group1[child - 4u];
}

/// A child drawn in proportion to the weights.
struct LightNodeChoice {
    uint child;
    float weight; // its own
    float below;  // sum of the weights before it
};

SHADER_FN void light_node_pass(INOUT(LightNodeChoice) choice, uint child, float weight, float below, float target) {
    if (weight > 0.0f && below <= target) {
        choice.child = child;
        choice.weight = weight;
        choice.below = below;
    }
}

/// `target` is a random number in [0, 1) times the sum of the weights, which is positive. Never
/// draws a child of weight 0, whatever the rounding.
SHADER_FN LightNodeChoice light_node_choose(LightNodeWeights weights, float target) {
    vec4 first = weights.group0;
    float sum = (first.x + first.y) + (first.z + first.w);
    vec4 second = weights.group1;
    bool in_second = sum <= target && max(max(second.x, second.y), max(second.z, second.w)) > 0.0f;
    vec4 group = in_second ? second : first;
    float below = in_second ? sum : 0.0f;
    LightNodeChoice choice;
    choice.child = 0u;
    choice.weight = 0.0f;
    choice.below = 0.0f;
    light_node_pass(choice, 0u, group.x, below, target);
    below += group.x;
    light_node_pass(choice, 1u, group.y, below, target);
    below += group.y;
    light_node_pass(choice, 2u, group.z, below, target);
    below += group.z;
    light_node_pass(choice, 3u, group.w, below, target);
    choice.child += in_second ? 4u : 0u;
    return choice;
}

SHADER_END
#endif
