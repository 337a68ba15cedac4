// SPDX-License-Identifier: GPL-2.0-or-later
// See random_rays.h.
#include "random_rays.h"

#include "cdq/quadtree.h"
#include "shared/octahedral.h"

#include <array>
#include <bit>
#include <cmath>

namespace vigil::test {
namespace {

Path path_of(const Quadtree::Node& node) {
    if (node.parent == nullptr) return "";
    int child = 0;
    while (node.parent->children[static_cast<size_t>(child)].get() != &node)
        ++child;
    return child_of(path_of(*node.parent), child);
}

Squares squares_of(const Quadtree& tree) {
    Squares inner{""};
    for (const Quadtree::Node* node : tree.nodes())
        if (node->is_inner()) inner.insert(path_of(*node));
    return inner;
}

glm::vec2 near(Dice& dice, glm::vec2 target) {
    const float reach = std::exp2(-static_cast<float>(dice.below(12)));
    return target + reach * glm::vec2(dice.between(-0.5f, 0.5f), dice.between(-0.5f, 0.5f));
}

/// Directions in which the map has a corner, an edge or a fold, and their neighbours.
glm::vec3 special_direction(Dice& dice) {
    glm::vec3 direction(0.0f);
    for (int axis = 0; axis < 3; ++axis)
        if (const uint32_t choice = dice.below(4); choice > 0)
            direction[axis] = static_cast<float>(choice) - 2.0f;
    if (direction == glm::vec3(0.0f)) direction.z = dice.chance(0.5) ? 1.0f : -1.0f;
    if (dice.chance(0.3)) direction[static_cast<int>(dice.below(3))] += 1e-3f;
    if (dice.chance(0.3)) direction[static_cast<int>(dice.below(3))] -= 1e-6f;
    return direction;
}

float random_contribution(Dice& dice, Brought brought, uint32_t rays) {
    switch (brought) {
    case Brought::Same:
        return 1.0f;
    case Brought::Powers: {
        // Squares are powers of four; 24 bits hold their range, the number of rays, and a quarter
        // of a quarter per migration.
        const int range = rays > 1000 ? 1 : 2;
        return std::exp2(static_cast<float>(dice.below(2 * range + 1)) - static_cast<float>(range));
    }
    default:
        break;
    }
    constexpr std::array<float, 6> extremes{0.0f, 1e-38f, 1e-9f, 1e9f, 3e9f, 1e30f};
    if (dice.chance(0.02)) return extremes[dice.below(extremes.size())];
    return std::exp2(dice.between(-20.0f, 20.0f));
}

/// Sums of the upper halves of floats; nothing in half of all leaves.
Sums random_sums(Dice& dice, const Squares& inner) {
    Sums sums;
    const bool none = dice.chance(0.5);
    for (const Path& square : nodes_of(inner)) {
        if (inner.contains(square)) continue;
        const float sum = dice.chance(0.3) ? 0.0f : std::exp2(dice.between(-40.0f, 40.0f));
        const uint32_t half = std::bit_cast<uint32_t>(sum) & 0xffff0000u;
        sums[square] = none ? 0.0 : static_cast<double>(std::bit_cast<float>(half));
    }
    return sums;
}

} // namespace

glm::uvec2 random_cell(Dice& dice, glm::vec2 target) {
    glm::vec2 uv;
    if (dice.chance(0.5))
        uv = near(dice, target);
    else if (dice.chance(0.3))
        uv = shader::octahedral_encode(special_direction(dice));
    else
        uv = {dice.between(0.0f, 1.0f), dice.between(0.0f, 1.0f)};
    return glm::min(glm::uvec2(glm::max(uv, 0.0f) * 4096.0f), 4095u);
}

Squares quadtree_towards(uint32_t bits, glm::vec2 target) {
    return squares_of(tree_towards(bits, target));
}

Squares random_quadtree(Dice& dice, uint32_t bits, uint32_t migrations) {
    Quadtree tree(bits);
    const auto habit = static_cast<Habit>(dice.below(habit_count));
    for (uint32_t left = dice.below(migrations + 1); left > 0; --left) {
        const Migration chosen = choose_migration(tree, habit, dice);
        tree.migrate(chosen.inner, chosen.leaf);
    }
    return squares_of(tree);
}

void add_random_rays(Dice& dice, const RandomRays& rays, uint32_t bits, uint32_t capacity,
                     TreeState& state) {
    state.rays.resize(size_t{shader::RAY_SAMPLE_WORDS} * capacity);
    for (uint32_t& ray : state.rays)
        ray = dice.word();
    // Ranges lie in any order in the buffer, with gaps; at its end there is room for nothing.
    std::vector<Path> order(state.inner.begin(), state.inner.end());
    dice.shuffle(order);
    uint32_t used = 0;
    for (const Path& path : order) {
        NodeState& node = state.nodes[path];
        node.quadtree = random_quadtree(dice, bits, rays.migrations);
        if (rays.remembered) node.remembered = random_sums(dice, node.quadtree);
        const std::array<uint32_t, 6> likely{
            0, 1, 2 + dice.below(8), rays.most / 8, dice.below(rays.most), rays.most};
        node.rays = likely[dice.below(likely.size())];
        node.blank = node.rays != 1 && dice.chance(0.5) ? dice.below(100) : 0;
        const std::array<uint32_t, 4> rooms{node.rays, node.rays + dice.below(10), node.rays / 2,
                                            0};
        node.room = rooms[dice.chance(0.6) ? dice.below(2) : dice.below(4)];
        node.first_ray = std::min(used + (dice.chance(0.1) ? dice.below(10) : 0), capacity);
        node.room = std::min(node.room, capacity - node.first_ray);
        used = node.first_ray + node.room;
        const glm::vec2 target(dice.between(0.0f, 1.0f), dice.between(0.0f, 1.0f));
        for (uint32_t i = 0; i < node.kept(); ++i) {
            uint32_t* ray = state.ray(node, i);
            ray[0] = shader::ray_sample_pack(random_cell(dice, target),
                                             random_contribution(dice, rays.brought, node.rays));
            const float square = dice.chance(0.2) ? 0.0f : std::exp2(dice.between(-20.0f, 20.0f));
            ray[1] = shader::pack_sums(square, dice.between(0.0f, 1.0f));
        }
    }
}

} // namespace vigil::test
