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
// bytes, for up to four children, else 8 words, 128 bytes, of which the last is unused.
//   head     x y z: lower corner of the box around all children; w: exponents of the three
//            quantisation steps (a byte each), and a byte with one bit for each inner child
//   group, word 0  lower bounds x, y, z and upper bounds x of the children in steps, a byte each
//          word 1  upper bounds y, z; cone axes on the octahedron: x, y in 1 / 127 above -127
//          word 2  sine of half the cones' angle in 1 / 255; energies (two words of two);
//                  number of the first inner child (group 0 only): inner children follow each other

/// What all nodes of a hierarchy have in common.
struct LightHierarchyHeader {
    uint groups;      // of four children in a node: 1 or 2
    uint leaf_size;   // room for lights in a leaf
    uint light_count; // lights that have a place; 0: the hierarchy has no nodes
    uint node_count;
};

SHADER_CONST uint LIGHT_NODE_GROUP_WORDS = 3u;
/// Words of 16 bytes from node to node.
SHADER_FN uint light_node_stride(uint groups) {
    return 4u * groups;
}

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

/// Energies are relative to the largest of a node: 6 bits exponent (2^-63 to 1), 10 bits mantissa;
/// 0: there is no such child.
SHADER_FN vec4 light_node_energies(uvec4 codes) {
    return mix(uintBitsToFloat((codes << 13u) + uvec4(64u << 23u)), vec4(0.0f),
               equal(codes, uvec4(0u)));
}

/// Mean of max(x, 0) over x in middle - reach .. middle + reach. Positive if any such x is; reach
/// is at least 0.
SHADER_FN vec4 mean_above_zero(vec4 middle, vec4 reach) {
    vec4 top = max(middle + reach, vec4(0.0f));
    vec4 cut = top * top / max(4.0f * reach, vec4(1e-20f));
    return mix(cut, middle, greaterThanEqual(middle, reach));
}

/// What rounding may do to a signed distance, as a part of the coordinates: 6e-8 in each of a
/// handful of operations, here and where importance decides whether a light faces a surface; and
/// the angle of 2e-7 that cones leave out.
SHADER_CONST float LIGHT_NODE_SLACK = 1e-6f;
/// Least importance of a child that may contribute: far above where floats vanish, far below what
/// any energy (from 2^-63) over any squared distance in a level (to 2^40) gives.
SHADER_CONST float LIGHT_NODE_LEAST = 1e-33f;

/// What each of four children may add to a surface, in the unit of the node's largest energy over
/// squared map units; in [0, 2e6]. Zero only for children that do not exist, lie wholly below the
/// horizon of the surface or wholly face away from it.
///   energy * mean cosine at the surface * mean cosine at the lights / mean squared distance
/// with means over the child's box and cone of normals, as if they were filled evenly.
/// Conservative: what is cut off are boxes below the horizon, exactly, and boxes from which no
/// normal of the cone sees the surface (exactly where all normals are equal).
SHADER_FN vec4 light_group_importance(LightNode node, uvec4 word0, uvec4 word1, uvec4 word2,
                                      vec3 position, vec3 normal) {
    // Boxes as seen from the surface: middle and half extent.
    vec3 offset = node.origin - position;
    vec3 half_step = 0.5f * node.step;
    vec4 lower_x = light_node_bytes(word0.x);
    vec4 lower_y = light_node_bytes(word0.y);
    vec4 lower_z = light_node_bytes(word0.z);
    vec4 upper_x = light_node_bytes(word0.w);
    vec4 upper_y = light_node_bytes(word1.x);
    vec4 upper_z = light_node_bytes(word1.y);
    vec4 x = (lower_x + upper_x) * half_step.x + offset.x;
    vec4 y = (lower_y + upper_y) * half_step.y + offset.y;
    vec4 z = (lower_z + upper_z) * half_step.z + offset.z;
    vec4 size_x = (upper_x - lower_x) * half_step.x;
    vec4 size_y = (upper_y - lower_y) * half_step.y;
    vec4 size_z = (upper_z - lower_z) * half_step.z;
    vec4 squared = x * x + y * y + z * z +
                   (size_x * size_x + size_y * size_y + size_z * size_z) * (1.0f / 3.0f);
    vec4 inverse = inversesqrt(max(squared, vec4(1e-6f)));
    float slack = LIGHT_NODE_SLACK * (abs(offset.x) + abs(offset.y) + abs(offset.z) +
                                      255.0f * (node.step.x + node.step.y + node.step.z));

    // The surface: heights above its horizon.
    vec3 extent = abs(normal);
    vec4 height = normal.x * x + normal.y * y + normal.z * z;
    vec4 height_reach = extent.x * size_x + extent.y * size_y + extent.z * size_z;

    // The lights: distance in front of the plane across the cone's axis.
    vec4 axis_x = (light_node_bytes(word1.z) - 127.0f) * (1.0f / 127.0f);
    vec4 axis_y = (light_node_bytes(word1.w) - 127.0f) * (1.0f / 127.0f);
    vec4 axis_z = 1.0f - abs(axis_x) - abs(axis_y);
    vec4 fold = max(-axis_z, vec4(0.0f));
    axis_x -= fold * sign(axis_x);
    axis_y -= fold * sign(axis_y);
    vec4 shorten = inversesqrt(axis_x * axis_x + axis_y * axis_y + axis_z * axis_z);
    vec4 facing = -shorten * (axis_x * x + axis_y * y + axis_z * z);
    vec4 facing_reach =
        shorten * (abs(axis_x) * size_x + abs(axis_y) * size_y + abs(axis_z) * size_z);

    // The cone of normals: cosine and sine of its half angle, and the length of their mean.
    vec4 half_sine = light_node_bytes(word2.x) * (1.0f / 255.0f);
    vec4 mean_length = 1.0f - half_sine * half_sine;
    vec4 cone_cosine = 2.0f * mean_length - 1.0f;
    vec4 cone_sine = 2.0f * half_sine * sqrt(mean_length);

    // No point of the box is farther than this; no normal of the cone turns more than its sine of
    // it towards the surface.
    vec4 farthest = abs(x) + abs(y) + abs(z) + size_x + size_y + size_z;
    vec4 turned = mix(cone_sine, vec4(2.0f), lessThan(cone_cosine, vec4(0.01f))) * farthest;
    bvec4 above = greaterThan(height + height_reach, vec4(-slack));
    bvec4 towards = greaterThan(facing + facing_reach + turned, vec4(-slack));

    vec4 cosine = clamp(facing * inverse, vec4(-1.0f), vec4(1.0f));
    vec4 sine = sqrt(max(1.0f - cosine * cosine, vec4(0.0f)));
    // Of the normal that is turned most towards the surface.
    vec4 best = mix(cosine * cone_cosine + sine * cone_sine, vec4(1.0f),
                    greaterThanEqual(cosine, cone_cosine));
    vec4 mean = cosine * mean_length;
    vec4 light_cosine =
        mean_above_zero(mean, max(best - mean, vec4(0.0f)) + facing_reach * inverse);
    vec4 surface_cosine = mean_above_zero(height * inverse, height_reach * inverse);

    vec4 energies = light_node_energies(
        uvec4(word2.y & 0xffffu, word2.y >> 16u, word2.z & 0xffffu, word2.z >> 16u));
    vec4 importance = energies * surface_cosine * light_cosine * inverse * inverse;
    importance = max(importance, vec4(LIGHT_NODE_LEAST));
    importance = mix(vec4(0.0f), importance, above);
    importance = mix(vec4(0.0f), importance, towards);
    return mix(vec4(0.0f), importance, greaterThan(energies, vec4(0.0f)));
}

