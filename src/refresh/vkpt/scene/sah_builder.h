// SPDX-License-Identifier: GPL-2.0-or-later
// The binary hierarchy that both levels start from: binned surface area heuristic (Wald 2007) over
// boxes. It knows boxes only; triangles, node formats and instances are its callers' business.
#pragma once

#include "refresh/vkpt/scene/bounds.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace vigil {

/// What is being sorted into the tree: a box and the item it stands for.
struct SahItem {
    Bounds bounds;
    std::uint32_t index = 0;
};

/// A node: inner when it has two children, else a leaf of items [first, first + count).
struct SahNode {
    Bounds bounds;
    std::uint32_t first = 0;
    std::uint32_t count = 0;
    std::unique_ptr<SahNode> child[2];

    bool leaf() const { return child[0] == nullptr; }
};

struct SahOptions {
    std::uint32_t max_leaf = 4;  // items in a leaf, at least 1
    float traversal_cost = 1.0f; // of one inner node, in item tests
    bool threads = true;         // build the two halves of big trees at the same time
};

/// Builds the tree over `items`, which must not be empty, and reorders them so that every leaf is a
/// range. No path is longer than SAH_MAX_DEPTH nodes.
std::unique_ptr<SahNode> build_sah(std::vector<SahItem>& items, const SahOptions& options);

/// Below SAH_SPLIT_DEPTH the heuristic decides; deeper, halving by count bounds the rest by log2 of
/// the count.
inline constexpr std::uint32_t SAH_SPLIT_DEPTH = 32;
inline constexpr std::uint32_t SAH_MAX_DEPTH = SAH_SPLIT_DEPTH + 31;

} // namespace vigil
