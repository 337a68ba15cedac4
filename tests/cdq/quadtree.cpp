// SPDX-License-Identifier: GPL-2.0-or-later
// Nodes with pointers: splitting, collapsing, numbering, and the choice of what to migrate.
#include "quadtree.h"

#include <algorithm>

namespace vigil::test {

using Node = Quadtree::Node;

bool Node::is_collapsible() const {
    return is_inner() && std::none_of(children.begin(), children.end(),
                                      [](const auto& child) { return child->is_inner(); });
}

bool Node::holds(glm::dvec2 uv) const {
    return uv.x >= corner.x && uv.y >= corner.y && uv.x < corner.x + size && uv.y < corner.y + size;
}

Quadtree::Quadtree(uint32_t bits) {
    split(*root_);
    number_nodes();
    for (uint32_t next = 0; nodes_.size() < bits; ++next) {
        split(*nodes_[next]);
        number_nodes();
    }
}

glm::uvec4 Quadtree::field() const {
    glm::uvec4 field(0);
    for (const Node* node : nodes_)
        if (node->is_inner()) field[node->number / 32] |= 1u << node->number % 32;
    return field;
}

const Node& Quadtree::find(glm::dvec2 uv) const {
    const Node* node = root_.get();
    while (node->is_inner())
        node = std::find_if(node->children.begin(), node->children.end(), [&](const auto& child) {
                   return child->holds(uv);
               })->get();
    return *node;
}

void Quadtree::migrate(uint32_t inner, uint32_t leaf) {
    Node& opened = *nodes_[leaf];
    for (auto& child : nodes_[inner]->children)
        child.reset();
    split(opened);
    number_nodes();
}

void Quadtree::split(Node& node) {
    for (uint32_t i = 0; i < 4; ++i) {
        auto child = std::make_unique<Node>();
        child->parent = &node;
        child->size = 0.5 * node.size;
        child->corner = node.corner + child->size * glm::dvec2(i & 1u, i >> 1);
        child->depth = node.depth + 1;
        node.children[i] = std::move(child);
    }
}

void Quadtree::number_nodes() {
    nodes_.clear();
    const auto append_children = [this](const Node& node) {
        if (!node.is_inner()) return;
        for (const auto& child : node.children) {
            child->number = static_cast<uint32_t>(nodes_.size());
            nodes_.push_back(child.get());
        }
    };
    append_children(*root_);
    for (size_t next = 0; next < nodes_.size(); ++next)
        append_children(*nodes_[next]);
}

namespace {

bool shallower(const Node* a, const Node* b) {
    return a->depth < b->depth;
}

const Node* any_of(const std::vector<const Node*>& nodes, Dice& dice) {
    return nodes[dice.below(static_cast<uint32_t>(nodes.size()))];
}

const Node* either_end(const std::vector<const Node*>& nodes, Dice& dice) {
    return dice.chance(0.5) ? nodes.front() : nodes.back();
}

const Node* shallowest(const std::vector<const Node*>& nodes) {
    return *std::min_element(nodes.begin(), nodes.end(), shallower);
}

const Node* deepest(const std::vector<const Node*>& nodes) {
    return *std::max_element(nodes.begin(), nodes.end(), shallower);
}

/// The last of the nodes numbered before `number`, or the first after it; `nodes` by number.
const Node* nearest(const std::vector<const Node*>& nodes, uint32_t number, bool before) {
    const auto after = std::find_if(nodes.begin(), nodes.end(),
                                    [&](const Node* node) { return node->number > number; });
    if (after == nodes.end() || (before && after != nodes.begin())) return *(after - 1);
    return *after;
}

const Node* choose_inner(const std::vector<const Node*>& nodes, Habit habit, Dice& dice) {
    switch (habit) {
    case Habit::Deepen:
        return shallowest(nodes);
    case Habit::Flatten:
        return deepest(nodes);
    case Habit::Ends:
        return either_end(nodes, dice);
    default:
        return any_of(nodes, dice);
    }
}

const Node* choose_leaf(const std::vector<const Node*>& nodes, uint32_t removed, Habit habit,
                        Dice& dice) {
    switch (habit) {
    case Habit::Deepen:
        return deepest(nodes);
    case Habit::Flatten:
        return shallowest(nodes);
    case Habit::Ends:
        return either_end(nodes, dice);
    case Habit::Adjacent:
        return nearest(nodes, removed, dice.chance(0.5));
    default:
        return any_of(nodes, dice);
    }
}

} // namespace

Migration choose_migration(const Quadtree& tree, Habit habit, Dice& dice) {
    std::vector<const Node*> inner, leaves;
    inner.reserve(tree.bits());
    leaves.reserve(tree.bits());
    for (const Node* node : tree.nodes())
        if (node->is_collapsible()) inner.push_back(node);
    const Node* collapsed = choose_inner(inner, habit, dice);
    for (const Node* node : tree.nodes())
        if (!node->is_inner() && node->depth < shader::CDQ_MAX_DEPTH && node->parent != collapsed)
            leaves.push_back(node);
    const uint32_t removed = collapsed->children[0]->number;
    return {collapsed->number, choose_leaf(leaves, removed, habit, dice)->number};
}

Quadtree tree_towards(uint32_t bits, glm::dvec2 target) {
    Quadtree tree(bits);
    const auto distance = [&](const Node* node) {
        return glm::length(node->corner + 0.5 * node->size - target);
    };
    // Splits the nearest leaf and collapses the farthest node, until that would undo itself.
    for (uint32_t step = 0; step < 2 * bits; ++step) {
        const Node *leaf = nullptr, *inner = nullptr;
        for (const Node* node : tree.nodes()) {
            if (!node->is_inner() && node->depth < shader::CDQ_MAX_DEPTH &&
                (!leaf || node->holds(target) ||
                 (!leaf->holds(target) && distance(node) < distance(leaf))))
                leaf = node;
            if (node->is_collapsible() && (!inner || distance(node) > distance(inner)))
                inner = node;
        }
        if (leaf->parent == inner || distance(leaf) >= distance(inner)) break;
        tree.migrate(inner->number, leaf->number);
    }
    return tree;
}

std::vector<Quadtree> various_trees(uint32_t bits, uint32_t random_trees, Dice& dice) {
    std::vector<Quadtree> trees;
    trees.emplace_back(bits);
    const double end = std::nextafter(1.0, 0.0), beside = std::nextafter(0.5, 0.0);
    // The corners are -z, the centre +z, the middles of the borders the horizontal axes, and
    // (0.25, 0.25) lies on the fold between the halves.
    for (const glm::dvec2 target :
         {glm::dvec2(0.0), glm::dvec2(end), glm::dvec2(0.5), glm::dvec2(beside),
          glm::dvec2(0.5, 0.0), glm::dvec2(end, 0.5), glm::dvec2(0.25), glm::dvec2(0.75, 0.25)})
        trees.push_back(tree_towards(bits, target));
    for (uint32_t i = 0; i < random_trees; ++i) {
        const glm::dvec2 target(dice.between(0.0f, 1.0f), dice.between(0.0f, 1.0f));
        trees.push_back(tree_towards(bits, target));
        Quadtree shuffled(bits);
        for (uint32_t step = 0; step < 4 * bits; ++step) {
            const Migration chosen = choose_migration(shuffled, Habit::Any, dice);
            shuffled.migrate(chosen.inner, chosen.leaf);
        }
        trees.push_back(std::move(shuffled));
    }
    return trees;
}

} // namespace vigil::test
