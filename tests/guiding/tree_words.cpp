// SPDX-License-Identifier: GPL-2.0-or-later
// See tree_words.h.
#include "tree_words.h"

#include "shared/octree.h"
#include "shared/scene_types.h"

#include <bit>

namespace vigil::test {

using namespace shader;

namespace {

/// Half a word of a node's sums.
uint32_t sum_half(uint32_t node) {
    return 16 * (node % 2);
}

/// Stores sums that upper halves of floats hold; inner nodes keep what is there.
void store_sums(const NodeState& state, uint32_t number, TreeWords& words) {
    uint32_t node = 0;
    for (const Path& square : nodes_of(state.quadtree)) {
        if (const auto sum = state.remembered.find(square); sum != state.remembered.end()) {
            uint32_t& word = words.at(guide_memory(CDQ_SUM_WORDS), number, node / 2);
            const auto bits = std::bit_cast<uint32_t>(static_cast<float>(sum->second));
            word = (word & ~(0xffffu << sum_half(node))) | bits >> 16 << sum_half(node);
        }
        ++node;
    }
}

} // namespace

uint32_t leaf_mask(const InnerNodes& inner, const Path& node) {
    uint32_t mask = 0;
    for (int child = 0; child < 8; ++child)
        if (!inner.contains(child_of(node, child))) mask |= 1u << child;
    return mask;
}

std::optional<Path> first_inner_child(const InnerNodes& inner, const Path& node) {
    for (int child = 0; child < 8; ++child)
        if (inner.contains(child_of(node, child))) return child_of(node, child);
    return std::nullopt;
}

uint32_t neighbour_number(const InnerNodes& inner, const Numbering& numbers, const Path& leaf,
                          int face) {
    const std::optional<Path> neighbour = neighbour_of(inner, leaf, face);
    return neighbour ? numbers.leaf(*neighbour) : NONE;
}

glm::uvec4 quadtree_at(const TreeWords& words, uint32_t octree_node) {
    glm::uvec4 field;
    for (uint32_t word = 0; word < 4; ++word)
        field[static_cast<int>(word)] = words.at(NODE_GUIDE, octree_node, word);
    return field;
}

ShareState shared_at(const TreeWords& words, uint32_t octree_node) {
    const auto number = [&](uint32_t word, uint32_t shift) {
        return static_cast<double>(
            std::bit_cast<float>(words.at(NODE_SHARE, octree_node, word) << shift & 0xffff0000u));
    };
    return {number(0, 16), number(0, 0), number(1, 16), number(1, 0)};
}

Sums sums_at(const TreeWords& words, uint32_t octree_node, const Squares& inner) {
    Sums sums;
    uint32_t node = 0;
    for (const Path& square : nodes_of(inner)) {
        const uint32_t word = words.at(guide_memory(CDQ_SUM_WORDS), octree_node, node / 2);
        if (!inner.contains(square))
            sums[square] = static_cast<double>(std::bit_cast<float>(word >> sum_half(node) << 16));
        ++node;
    }
    return sums;
}

BucketDraws drawn_at(std::span<const uint32_t> words) {
    BucketDraws drawn;
    for (size_t i = 0; i + 1 < words.size(); i += VLC_BUCKET_WORDS)
        drawn.push_back({static_cast<double>(std::bit_cast<float>(words[i])),
                         static_cast<double>(std::bit_cast<float>(words[i + 1] << 16)),
                         static_cast<double>(std::bit_cast<float>(words[i + 1] & 0xffff0000u))});
    return drawn;
}

Explored explored_at(const TreeWords& words, uint32_t leaf) {
    const auto number = [&](uint32_t word, uint32_t shift) {
        return static_cast<double>(
            std::bit_cast<float>(words.at(LEAF_EXPLORE, leaf, word) << shift & 0xffff0000u));
    };
    return {number(0, 16), number(0, 0), number(1, 16), number(1, 0)};
}

TreeWords TreeWords::sized(uint32_t node_capacity, bool sums) {
    const uint32_t node_words = 8 * LEAF_WORDS + (sums ? NODE_WORDS + CDQ_SUM_WORDS : 0);
    return {std::vector<uint32_t>(1 + node_capacity), std::vector<uint32_t>(2 * node_capacity),
            std::vector<uint32_t>(node_words * node_capacity)};
}

uint32_t TreeWords::node_capacity() const {
    return static_cast<uint32_t>(cells.size() / 2);
}

uint32_t& TreeWords::at(const shader::LeafArray& array, uint32_t leaf, uint32_t i) {
    return leaves.at(leaf_array_word(array, leaf, node_capacity()) + i);
}
uint32_t TreeWords::at(const shader::LeafArray& array, uint32_t leaf, uint32_t i) const {
    return leaves.at(leaf_array_word(array, leaf, node_capacity()) + i);
}

uint32_t& TreeWords::at(const shader::NodeArray& array, uint32_t node, uint32_t i) {
    return leaves.at(node_array_word(array, node, node_capacity()) + i);
}
uint32_t TreeWords::at(const shader::NodeArray& array, uint32_t node, uint32_t i) const {
    return leaves.at(node_array_word(array, node, node_capacity()) + i);
}

QuadtreeLessons TreeState::lessons_of(const NodeState& node) const {
    QuadtreeLessons found;
    found.blank = node.blank;
    for (uint32_t i = 0; i < node.kept(); ++i) {
        const size_t word = size_t{RAY_SAMPLE_WORDS} * (node.first_ray + i);
        found.stored.push_back({rays.at(word), rays.at(word + 1)});
    }
    return found;
}

Numbering::Numbering(const InnerNodes& inner) {
    uint32_t number = 0;
    for (const Path& node : inner)
        nodes_[node] = number++;
}

uint32_t Numbering::leaf(const Path& leaf) const {
    return 8 * nodes_.at(leaf.substr(0, leaf.size() - 1)) +
           static_cast<uint32_t>(leaf.back() - '0');
}

TreeWords encode(const TreeState& state, uint32_t node_capacity, Dice& garbage) {
    TreeWords words = TreeWords::sized(node_capacity, !state.rays.empty());
    for (std::vector<uint32_t>* buffer : {&words.nodes, &words.cells, &words.leaves})
        for (uint32_t& word : *buffer)
            word = garbage.word();

    const Numbering numbers(state.inner);
    words.nodes[0] = static_cast<uint32_t>(state.inner.size());
    for (const Path& node : state.inner) {
        const uint32_t number = numbers.node(node);
        const std::optional<Path> first = first_inner_child(state.inner, node);
        const uint32_t offset = first ? numbers.node(*first) : garbage.below(1u << 24);
        words.nodes[1 + number] = leaf_mask(state.inner, node) + 256 * offset;
        const Cube cube = cube_of(node);
        const uvec2 cell =
            octree_pack_cell({uvec3(cube.lowest), static_cast<uint32_t>(node.size())});
        words.cells[2 * number] = cell.x;
        words.cells[2 * number + 1] = cell.y;
    }
    for (const auto& [path, leaf] : state.leaves) {
        const uint32_t number = numbers.leaf(path);
        words.at(LEAF_COUNT, number) = leaf.count;
        words.at(LEAF_VISIBLE, number) = 0; // as populate left it
        words.at(LEAF_STORAGE, number, 0) = leaf.first_sample;
        words.at(LEAF_STORAGE, number, 1) = leaf.room;
        words.at(LEAF_VLC, number, 0) = leaf.first_light;
        words.at(LEAF_VLC, number, 1) = leaf.buckets;
        words.at(LEAF_CACHED, number) = static_cast<uint32_t>(leaf.cached.size());
        words.at(LEAF_SOURCE, number) = leaf.inherited ? SOURCE_SPLIT : 0;
        const Explored& explored = leaf.explored;
        words.at(LEAF_EXPLORE, number, 0) = two_halves(explored.listed, explored.found);
        words.at(LEAF_EXPLORE, number, 1) = two_halves(explored.cached, explored.share);
        for (int face = 0; face < 6; ++face)
            words.at(LEAF_NEIGHBOURS, number, face) =
                neighbour_number(state.inner, numbers, path, face);
    }
    for (const auto& [path, node] : state.nodes) {
        const uint32_t number = numbers.node(path);
        const glm::uvec4 field = field_of(node.quadtree);
        for (uint32_t word = 0; word < 4; ++word)
            words.at(NODE_GUIDE, number, word) = field[static_cast<int>(word)];
        words.at(NODE_SHARE, number, 0) = two_halves(node.shared.plain, node.shared.guided);
        words.at(NODE_SHARE, number, 1) = two_halves(node.shared.rays, node.shared.share);
        words.at(NODE_RAYS, number, 0) = node.rays;
        words.at(NODE_RAYS, number, 1) = node.blank;
        words.at(NODE_RAY_STORAGE, number, 0) = node.first_ray;
        words.at(NODE_RAY_STORAGE, number, 1) = node.room;
        if (!node.remembered.empty()) store_sums(node, number, words);
    }
    return words;
}

TreeState state_after(const AdaptedOctree& tree, const Caches& caches, const TreeWords& seen,
                      std::vector<uint32_t> samples, std::vector<uint32_t> lights,
                      uint32_t bucket) {
    TreeState state;
    state.inner = tree.inner;
    state.samples = std::move(samples);
    state.caches = std::move(lights);
    const Numbering numbers(tree.inner);
    for (const auto& [path, source] : tree.source) {
        const uint32_t number = numbers.leaf(path);
        LeafState& leaf = state.leaves[path];
        leaf.first_sample = seen.at(LEAF_STORAGE, number, 0);
        leaf.room = seen.at(LEAF_STORAGE, number, 1);
        leaf.inherited = path.size() > source.size();
        leaf.explored = explored_at(seen, number);
        const auto cache = caches.by_leaf.find(source);
        if (cache == caches.by_leaf.end()) continue;
        leaf.first_light = seen.at(LEAF_VLC, number, 0);
        leaf.buckets = static_cast<uint32_t>(cache->second.buckets.size());
        leaf.cached = cache->second.ages;
        leaf.drawn = drawn_at(
            std::span(state.caches)
                .subspan(leaf.first_light + leaf.buckets * bucket, size_t{2} * leaf.buckets));
    }
    return state;
}

void take_quadtrees(TreeState& state, const TreeWords& seen, uint32_t bits, bool remember,
                    std::vector<uint32_t> rays) {
    state.rays = std::move(rays);
    const Numbering numbers(state.inner);
    for (const Path& path : state.inner) {
        const uint32_t number = numbers.node(path);
        NodeState& node = state.nodes[path];
        node.quadtree = squares_of(quadtree_at(seen, number), bits).value();
        node.shared = shared_at(seen, number);
        node.first_ray = seen.at(NODE_RAY_STORAGE, number, 0);
        node.room = seen.at(NODE_RAY_STORAGE, number, 1);
        if (remember) node.remembered = sums_at(seen, number, node.quadtree);
    }
}

} // namespace vigil::test
