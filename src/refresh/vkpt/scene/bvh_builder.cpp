// SPDX-License-Identifier: GPL-2.0-or-later
// Turns the binary tree of sah_builder into the nodes of shaders/shared/bvh.h, depth first, and
// pads every box so that the traversal's arithmetic never misses a triangle that the triangle test
// would hit.
#include "refresh/vkpt/scene/bvh_builder.h"

#include "refresh/vkpt/scene/sah_builder.h"
#include "shared/bvh.h"

#include <bit>

namespace vigil {

namespace {

static_assert(SAH_MAX_DEPTH < shader::BVH_MAX_DEPTH);

/// Triangles per leaf: what the reference's 4 count bits hold is 16; 4 measured best.
constexpr std::uint32_t MAX_LEAF = 4;

/// Boxes grow by this share of the largest coordinate, a few rounding steps of the box test.
constexpr float PADDING = 4.0f / 16777216.0f;

class Encoder {
public:
    explicit Encoder(std::vector<glm::uvec4>& nodes) : nodes_(nodes) {}

    std::uint32_t encode(const SahNode& node) {
        if (node.leaf()) {
            return shader::BVH_LEAF | (node.count - 1) << shader::BVH_LEAF_COUNT_SHIFT | node.first;
        }
        const std::size_t word = add_node();
        for (int i = 0; i < 2; ++i) {
            const std::uint32_t reference = encode(*node.child[i]);
            write(word, i, node.child[i]->bounds, reference);
        }
        return static_cast<std::uint32_t>(word / shader::BVH_NODE_WORDS);
    }

    /// A root must be an inner node: a lone leaf gets one with a single child.
    void encode_root(const SahNode& root) {
        if (!root.leaf()) {
            encode(root);
            return;
        }
        const std::size_t word = add_node();
        write(word, 0, root.bounds, encode(root));
    }

    /// A node with no children.
    std::size_t add_node() {
        const std::size_t word = nodes_.size();
        nodes_.resize(word + shader::BVH_NODE_WORDS);
        for (int i = 0; i < 2; ++i) {
            const std::uint32_t one = std::bit_cast<std::uint32_t>(1.0f);
            const std::uint32_t minus_one = std::bit_cast<std::uint32_t>(-1.0f);
            nodes_[word + 2 * i] = glm::uvec4(one, one, one, 0);
            nodes_[word + 2 * i + 1] = glm::uvec4(minus_one, minus_one, minus_one, 0);
        }
        return word;
    }

private:
    void write(std::size_t word, int child, const Bounds& bounds, std::uint32_t reference) {
        const glm::vec3 magnitude = glm::max(glm::abs(bounds.lower), glm::abs(bounds.upper));
        const float pad = PADDING * glm::max(glm::max(magnitude.x, magnitude.y), magnitude.z);
        const glm::vec3 lower = bounds.lower - pad;
        const glm::vec3 upper = bounds.upper + pad;
        for (int axis = 0; axis < 3; ++axis) {
            nodes_[word + 2 * child][axis] = std::bit_cast<std::uint32_t>(lower[axis]);
            nodes_[word + 2 * child + 1][axis] = std::bit_cast<std::uint32_t>(upper[axis]);
        }
        nodes_[word + child][3] = reference;
    }

    std::vector<glm::uvec4>& nodes_;
};

} // namespace

Bvh build_bvh(std::span<const BvhInputTriangle> triangles) {
    Bvh bvh;
    std::vector<SahItem> items(triangles.size());
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        items[i].index = static_cast<std::uint32_t>(i);
        items[i].bounds.grow(triangles[i].v0);
        items[i].bounds.grow(triangles[i].v1);
        items[i].bounds.grow(triangles[i].v2);
        bvh.bounds.grow(items[i].bounds);
    }
    Encoder encoder(bvh.nodes);
    if (triangles.empty()) {
        encoder.add_node();
        return bvh;
    }
    const auto root = build_sah(items, SahOptions{.max_leaf = MAX_LEAF});
    encoder.encode_root(*root);
    bvh.order.reserve(items.size());
    for (const SahItem& item : items)
        bvh.order.push_back(item.index);
    return bvh;
}

std::uint32_t append_bvh(const Bvh& bvh, std::uint32_t first_primitive,
                         std::vector<glm::uvec4>& nodes) {
    const auto base = static_cast<std::uint32_t>(nodes.size() / shader::BVH_NODE_WORDS);
    const std::size_t begin = nodes.size();
    nodes.insert(nodes.end(), bvh.nodes.begin(), bvh.nodes.end());
    for (std::size_t word = begin; word < nodes.size(); word += shader::BVH_NODE_WORDS) {
        for (int child = 0; child < 2; ++child) {
            std::uint32_t& reference = nodes[word + child][3];
            reference += (reference & shader::BVH_LEAF) != 0 ? first_primitive : base;
        }
    }
    return base;
}

} // namespace vigil
