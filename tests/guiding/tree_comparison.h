// SPDX-License-Identifier: GPL-2.0-or-later
// What the guiding passes made of a tree (tree_words.h), against what the oracle expects.
#pragma once

#include "tree_words.h"

#include <string>

namespace vigil::test {

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
                             const TreeWords& seen_old, const shader::GuidingWork& statistics);

/// Quadtrees of `bits` bits after the passes, in the nodes of the tree `old` that they started
/// from, what they remember if they do, and how many migrations were counted.
Disagreements compare_quadtrees(const TreeState& old, const AdaptedByNode& expected, uint32_t bits,
                                bool remember, const TreeWords& seen_old,
                                const shader::GuidingWork& statistics);

Disagreements compare_statistics(const TreeState& old, const AdaptedOctree& tree,
                                 const Caches& caches, const shader::GuidingWork& seen);

} // namespace vigil::test
