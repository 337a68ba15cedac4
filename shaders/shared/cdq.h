// SPDX-License-Identifier: GPL-2.0-or-later
// The Compressed Directional Quadtree (paper, section 5): a quadtree over the octahedral map as a
// bit field of 32, 64, 96 or 128 bits. One bit per node but the root, breadth-first: 1 for an inner
// node, 0 for a leaf. All leaves are drawn equally often, so a direction's density follows from the
// size of its leaf alone. Children and parents are found by counting ones (Jacobson 1989).
#ifndef VIGIL_SHARED_CDQ_H
#define VIGIL_SHARED_CDQ_H

#include "glsl.h"
#include "octahedral.h"

SHADER_BEGIN

/// Levels below the root: the smallest leaf has an edge of 2^-12 of the unit square, 4,096 times
/// what a float resolves there, and a solid angle of about 1e-6 steradian.
SHADER_CONST uint CDQ_MAX_DEPTH = 12u;
SHADER_CONST uint CDQ_MOST_BITS = 128u;

/// Leaves of every tree. `bits` is the size of the field in all functions: 32, 64, 96 or 128. Bits
/// from there on are 0.
SHADER_FN uint cdq_leaf_count(uint bits) { return 3u * bits / 4u + 1u; }

/// Inner nodes of every tree, which are the ones of its field; the root is not counted.
SHADER_FN uint cdq_inner_count(uint bits) { return bits / 4u - 1u; }

/// Ones in the bits below `end` of the word that begins at bit `first`.
SHADER_FN uint cdq_word_below(uint end, uint first) {
    return end >= first + 32u ? 0xffffffffu : end > first ? (1u << (end - first)) - 1u : 0u;
}

/// Ones in the bits below `end`, of all four words.
SHADER_FN uvec4 cdq_mask_below(uint end) {
    return uvec4(cdq_word_below(end, 0u), cdq_word_below(end, 32u), cdq_word_below(end, 64u), cdq_word_below(end, 96u));
}

/// Word 0..3 of a field: graphics cards keep what is indexed by a variable in memory.
SHADER_FN uint cdq_word(uvec4 field, uint word) {
    const uint low = (word & 1u) == 0u ? field.x : field.y;
    const uint high = (word & 1u) == 0u ? field.z : field.w;
    return word < 2u ? low : high;
}

SHADER_FN bool cdq_is_inner(uvec4 tree, uint node) { return ((cdq_word(tree, node >> 5u) >> (node & 31u)) & 1u) != 0u; }

/// Number of ones below bit `node`.
SHADER_FN uint cdq_rank(uvec4 tree, uint node) {
    const uvec4 below = tree & cdq_mask_below(node);
    return uint(bitCount(below.x) + bitCount(below.y) + bitCount(below.z) + bitCount(below.w));
}

/// Position of the one with `rank` ones below it in a word that has more than `rank` of them.
SHADER_FN uint cdq_select_in_word(uint word, uint rank) {
    uint position = 0u;
    for (uint width = 16u; width > 0u; width >>= 1u) {
        const uint ones = uint(bitCount(word & ((1u << width) - 1u)));
        if (rank >= ones) {
            rank -= ones;
            word >>= width;
            position += width;
        }
    }
    return position;
}

/// Position of the one with `rank` ones below it; the field must have more than `rank` of them.
SHADER_FN uint cdq_select(uvec4 field, uint rank) {
    // Ones up to the end of each word.
    const uint x = uint(bitCount(field.x));
    const uint y = x + uint(bitCount(field.y));
    const uint z = y + uint(bitCount(field.z));
    const uint word = rank < x ? 0u : rank < y ? 1u : rank < z ? 2u : 3u;
    const uint before = word == 0u ? 0u : word == 1u ? x : word == 2u ? y : z;
    return 32u * word + cdq_select_in_word(cdq_word(field, word), rank - before);
}

/// Child 0..3 of an inner node: bit 0 is the upper half in u, bit 1 in v.
SHADER_FN uint cdq_child(uvec4 tree, uint node, uint child) { return 4u * (cdq_rank(tree, node) + 1u) + child; }

/// Parent of a node that is not a child of the root (node >= 4).
SHADER_FN uint cdq_parent(uvec4 tree, uint node) { return cdq_select(tree, node / 4u - 1u); }

