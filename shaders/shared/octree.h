// SPDX-License-Identifier: GPL-2.0-or-later
// The octree over surface samples (paper, section 6.1): how an inner node is packed into 4 bytes,
// how a position becomes a path from the root, and how a leaf's index follows from its node. Leaves
// hold no data here: what belongs to them lies in arrays by leaf index (guiding_types.h).
#ifndef VIGIL_SHARED_OCTREE_H
#define VIGIL_SHARED_OCTREE_H

#include "glsl.h"
#include "scene_types.h"

SHADER_BEGIN

/// Levels below the root; the grid of smallest cells has 2^OCTREE_MAX_DEPTH cells along each axis.
/// An inner node has a depth below this, so that cells in which all samples lie at one point are
/// not split for ever.
SHADER_CONST uint OCTREE_MAX_DEPTH = 16u;

/// All eight children are leaves.
SHADER_CONST uint OCTREE_ALL_LEAVES = 0xffu;

/// Bits 0..7: which children are leaves. Bits 8..31: index of the first inner child; the inner
/// children follow each other in the order of their child number, without gaps.
SHADER_FN uint octree_node(uint leaf_mask, uint first_inner) { return leaf_mask | (first_inner << 8u); }

SHADER_FN bool octree_is_leaf(uint node, uint child) { return ((node >> child) & 1u) != 0u; }

/// Index of the inner node at `child`, which must not be a leaf.
SHADER_FN uint octree_inner_child(uint node, uint child) { return (node >> 8u) + uint(bitCount(~node & ((1u << child) - 1u))); }

/// Leaves are numbered by their parent: 8 * node + child. Numbers whose child is an inner node are
/// not used.
SHADER_FN uint octree_leaf(uint node, uint child) { return 8u * node + child; }

/// The node of a leaf.
SHADER_FN uint octree_node_of(uint leaf) { return leaf >> 3u; }

/// Smallest cell along an axis, for a distance from the root's corner in smallest cells. A distance
/// that is no number counts as 0: the conversion of such a value is undefined in C++ and in GLSL.
SHADER_FN uint octree_coordinate(float cells) {
    const float last = float((1u << OCTREE_MAX_DEPTH) - 1u);
    return cells > 0.0f ? uint(min(cells, last)) : 0u;
}

/// Smallest cell that holds a position. `scale` is cells per map unit. Positions outside the root's
/// cube count as being in its outermost cells.
SHADER_FN uvec3 octree_grid(vec3 position, vec3 corner, float scale) {
    const vec3 cells = (position - corner) * scale;
    return uvec3(octree_coordinate(cells.x), octree_coordinate(cells.y), octree_coordinate(cells.z));
}

/// Which child of a node at `depth` (0: the root) holds a smallest cell: bit 0 is x, bit 1 y, bit 2
/// z.
SHADER_FN uint octree_child(uvec3 grid, uint depth) {
    const uint shift = OCTREE_MAX_DEPTH - 1u - depth;
    return ((grid.x >> shift) & 1u) | (((grid.y >> shift) & 1u) << 1u) | (((grid.z >> shift) & 1u) << 2u);
}

/// A walk from the root to the leaf that holds a smallest cell.
struct OctreeDescent {
    uint node;  // where it is
    uint depth; // of that; of the leaf once it is known
    uint leaf;  // NONE: not yet known
};

SHADER_FN OctreeDescent octree_root() {
    OctreeDescent descent;
    descent.node = 0u;
    descent.depth = 0u;
    descent.leaf = NONE;
    return descent;
}

/// One step down; `word` is the node's where the walk is. It ends above the smallest cells, whatever nodes say.
SHADER_FN void octree_descend(INOUT(OctreeDescent) descent, uint word, uvec3 grid) {
    const uint child = octree_child(grid, descent.depth);
    ++descent.depth;
    if (octree_is_leaf(word, child) || descent.depth == OCTREE_MAX_DEPTH) descent.leaf = octree_leaf(descent.node, child);
    else descent.node = octree_inner_child(word, child);
}

/// The cube of a node or leaf: its lowest corner among the smallest cells, and its depth (the
/// root's is 0).
struct OctreeCell {
    uvec3 corner;
    uint depth;
};

/// Edge of a cube at `depth`, in smallest cells.
SHADER_FN uint octree_cell_size(uint depth) { return 1u << (OCTREE_MAX_DEPTH - depth); }

/// The cube at `depth` that holds a smallest cell.
SHADER_FN OctreeCell octree_cell(uvec3 grid, uint depth) {
    OctreeCell cell;
    cell.corner = grid & uvec3(0u - octree_cell_size(depth));
    cell.depth = depth;
    return cell;
}

SHADER_FN OctreeCell octree_child_cell(OctreeCell cell, uint child) {
    const uint size = octree_cell_size(cell.depth + 1u);
    OctreeCell inner;
    inner.corner = cell.corner + size * uvec3(child & 1u, (child >> 1u) & 1u, child >> 2u);
    inner.depth = cell.depth + 1u;
    return inner;
}

/// Two words: 16 bits per coordinate and 5 for the depth.
SHADER_FN uvec2 octree_pack_cell(OctreeCell cell) {
    return uvec2(cell.corner.x | (cell.corner.y << 16u), cell.corner.z | (cell.depth << 16u));
}

SHADER_FN OctreeCell octree_unpack_cell(uvec2 words) {
    OctreeCell cell;
    cell.corner = uvec3(words.x & 0xffffu, words.x >> 16u, words.y & 0xffffu);
    cell.depth = words.y >> 16u;
    return cell;
}

SHADER_END
#endif
