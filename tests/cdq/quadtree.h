// SPDX-License-Identifier: GPL-2.0-or-later
// The oracle of the Compressed Directional Quadtree (paper, section 5): nodes with pointers,
// numbered breadth-first after every change, with coordinates in double precision. It shares no
// code with shaders/shared/cdq.h but the size of the field and the depth limit; it is slow and
// checks nothing.
#pragma once

#include "guiding/dice.h"
#include "shared/cdq.h"

#include <array>
#include <memory>
#include <vector>

namespace vigil::test {

inline constexpr std::array<uint32_t, 4> cdq_sizes{32, 64, 96, 128};

/// Sanitizers slow everything down; the counts of random cases shrink with them.
#ifdef VIGIL_SANITIZED
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif

class Quadtree {
public:
    struct Node {
        Node* parent = nullptr;
        std::array<std::unique_ptr<Node>, 4> children; // all or none
        glm::dvec2 corner{0.0};
        double size = 1.0;
        uint32_t depth = 0;  // root: 0
        uint32_t number = 0; // its bit; meaningless for the root

        bool is_inner() const { return children[0] != nullptr; }
        /// Inner, and all children are leaves: the paper's nodes to collapse.
        bool is_collapsible() const;
        bool holds(glm::dvec2 uv) const;
    };

    /// As even as the field of `bits` allows: nodes split in the order of their numbers.
    explicit Quadtree(uint32_t bits);

    uint32_t bits() const { return static_cast<uint32_t>(nodes_.size()); }
    /// All nodes but the root, by number.
    const std::vector<Node*>& nodes() const { return nodes_; }
    glm::uvec4 field() const;
    /// The leaf that holds a point of [0, 1)^2.
    const Node& find(glm::dvec2 uv) const;

    /// `inner` must be collapsible and `leaf` a leaf that is not its child.
    void migrate(uint32_t inner, uint32_t leaf);

private:
    static void split(Node& node);
    void number_nodes();

    std::unique_ptr<Node> root_ = std::make_unique<Node>();
    std::vector<Node*> nodes_;
};

/// What one migration changes, as numbers of nodes.
struct Migration {
    uint32_t inner, leaf;
};

/// How a migration is chosen among those that are allowed.
enum class Habit {
    Any,      // evenly
    Deepen,   // splits a deepest leaf, collapses a shallowest node: chains down to the depth limit
    Flatten,  // the reverse
    Ends,     // first or last inner node, first or last leaf of the field
    Adjacent, // the leaf nearest to the removed children, before or after them
};
inline constexpr uint32_t habit_count = 5;

Migration choose_migration(const Quadtree& tree, Habit habit, Dice& dice);

/// As deep as allowed around a point of [0, 1)^2, coarse far from it.
Quadtree tree_towards(uint32_t bits, glm::dvec2 target);

/// Even, random and strongly uneven trees: towards the poles, corners, folds and borders of the
/// map, and `random_trees` each of random shapes and of random targets.
std::vector<Quadtree> various_trees(uint32_t bits, uint32_t random_trees, Dice& dice);

} // namespace vigil::test