/// Leaf with number `leaf` < cdq_leaf_count(bits), in the order of their bits.
SHADER_FN uint cdq_leaf(uvec4 tree, uint bits, uint leaf) { return cdq_select(~tree & cdq_mask_below(bits), leaf); }

/// The tree whose leaves' depths differ by one level at most.
SHADER_FN uvec4 cdq_even_tree(uint bits) { return cdq_mask_below(cdq_inner_count(bits)); }

/// A node's square in the unit square, and its level (children of the root are at 1).
struct CdqCell {
    vec2 corner;
    float size;
    uint depth;
};

SHADER_FN CdqCell cdq_cell(uvec4 tree, uint node) {
    CdqCell cell;
    cell.corner = vec2(0.0f);
    cell.size = 1.0f;
    cell.depth = 0u;
    // From the leaf up: what is known so far becomes a quarter of the parent's square. All numbers
    // are exact.
    while (cell.depth < CDQ_MAX_DEPTH) {
        cell.corner = 0.5f * (cell.corner + vec2(float(node & 1u), float((node >> 1u) & 1u)));
        cell.size = 0.5f * cell.size;
        cell.depth += 1u;
        if (node < 4u) break;
        node = cdq_parent(tree, node);
    }
    return cell;
}

/// The leaf that holds a point of the unit square [0, 1)^2.
struct CdqPlace {
    uint node;
    uint depth;
};

SHADER_FN CdqPlace cdq_find(uvec4 tree, vec2 uv) {
    const uint cells = 1u << CDQ_MAX_DEPTH;
    const uvec2 grid = uvec2(uv * float(cells));
    CdqPlace place;
    place.depth = 1u;
    uint shift = CDQ_MAX_DEPTH - 1u;
    place.node = ((grid.x >> shift) & 1u) | (((grid.y >> shift) & 1u) << 1u);
    while (place.depth < CDQ_MAX_DEPTH && cdq_is_inner(tree, place.node)) {
        shift -= 1u;
        place.node = cdq_child(tree, place.node, ((grid.x >> shift) & 1u) | (((grid.y >> shift) & 1u) << 1u));
        place.depth += 1u;
    }
    return place;
}

/// Density per steradian with which a leaf at `depth` yields a direction (unit vector) in it.
SHADER_FN float cdq_leaf_pdf(uint bits, uint depth, vec3 direction) {
    const float leaves_per_square = float(1u << (2u * depth)); // 1 / area, exact
    return leaves_per_square / float(cdq_leaf_count(bits)) * octahedral_density(direction);
}

/// Density per steradian of `cdq_sample` at a direction.
SHADER_FN float cdq_pdf(uvec4 tree, uint bits, vec3 direction) {
    return cdq_leaf_pdf(bits, cdq_find(tree, octahedral_encode(direction)).depth, direction);
}

/// Draws a unit vector; `u` in [0, 1)^3 takes the leaf, then the point in it. The direction lies in
/// the leaf that cdq_find sees it in: one that rounding would carry over the border is drawn back
/// towards the centre. `pdf` is its cdq_pdf, without a search.
SHADER_FN vec3 cdq_sample(uvec4 tree, uint bits, vec3 u, OUT(float) pdf) {
    const uint leaves = cdq_leaf_count(bits);
    const uint node = cdq_leaf(tree, bits, min(uint(u.x * float(leaves)), leaves - 1u));
    const CdqCell cell = cdq_cell(tree, node);
    const vec2 uv = cell.corner + cell.size * vec2(u.y, u.z);
    vec3 direction = octahedral_decode(uv);
    const vec2 seen = octahedral_encode(direction);
    if (seen.x < cell.corner.x || seen.y < cell.corner.y || seen.x >= cell.corner.x + cell.size || seen.y >= cell.corner.y + cell.size)
        direction = octahedral_decode(cell.corner + cell.size * (0.5f + 0.99f * (vec2(u.y, u.z) - 0.5f)));
    pdf = cdq_leaf_pdf(bits, cell.depth, direction);
    return direction;
}

SHADER_FN vec3 cdq_sample(uvec4 tree, uint bits, vec3 u) {
    float pdf;
    return cdq_sample(tree, bits, u, pdf);
}

SHADER_END
#endif
