// SPDX-License-Identifier: GPL-2.0-or-later
// Turns the tree of sah_builder into the nodes of shaders/shared/bvh.h, depth first, siblings side
// by side, and pads every box so that the traversal's arithmetic never misses a triangle that the
// triangle test would hit.
#include "refresh/vkpt/scene/bvh_builder.h"

#include "common/error.h"
#include "refresh/vkpt/scene/sah_builder.h"
#include "refresh/vkpt/scene/triangle_pairs.h"
#include "shared/bvh.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace vigil {

namespace {

/// Boxes grow by this share of the node's largest coordinate: eight roundings, where the box test
/// makes four that are relative to the node's place and extent.
constexpr float PADDING = 0x1p-21f;
constexpr std::uint32_t GRID_MAX = 65535;

/// Inner nodes on the longest path of the planned tree.
std::uint32_t wide_depth(const SahNode& node) {
    if (node.leaf()) return 0;
    std::uint32_t depth = 0;
    for (const SahNode* child : wide_children(node))
        depth = std::max(depth, wide_depth(*child));
    return depth + 1;
}

std::unique_ptr<SahNode> build_tree(std::vector<SahItem>& items) {
    // Only contrived input makes the heuristic's tree deeper than the traversal's stack; then
    // halving by count takes over earlier.
    for (std::uint32_t split_depth = 48;; split_depth /= 2) {
        auto root = build_sah(items, SahOptions{.split_depth = split_depth});
        plan_wide_nodes(*root);
        if (split_depth <= 1 || wide_depth(*root) <= shader::BVH_MAX_DEPTH) return root;
    }
}

/// A node's grid: box corners become 16-bit steps from `origin`, rounded outwards.
class Grid {
public:
    explicit Grid(const Bounds& bounds) {
        const glm::vec3 magnitude = glm::max(glm::abs(bounds.lower), glm::abs(bounds.upper));
        padding_ = PADDING * std::max({magnitude.x, magnitude.y, magnitude.z, 1e-20f});
        origin_ = bounds.lower - 2.0f * padding_;
        const glm::vec3 extent = bounds.upper - origin_;
        const float largest = std::max({extent.x, extent.y, extent.z}) + 2.0f * padding_;
        // The power of two that lets the largest extent fit.
        int exponent = 0;
        std::frexp(largest / static_cast<float>(GRID_MAX - 1), &exponent);
        step_ = std::ldexp(1.0f, std::max(exponent, -100));
    }

    std::uint32_t interval(float lower, float upper, int axis) const {
        const double first = (double{lower} - padding_ - origin_[axis]) / step_;
        const double last = (double{upper} + padding_ - origin_[axis]) / step_;
        const auto low = static_cast<std::uint32_t>(std::max(std::floor(first), 0.0));
        const auto high =
            static_cast<std::uint32_t>(std::min(std::ceil(last), static_cast<double>(GRID_MAX)));
        return low | high << 16;
    }

    glm::uvec4 meta(std::uint32_t child_node) const {
        return {std::bit_cast<std::uint32_t>(origin_.x), std::bit_cast<std::uint32_t>(origin_.y),
                std::bit_cast<std::uint32_t>(origin_.z),
                std::bit_cast<std::uint32_t>(step_) | child_node};
    }

private:
    glm::vec3 origin_;
    float padding_;
    float step_;
};

class Encoder {
public:
    Encoder(std::span<const BvhInputTriangle> triangles, std::span<const TrianglePair> pairs,
            std::span<const SahItem> items, Bvh& bvh)
        : triangles_(triangles), pairs_(pairs), items_(items), bvh_(bvh) {}

    /// Appends a node of four empty leaves and returns its index.
    std::uint32_t add_node() {
        const std::size_t index = bvh_.nodes.size() / shader::BVH_NODE_WORDS;
        if (index > shader::BVH_CHILD_NODE_MASK)
            fail("a model has too many triangles for its hierarchy");
        for (int record = 0; record < 4; ++record) {
            bvh_.nodes.resize(bvh_.nodes.size() + 3, glm::uvec4(0));
            bvh_.nodes.emplace_back(0, 0, 0, shader::BVH_LEAF);
        }
        return static_cast<std::uint32_t>(index);
    }