/// No child that may contribute is weighed as less than this part of its node's largest: importance
/// is an estimate, and what it all but excludes would be very bright when drawn. Costs other
/// children at most 0.2% of their share.
SHADER_CONST float LIGHT_NODE_DEFENSIVE = 1.0f / 4096.0f;

/// Weights by which children are drawn.
struct LightNodeWeights {
    vec4 group0;
    vec4 group1;
};

SHADER_FN LightNodeWeights light_node_weights(vec4 importance0, vec4 importance1) {
    vec4 both = max(importance0, importance1);
    float least = LIGHT_NODE_DEFENSIVE * max(max(both.x, both.y), max(both.z, both.w));
    LightNodeWeights weights;
    weights.group0 =
        mix(vec4(0.0f), max(importance0, vec4(least)), greaterThan(importance0, vec4(0.0f)));
    weights.group1 =
        mix(vec4(0.0f), max(importance1, vec4(least)), greaterThan(importance1, vec4(0.0f)));
    return weights;
}

SHADER_FN float light_node_sum(LightNodeWeights weights) {
    vec4 both = weights.group0 + weights.group1;
    return (both.x + both.y) + (both.z + both.w);
}

SHADER_FN float light_node_weight(LightNodeWeights weights, uint child) {
    return child < 4u ? weights.group0[child] : weights.group1[child - 4u];
}

/// A child drawn in proportion to the weights.
struct LightNodeChoice {
    uint child;
    float weight; // its own
    float below;  // sum of the weights before it
    float passed; // sum of the weights seen so far
};

SHADER_FN void light_node_pass(INOUT(LightNodeChoice) choice, uint child, float weight,
                               float target) {
    if (weight > 0.0f && choice.passed <= target) {
        choice.child = child;
        choice.weight = weight;
        choice.below = choice.passed;
    }
    choice.passed += weight;
}

/// `target` is a random number in [0, 1) times the sum of the weights, which is positive. Never
/// draws a child of weight 0, whatever the rounding.
SHADER_FN LightNodeChoice light_node_choose(LightNodeWeights weights, float target) {
    LightNodeChoice choice;
    choice.child = 0u;
    choice.weight = 0.0f;
    choice.below = 0.0f;
    choice.passed = 0.0f;
    light_node_pass(choice, 0u, weights.group0.x, target);
    light_node_pass(choice, 1u, weights.group0.y, target);
    light_node_pass(choice, 2u, weights.group0.z, target);
    light_node_pass(choice, 3u, weights.group0.w, target);
    light_node_pass(choice, 4u, weights.group1.x, target);
    light_node_pass(choice, 5u, weights.group1.y, target);
    light_node_pass(choice, 6u, weights.group1.z, target);
    light_node_pass(choice, 7u, weights.group1.w, target);
    return choice;
}

SHADER_END
#endif
