// SPDX-License-Identifier: GPL-2.0-or-later
// The binary hierarchy that both levels start from: surface area heuristic, binned (Wald 2007) or,
// for few items, exact; and its best reading as a tree of wider nodes (the dynamic programme of
// Ylitie et al. 2017). It knows boxes only; triangles, node formats and instances are its callers'
// business.
#pragma once

#include "refresh/vkpt/scene/bounds.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace vigil {

/// What is being sorted into the tree: a box and the item it stands for.
struct SahItem {
    Bounds bounds;
    std::uint32_t index = 0;
};

/// A node: inner when it has two children, else a leaf of one item.
struct SahNode {
    Bounds bounds;
    std::uint32_t item = 0; // of a leaf: position in the items
    std::unique_ptr<SahNode> child[2];

    bool leaf() const { return child[0] == nullptr; }

    /// Set by plan_wide_nodes: least cost of this subtree shown as at most i + 1 nodes side by
    /// side, and how many of them the left child gets (0: one less does as well).
    std::array<float, 4> cost{};
    std::array<std::uint8_t, 4> left_share{};
};

struct SahOptions {
    std::uint32_t split_depth = 48; // deeper nodes are halved by count, which bounds the depth
    bool threads = true;            // build the two halves of big trees at the same time
};

/// Builds the tree over `items`, which must not be empty, and reorders them into depth-first order.
/// No path has more than split_depth + 32 nodes.
std::unique_ptr<SahNode> build_sah(std::vector<SahItem>& items, const SahOptions& options);

/// Decides for every node which of its descendants become its up to four children in a tree of
/// four-wide nodes, so that the expected number of visited nodes is least.
void plan_wide_nodes(SahNode& root);

/// The children of an inner node as planned: 2 to 4 of its descendants.
std::vector<const SahNode*> wide_children(const SahNode& node);

} // namespace vigil