    void encode(const SahNode& tree, std::uint32_t record) {
        if (tree.leaf()) {
            encode_leaf(pairs_[items_[tree.item].index], record);
            return;
        }
        std::vector<const SahNode*> children = wide_children(tree);
        // Largest first: the order in which shadow rays look for anything that stops them.
        std::stable_sort(children.begin(), children.end(), [](const SahNode* x, const SahNode* y) {
            return x->bounds.half_area() > y->bounds.half_area();
        });
        const std::uint32_t node = add_node();
        const Grid grid(tree.bounds);
        glm::uvec4* words = &bvh_.nodes[std::size_t{record} * shader::BVH_RECORD_WORDS];
        for (int axis = 0; axis < 3; ++axis) {
            // Slots without a child keep a point of the grid as their box; an empty leaf lies
            // behind it.
            words[axis] = glm::uvec4(GRID_MAX | GRID_MAX << 16);
            for (std::size_t i = 0; i < children.size(); ++i) {
                const Bounds& box = children[i]->bounds;
                words[axis][i] = grid.interval(box.lower[axis], box.upper[axis], axis);
            }
        }
        words[3] = grid.meta(node);
        for (std::size_t i = 0; i < children.size(); ++i)
            encode(*children[i], 4 * node + static_cast<std::uint32_t>(i));
    }

private:
    void encode_leaf(const TrianglePair& pair, std::uint32_t record) {
        const BvhInputTriangle& first = triangles_[pair.first];
        std::array<glm::vec3, 4> corner;
        for (std::uint32_t i = 0; i < 3; ++i)
            corner[i] = TrianglePairFinder::vertex(first, pair.first_rotation + i);
        corner[3] = corner[2];
        std::uint32_t flags = first.coverage | pair.first_rotation << 16;
        const auto slot = static_cast<std::uint32_t>(bvh_.order.size());
        bvh_.order.push_back(pair.first);
        if (pair.second != shader::NONE) {
            const BvhInputTriangle& second = triangles_[pair.second];
            corner[3] = TrianglePairFinder::vertex(second, pair.second_rotation + 2);
            flags |= second.coverage << 8 | pair.second_rotation << 18;
            bvh_.order.push_back(pair.second);
        }
        glm::uvec4* words = &bvh_.nodes[std::size_t{record} * shader::BVH_RECORD_WORDS];
        for (int i = 0; i < 3; ++i) {
            for (int axis = 0; axis < 3; ++axis)
                words[i][axis] = std::bit_cast<std::uint32_t>(corner[i][axis]);
            words[i][3] = std::bit_cast<std::uint32_t>(corner[3][i]);
        }
        words[3] = {slot, flags, 0, shader::BVH_LEAF};
    }

    std::span<const BvhInputTriangle> triangles_;
    std::span<const TrianglePair> pairs_;
    std::span<const SahItem> items_;
    Bvh& bvh_;
};

} // namespace

Bvh build_bvh(std::span<const BvhInputTriangle> triangles) {
    Bvh bvh;
    const std::vector<TrianglePair> pairs = TrianglePairFinder(triangles).find();
    std::vector<SahItem> items;
    items.reserve(pairs.size());
    for (const TrianglePair& pair : pairs) {
        items.push_back({pair.bounds, static_cast<std::uint32_t>(items.size())});
        bvh.bounds.grow(pair.bounds);
    }
    Encoder encoder(triangles, pairs, items, bvh);
    bvh.order.reserve(triangles.size());
    const std::uint32_t root = encoder.add_node();
    if (items.empty()) return bvh;
    const auto tree = build_tree(items);
    encoder.encode(*tree, 4 * root);
    return bvh;
}

std::vector<glm::uvec4> rebase_bvh(const Bvh& bvh, std::uint32_t first_primitive,
                                   std::uint32_t first_node) {
    if (first_node + bvh.nodes.size() / shader::BVH_NODE_WORDS > shader::BVH_CHILD_NODE_MASK)
        fail("the models have too many triangles for one buffer of hierarchies");
    std::vector<glm::uvec4> nodes = bvh.nodes;
    for (std::size_t word = 3; word < nodes.size(); word += shader::BVH_RECORD_WORDS) {
        glm::uvec4& meta = nodes[word];
        if ((meta.w & shader::BVH_LEAF) != 0)
            meta.x += first_primitive;
        else
            meta.w += first_node;
    }
    return nodes;
}

std::uint32_t append_bvh(const Bvh& bvh, std::uint32_t first_primitive,
                         std::vector<glm::uvec4>& nodes) {
    const auto first_node = static_cast<std::uint32_t>(nodes.size() / shader::BVH_NODE_WORDS);
    const std::vector<glm::uvec4> rebased = rebase_bvh(bvh, first_primitive, first_node);
    nodes.insert(nodes.end(), rebased.begin(), rebased.end());
    return first_node;
}

std::size_t max_bvh_words(std::size_t triangle_count) {
    // The root's node, and one for each inner record: a tree of n leaves has at most n - 1.
    return std::max<std::size_t>(triangle_count, 1) * shader::BVH_NODE_WORDS;
}

} // namespace vigil
