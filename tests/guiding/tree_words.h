// SPDX-License-Identifier: GPL-2.0-or-later
// A tree as the guiding passes store it (octree.h, guiding_types.h): made from a tree of paths to
// start a frame with, and compared with what the oracle expects after it. Everything that the
// passes have no business to read is filled with garbage.
#pragma once

#include "random_trees.h"
#include "vlc_oracle.h"

#include <string>

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

/// What was expected and what was seen, one line each; long lists are cut.
class Disagreements {
public:
    void add(std::string line);
    bool empty() const { return count_ == 0; }
    std::string text() const;

private:
    std::vector<std::string> lines_;
    size_t count_ = 0;
};

/// Topology, cubes, sources, neighbours and counts of a new tree. `old` is the tree that it was
/// made from.
Disagreements compare_tree(const AdaptedOctree& expected, const InnerNodes& old,
                           const TreeWords& seen);

/// Sample storage of the leaves of a tree: without overlap, inside the buffer, and enough of it.
Disagreements compare_storage(const InnerNodes& inner, const TreeWords& seen,
                              uint32_t sample_capacity);
/// The same for ray samples of the nodes, of which none has any yet.
Disagreements compare_ray_storage(const InnerNodes& inner, const TreeWords& seen,
                                  uint32_t ray_capacity);

/// Caches that were made on the old tree and handed on to the new one. `lights` is the buffer of
/// all caches.
Disagreements compare_caches(const Caches& expected, const TreeWords& seen_old,
                             const InnerNodes& old, std::span<const uint32_t> lights,
                             uint32_t bucket);
Disagreements compare_handed_on(const AdaptedOctree& expected, const Caches& caches,
                                const TreeWords& seen, const InnerNodes& old,
                                const TreeWords& seen_old);

/// The same for what guiders know: quadtrees, what they remember if they do, and shares.
Disagreements compare_guides_handed_on(const AdaptedOctree& expected, const TreeWords& seen,
                                       const InnerNodes& old, const TreeWords& seen_old,
                                       bool remember);

/// What was learned of shares, in the nodes of the tree `old` that the passes started from.
Disagreements compare_shares(const TreeState& old, const ByPath<ShareState>& expected,
                             const TreeWords& seen_old);

/// What may become of each node's quadtree.
using AdaptedByNode = ByPath<AdaptedQuadtrees>;

/// Quadtrees of `bits` bits after the passes, in the nodes of the tree `old` that they started
/// from, what they remember if they do, and how many migrations were counted.
Disagreements compare_quadtrees(const TreeState& old, const AdaptedByNode& expected, uint32_t bits,
                                bool remember, const TreeWords& seen_old,
                                const shader::GuidingWork& statistics);

Disagreements compare_statistics(const TreeState& old, const AdaptedOctree& tree,
                                 const Caches& caches, const shader::GuidingWork& seen);

/// The tree after the passes, before samples are placed in it. `caches` are those of the tree
/// before, `lights` is the buffer of all caches, of buckets of `bucket` lights.
TreeState state_after(const AdaptedOctree& tree, const Caches& caches, const TreeWords& seen,
                      std::vector<uint32_t> samples, std::vector<uint32_t> lights, uint32_t bucket);
/// The same for the quadtrees of its nodes, of `bits` bits each, and what they remember if they
/// do; `rays` is the buffer of ray samples.
void take_quadtrees(TreeState& state, const TreeWords& seen, uint32_t bits, bool remember,
                    std::vector<uint32_t> rays);

} // namespace vigil::test
