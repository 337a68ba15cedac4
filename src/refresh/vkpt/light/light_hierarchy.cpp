// SPDX-License-Identifier: GPL-2.0-or-later
// Wide nodes breadth-first, so that inner children of a node follow each other. Whatever is rounded
// is rounded outwards: boxes and cones hold every light below them.
#include "refresh/vkpt/light/light_hierarchy.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

namespace vigil {

namespace {

/// The descendants of a binary node that become children of its wide node.
struct Children {
    std::array<std::uint32_t, WIDEST_LIGHT_NODE> node;
    std::uint32_t count = 0;
};

/// Puts `node` into `children` as at most `most` nodes side by side, as planned.
void collect(std::span<const LightTreeNode> nodes, std::span<const WideLightPlan> plans,
             std::uint32_t node, std::uint32_t most, Children& children) {
    while (most > 1 && plans[node].left[most - 1] == 0)
        --most;
    if (most == 1) {
        children.node[children.count++] = node;
        return;
    }
    const std::uint32_t left = plans[node].left[most - 1];
    collect(nodes, plans, node + 1, left, children);
    collect(nodes, plans, nodes[node].right, most - left, children);
}

/// Bytes of a group of four children, gathered child by child.
struct GroupCode {
    using Bytes = std::array<std::uint8_t, 4>;
    std::array<Bytes, 3> middle{}, half{}, axis{};
    Bytes spread{}, energy{};

