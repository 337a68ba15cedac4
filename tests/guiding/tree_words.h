// SPDX-License-Identifier: GPL-2.0-or-later
// A tree as the guiding passes store it (octree.h, guiding_types.h): made from a tree of paths to
// start a frame with, and read after it. Everything that the passes have no business to read is
// filled with garbage.
#pragma once

#include "random_trees.h"
#include "vlc_oracle.h"

#include <optional>
#include <span>

namespace vigil::test {

/// The contents of Guiding::Tree's buffers.
struct TreeWords {
    std::vector<uint32_t> nodes; // number of nodes, then the nodes
    std::vector<uint32_t> cells;
    std::vector<uint32_t> leaves;

    /// `sums`: with those that quadtrees remember.
    static TreeWords sized(uint32_t node_capacity, bool sums);
    /// Word `i` of those that `array` has for a leaf.
    uint32_t& at(const shader::LeafArray& array, uint32_t leaf, uint32_t i = 0);
    uint32_t at(const shader::LeafArray& array, uint32_t leaf, uint32_t i = 0) const;
    /// The same for an inner node.
    uint32_t& at(const shader::NodeArray& array, uint32_t node, uint32_t i = 0);
    uint32_t at(const shader::NodeArray& array, uint32_t node, uint32_t i = 0) const;

private:
    uint32_t node_capacity() const;
};

/// Numbers of inner nodes and leaves, breadth-first.
class Numbering {
public:
    explicit Numbering(const InnerNodes& inner);
    uint32_t node(const Path& node) const { return nodes_.at(node); }
    uint32_t leaf(const Path& leaf) const;

private:
    ByPath<uint32_t> nodes_;
};

TreeWords encode(const TreeState& state, uint32_t node_capacity, Dice& garbage);

// What the words of a tree say.

/// Bit i: child i of an inner node is a leaf.
uint32_t leaf_mask(const InnerNodes& inner, const Path& node);
/// The first inner child; nothing if all children are leaves.
std::optional<Path> first_inner_child(const InnerNodes& inner, const Path& node);
/// The leaf beyond a face, or NONE.
uint32_t neighbour_number(const InnerNodes& inner, const Numbering& numbers, const Path& leaf,
                          int face);
glm::uvec4 quadtree_at(const TreeWords& words, uint32_t octree_node);
ShareState shared_at(const TreeWords& words, uint32_t octree_node);
/// What the leaves of a quadtree remember, as stored.
Sums sums_at(const TreeWords& words, uint32_t octree_node, const Squares& inner);
/// How the buckets of a cache are drawn: two words for each of them from `words` on.
BucketDraws drawn_at(std::span<const uint32_t> words);
Explored explored_at(const TreeWords& words, uint32_t leaf);

/// The tree after the passes, before samples are placed in it. `caches` are those of the tree
/// before, `lights` is the buffer of all caches, of buckets of `bucket` lights.
TreeState state_after(const AdaptedOctree& tree, const Caches& caches, const TreeWords& seen,
                      std::vector<uint32_t> samples, std::vector<uint32_t> lights, uint32_t bucket);
/// The same for the quadtrees of its nodes, of `bits` bits each, and what they remember if they
/// do; `rays` is the buffer of ray samples.
void take_quadtrees(TreeState& state, const TreeWords& seen, uint32_t bits, bool remember,
                    std::vector<uint32_t> rays);

} // namespace vigil::test
