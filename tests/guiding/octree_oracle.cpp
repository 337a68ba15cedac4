// SPDX-License-Identifier: GPL-2.0-or-later
// See octree_oracle.h. Every function follows its definition word by word; none of them is fast.
#include "octree_oracle.h"

namespace vigil::test {
namespace {

constexpr int root_size = 1 << 16; // smallest cells along an edge: 16 levels

Path parent_of(const Path& path) {
    return path.substr(0, path.size() - 1);
}

bool all_children_are_leaves(const InnerNodes& inner, const Path& node) {
    for (int child = 0; child < 8; ++child)
        if (inner.contains(child_of(node, child))) return false;
    return true;
}

/// The inner nodes that become leaves.
InnerNodes collapsing(const InnerNodes& inner, const ByPath<uint32_t>& counts, uint32_t collapse) {
    InnerNodes found;
    for (const Path& node : inner) {
        if (node.empty() || !all_children_are_leaves(inner, node)) continue;
        uint64_t sum = 0;
        for (int child = 0; child < 8; ++child)
            sum += counts.at(child_of(node, child));
        if (sum < collapse) found.insert(node);
    }
    return found;
}

/// The child with most samples; the first of them if there are several.
Path most_sampled_child(const Path& node, const ByPath<uint32_t>& counts) {
    Path best = child_of(node, 0);
    for (int child = 1; child < 8; ++child)
        if (counts.at(child_of(node, child)) > counts.at(best)) best = child_of(node, child);
    return best;
}

} // namespace

bool Cube::holds(glm::ivec3 cell) const {
    for (int axis = 0; axis < 3; ++axis)
        if (cell[axis] < lowest[axis] || cell[axis] >= lowest[axis] + size) return false;
    return true;
}

Cube cube_of(const Path& path) {
    Cube cube{glm::ivec3(0), root_size};
    for (const char digit : path) {
        const int child = digit - '0';
        cube.size /= 2;
        if (child % 2 == 1) cube.lowest.x += cube.size;
        if (child / 2 % 2 == 1) cube.lowest.y += cube.size;
        if (child / 4 == 1) cube.lowest.z += cube.size;
    }
    return cube;
}

Path child_of(const Path& path, int child) {
    return path + static_cast<char>('0' + child);
}

std::vector<Path> leaves_of(const InnerNodes& inner) {
    std::vector<Path> leaves;
    for (const Path& node : inner)
        for (int child = 0; child < 8; ++child)
            if (!inner.contains(child_of(node, child))) leaves.push_back(child_of(node, child));
    return leaves;
}

std::optional<Path> leaf_with(const InnerNodes& inner, glm::ivec3 cell) {
    Path path;
    if (!cube_of(path).holds(cell)) return std::nullopt;
    while (inner.contains(path)) {
        int child = 0;
        while (!cube_of(child_of(path, child)).holds(cell))
            ++child;
        path = child_of(path, child);
    }
    return path;
}

std::optional<Path> neighbour_of(const InnerNodes& inner, const Path& leaf, int face) {
    const Cube cube = cube_of(leaf);
    const int axis = face / 2;
    const bool upper = face % 2 == 1;
    glm::ivec3 beyond = cube.lowest + cube.size / 2;
    beyond[axis] = upper ? cube.lowest[axis] + cube.size : cube.lowest[axis] - 1;
    return leaf_with(inner, beyond);
}

AdaptedOctree adapt(const InnerNodes& inner, const ByPath<uint32_t>& counts,
                    const OctreeLimits& limits) {
    AdaptedOctree result;

    // Collapse.
    const InnerNodes collapsed = collapsing(inner, counts, limits.collapse);
    result.inner = inner;
    for (const Path& node : collapsed)
        result.inner.erase(node);
    result.collapses = static_cast<uint32_t>(collapsed.size());

    // Split, until there is no room. A leaf becomes an inner node at its own depth.
    for (const Path& leaf : leaves_of(inner)) {
        if (counts.at(leaf) <= limits.split || leaf.size() >= limits.max_depth) continue;
        if (result.inner.size() < limits.node_capacity) {
            result.inner.insert(leaf);
            ++result.splits;
        } else {
            ++result.splits_refused;
        }
    }

    // What each new leaf was.
    for (const Path& leaf : leaves_of(result.inner)) {
        if (collapsed.contains(leaf)) {
            result.source[leaf] = most_sampled_child(leaf, counts);
        } else {
            result.source[leaf] = counts.contains(leaf) ? leaf : parent_of(leaf);
        }
    }
    return result;
}

} // namespace vigil::test
