// SPDX-License-Identifier: GPL-2.0-or-later
// The octree passes as the paper describes them (sections 6.1 and 6.2), for tests: a tree is the
// set of its inner nodes' paths, a leaf is a path whose parent is in the set. Written for the
// reader: it knows nothing of packed nodes, work groups or buffers, and shares no code with the
// passes it judges.
#pragma once

#include <glm/vec3.hpp>

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace vigil::test {

/// Child numbers '0' .. '7' from the root, whose path is empty: "07" is child 7 of the root's child
/// 0. Bit 0 of a child number is x, bit 1 y, bit 2 z.
using Path = std::string;

/// Level by level; within a level in the order of the parents and then of the child numbers.
struct BreadthFirst {
    bool operator()(const Path& a, const Path& b) const {
        return a.size() != b.size() ? a.size() < b.size() : a < b;
    }
};
/// Inner nodes. The root is always one, and with a node come all nodes above it.
using InnerNodes = std::set<Path, BreadthFirst>;
template <typename T> using ByPath = std::map<Path, T, BreadthFirst>;

/// A cube of smallest cells: those with lowest <= cell < lowest + size in every coordinate.
struct Cube {
    glm::ivec3 lowest;
    int size;
    bool holds(glm::ivec3 cell) const;
};
Cube cube_of(const Path& path);

Path child_of(const Path& path, int child);

/// In the order of (parent, child number), which is the order of their indices.
std::vector<Path> leaves_of(const InnerNodes& inner);

/// The leaf that holds a smallest cell, found by looking at cubes; nothing outside of the root.
std::optional<Path> leaf_with(const InnerNodes& inner, glm::ivec3 cell);

/// The leaf beyond the centre of a leaf's face (-x +x -y +y -z +z); nothing beyond the root's
/// faces.
std::optional<Path> neighbour_of(const InnerNodes& inner, const Path& leaf, int face);

struct OctreeLimits {
    uint32_t split;    // a leaf with more samples is split
    uint32_t collapse; // an inner node of eight leaves with fewer samples together is collapsed
    uint32_t node_capacity; // inner nodes that a tree may have
    uint32_t max_depth;     // every inner node is above this depth
};

/// What mark, rebuild and populate make of a tree.
struct AdaptedOctree {
    InnerNodes inner;
    ByPath<Path> source; // for every leaf the old leaf from which it takes what belongs to it
    uint32_t splits = 0; // those that were carried out
    uint32_t splits_refused = 0;
    uint32_t collapses = 0;
};

/// `counts`: samples in each leaf of the old tree.
AdaptedOctree adapt(const InnerNodes& inner, const ByPath<uint32_t>& counts,
                    const OctreeLimits& limits);

} // namespace vigil::test