    static std::uint32_t word(const Bytes& bytes) { return std::bit_cast<std::uint32_t>(bytes); }
    void write(std::span<glm::uvec4> words, std::uint32_t first_inner) const {
        words[0] = {word(middle[0]), word(middle[1]), word(middle[2]), word(half[0])};
        words[1] = {word(half[1]), word(half[2]), word(axis[0]), word(axis[1])};
        words[2] = {word(axis[2]), word(spread), word(energy), first_inner};
    }
};
static_assert(std::endian::native == std::endian::little);

/// Exponent (biased) of a power of two whose 254 steps reach over `size` map units; at most twice
/// the smallest, but for sizes near 0.
std::uint32_t step_exponent(double size) {
    constexpr int least = 32, most = 254;
    if (!(size > 0.0)) return least;
    int exponent = 0;
    std::frexp(size / 254.0, &exponent); // size / 254 < 2^exponent
    return static_cast<std::uint32_t>(std::clamp(exponent + 127, least, most));
}

/// Sets the box of child `i`; all arithmetic is exact in double precision.
void encode_box(GroupCode& group, std::uint32_t i, const LightTreeNode& child,
                const glm::vec3& origin, const glm::dvec3& step) {
    for (glm::length_t axis = 0; axis < 3; ++axis) {
        const auto steps = [&](float at) {
            return (static_cast<double>(at) - static_cast<double>(origin[axis])) / step[axis];
        };
        const double lower = steps(child.lower[axis]), upper = steps(child.upper[axis]);
        const double middle = std::round(0.5 * (lower + upper));
        const double half = std::max(middle - lower, upper - middle); // at most 127.5 steps
        group.middle[axis][i] = static_cast<std::uint8_t>(middle);
        group.half[axis][i] = static_cast<std::uint8_t>(std::ceil(2.0 * half));
    }
}

/// Sets axis and size of the cone of child `i`, which holds the normals of these lights.
void encode_cone(GroupCode& group, std::uint32_t i, const glm::vec3& normal_sum,
                 std::span<const TreeLight> lights) {
    const float length = glm::length(normal_sum);
    const glm::vec3 direction = length > 1e-3f ? normal_sum / length : lights.front().normal;
    const glm::vec3 code = glm::round(direction * 127.0f);
    for (glm::length_t axis = 0; axis < 3; ++axis)
        group.axis[axis][i] = static_cast<std::uint8_t>(static_cast<std::int8_t>(code[axis]));
    const glm::vec3 axis = glm::normalize(code);
    float widest = 0.0f;
    for (const TreeLight& light : lights) {
        const glm::vec3 apart = light.normal - axis;
        widest = std::max(widest, std::sqrt(glm::dot(apart, apart)) + light.normal_error);
    }
    // Angles that the walk's own slack covers count as none: walls and ceilings stay exact. The
    // rest is as seen along an axis that is up to 1% shorter than 1.
    group.spread[i] = widest <= 2e-7f ? std::uint8_t{0}
                                      : static_cast<std::uint8_t>(std::min(
                                            std::ceil(widest * 127.0f * 1.02f + 0.5f), 255.0f));
}

/// Energy as a part of the node's largest, as light_node_energies reads it; never 0.
std::uint8_t encode_energy(float part) {
    const auto bits = static_cast<std::int64_t>(std::bit_cast<std::uint32_t>(part));
    const std::int64_t code = (bits + (1 << 20) - (std::int64_t{64} << 23)) >> 21;
    return static_cast<std::uint8_t>(std::clamp<std::int64_t>(code, 1, 63 << 2));
}

} // namespace

void LightHierarchy::build(std::span<const shader::Light> lights,
                           const LightHierarchyOptions& options) {
    tree_.build(lights, options.leaf_size);
    header_ = {options.width <= 4 ? 1u : 2u, options.leaf_size,
               static_cast<std::uint32_t>(tree_.lights().size()), 0};
    places_.assign(lights.size(), shader::NONE);
    queue_.clear();
    nodes_.clear();
    leaf_lights_.clear();
    parents_.clear();
    if (header_.light_count == 0) return;
    plans_.resize(tree_.nodes().size());
    plan_node(0, options.width);
    queue_.push_back(0);
    parents_.push_back(shader::NONE);
    for (std::uint32_t number = 0; number < queue_.size(); ++number) // which grows
        write_node(number, options);
    header_.node_count = static_cast<std::uint32_t>(queue_.size());
}

void LightHierarchy::plan_node(std::uint32_t number, std::uint32_t width) {
    const LightTreeNode& node = tree_.nodes()[number];
    WideLightPlan& plan = plans_[number];
    plan = {};
    if (node.right == 0) return; // a leaf is never visited
    plan_node(number + 1, width);
    plan_node(node.right, width);
    const WideLightPlan& left = plans_[number + 1];
    const WideLightPlan& right = plans_[node.right];
    std::array<float, WIDEST_LIGHT_NODE> parted{};
    for (std::uint32_t count = 2; count <= width; ++count) {
        parted[count - 1] = std::numeric_limits<float>::infinity();
        for (std::uint32_t i = 1; i < count; ++i) {
            const float cost = left.cost[i - 1] + right.cost[count - i - 1];
            if (cost >= parted[count - 1]) continue;
            parted[count - 1] = cost;
            plan.left[count - 1] = static_cast<std::uint8_t>(i);
        }
    }
    // As one node it costs a visit and its children; as several it is not there itself.
    plan.left_child = plan.left[width - 1];
    plan.cost[0] = node.energy + parted[width - 1];
    for (std::uint32_t count = 2; count <= width; ++count) {
        plan.cost[count - 1] = parted[count - 1];
        if (plan.cost[count - 2] >= parted[count - 1]) continue;
        plan.cost[count - 1] = plan.cost[count - 2];
        plan.left[count - 1] = 0;
    }
}

void LightHierarchy::write_node(std::uint32_t number, const LightHierarchyOptions& options) {
    const std::span<const LightTreeNode> tree = tree_.nodes();
    const LightTreeNode& root = tree[queue_[number]];
    Children children;
    if (root.right == 0) {
        children.node[children.count++] = queue_[number]; // of all lights in one leaf
    } else {
        const std::uint32_t left = plans_[queue_[number]].left_child;
        collect(tree, plans_, queue_[number] + 1, left, children);
        collect(tree, plans_, root.right, options.width - left, children);
    }

    // The frame in which children are quantised.
    glm::uvec3 exponents;
    glm::dvec3 step;
    for (glm::length_t axis = 0; axis < 3; ++axis) {
        const double size =
            static_cast<double>(root.upper[axis]) - static_cast<double>(root.lower[axis]);
        exponents[axis] = step_exponent(size);
        step[axis] = std::ldexp(1.0, static_cast<int>(exponents[axis]) - 127);
    }

    float largest = 0.0f;
    for (std::uint32_t i = 0; i < children.count; ++i)
        largest = std::max(largest, tree[children.node[i]].energy);

    const std::uint32_t stride = shader::light_node_stride(header_.groups);
    const std::uint32_t slots = 4 * header_.groups;
    nodes_.resize(nodes_.size() + stride);
    leaf_lights_.resize(leaf_lights_.size() + size_t{slots} * options.leaf_size, shader::NONE);
    const auto first_inner = static_cast<std::uint32_t>(queue_.size());
    std::uint32_t inner = 0;
    std::array<GroupCode, 2> groups;
    for (std::uint32_t slot = 0; slot < children.count; ++slot) {
        const LightTreeNode& child = tree[children.node[slot]];
        const std::span<const TreeLight> lights = tree_.lights().subspan(child.first, child.count);
        GroupCode& group = groups[slot / 4];
        encode_box(group, slot % 4, child, root.lower, step);
        encode_cone(group, slot % 4, child.normal_sum, lights);
        group.energy[slot % 4] = encode_energy(child.energy / largest);
        const std::uint32_t edge = number * slots + slot;
        if (child.right != 0) {
            inner |= 1u << slot;
            queue_.push_back(children.node[slot]);
            parents_.push_back(edge);
            continue;
        }
        std::uint32_t place = edge * options.leaf_size;
        for (const TreeLight& light : lights) {
            leaf_lights_[place] = light.id;
            places_[light.id] = place++;
        }
    }
    const std::span<glm::uvec4> words = std::span(nodes_).subspan(size_t{number} * stride, stride);
    words[0] = {std::bit_cast<std::uint32_t>(root.lower.x),
                std::bit_cast<std::uint32_t>(root.lower.y),
                std::bit_cast<std::uint32_t>(root.lower.z),
                exponents.x | exponents.y << 8 | exponents.z << 16 | inner << 24};
    for (std::uint32_t group = 0; group < header_.groups; ++group)
        groups[group].write(words.subspan(1 + 3 * group, 3), first_inner);
}

} // namespace vigil
