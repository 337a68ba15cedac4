// SPDX-License-Identifier: GPL-2.0-or-later
// Wide nodes breadth-first, so that inner children of a node follow each other. Whatever is rounded
// is rounded outwards: boxes and cones hold every light below them.
#include "refresh/vkpt/light/light_hierarchy.h"

#include "shared/octahedral.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace vigil {

namespace {

constexpr std::uint32_t MOST_CHILDREN = 8;

/// The descendants of a binary node that become children of its wide node.
struct Children {
    std::array<std::uint32_t, MOST_CHILDREN> node;
    std::uint32_t count = 0;
};

/// Opens the child of the largest measure, which importance knows least about, while there is room.
Children open_children(std::span<const LightTreeNode> nodes, std::uint32_t root,
                       std::uint32_t width) {
    Children children;
    children.node[children.count++] = root;
    while (children.count < width) {
        std::uint32_t widest = MOST_CHILDREN;
        float most = -1.0f;
        for (std::uint32_t i = 0; i < children.count; ++i) {
            const LightTreeNode& node = nodes[children.node[i]];
            if (node.right == 0 || node.measure <= most) continue;
            most = node.measure;
            widest = i;
        }
        if (widest == MOST_CHILDREN) break; // leaves only
        const std::uint32_t opened = children.node[widest];
        children.node[widest] = opened + 1;
        children.node[children.count++] = nodes[opened].right;
    }
    return children;
}

/// Bytes of a group of four children, gathered child by child.
struct GroupCode {
    std::array<std::array<std::uint8_t, 4>, 3> lower{}, upper{};
    std::array<std::array<std::uint8_t, 4>, 2> axis{};
    std::array<std::uint8_t, 4> half_sine{};
    std::array<std::uint16_t, 4> energy{};

    static std::uint32_t word(const std::array<std::uint8_t, 4>& bytes) {
        return bytes[0] | std::uint32_t{bytes[1]} << 8 | std::uint32_t{bytes[2]} << 16 |
               std::uint32_t{bytes[3]} << 24;
    }
    void write(std::span<glm::uvec4> words, std::uint32_t first_inner) const {
        words[0] = {word(lower[0]), word(lower[1]), word(lower[2]), word(upper[0])};
        words[1] = {word(upper[1]), word(upper[2]), word(axis[0]), word(axis[1])};
        words[2] = {word(half_sine), energy[0] | std::uint32_t{energy[1]} << 16,
                    energy[2] | std::uint32_t{energy[3]} << 16, first_inner};
    }
};

/// Exponent (biased) of a power of two whose 255 steps reach over `size` map units; at most twice
/// the smallest, but for sizes near 0.
std::uint32_t step_exponent(double size) {
    constexpr int least = 32, most = 254;
    if (!(size > 0.0)) return least;
    int exponent = 0;
    std::frexp(size / 255.0, &exponent); // size / 255 < 2^exponent
    return static_cast<std::uint32_t>(std::clamp(exponent + 127, least, most));
}

/// Sets the box of child `i`; all arithmetic is exact in double precision.
void encode_box(GroupCode& group, std::uint32_t i, const LightTreeNode& child,
                const glm::vec3& origin, const glm::dvec3& step) {
    for (glm::length_t axis = 0; axis < 3; ++axis) {
        const double from = static_cast<double>(origin[axis]);
        const auto steps = [&](float at) { return (static_cast<double>(at) - from) / step[axis]; };
        group.lower[axis][i] = static_cast<std::uint8_t>(std::floor(steps(child.lower[axis])));
        group.upper[axis][i] = static_cast<std::uint8_t>(std::ceil(steps(child.upper[axis])));
    }
}

/// Sets axis and size of the cone of child `i`, which holds the normals of these lights.
void encode_cone(GroupCode& group, std::uint32_t i, const glm::vec3& normal_sum,
                 std::span<const TreeLight> lights) {
    const glm::vec2 square = shader::octahedral_encode(normal_sum) * 2.0f - 1.0f;
    glm::vec2 rounded;
    for (glm::length_t axis = 0; axis < 2; ++axis) {
        const float code = std::clamp(std::round(square[axis] * 127.0f), -127.0f, 127.0f);
        group.axis[axis][i] = static_cast<std::uint8_t>(code + 127.0f);
        rounded[axis] = code / 127.0f;
    }
    const glm::vec3 axis = shader::octahedral_decode(rounded * 0.5f + 0.5f);
    // The chord between unit vectors is twice the sine of half the angle: as exact for small
    // angles.
    float widest = 0.0f;
    for (const TreeLight& light : lights) {
        const glm::vec3 chord = light.normal - axis;
        widest = std::max(widest, std::sqrt(glm::dot(chord, chord)) + light.normal_error);
    }
    // Angles that the walk's own slack covers count as none: walls and ceilings stay exact.
    const float half_sine = 0.5f * widest;
    group.half_sine[i] = half_sine <= 1e-7f
                             ? std::uint8_t{0}
                             : static_cast<std::uint8_t>(
                                   std::clamp(std::ceil(half_sine * 255.0f + 0.25f), 1.0f, 255.0f));
}

/// Energy as a part of the node's largest, as light_node_energies reads it; never 0.
std::uint16_t encode_energy(float part) {
    const auto bits = static_cast<std::int64_t>(std::bit_cast<std::uint32_t>(part));
    const std::int64_t code = (bits + (1 << 12) - (std::int64_t{64} << 23)) >> 13;
    return static_cast<std::uint16_t>(std::clamp<std::int64_t>(code, 1, 63 << 10));
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
    queue_.push_back(0);
    parents_.push_back(shader::NONE);
    for (std::uint32_t number = 0; number < queue_.size(); ++number) // which grows
        write_node(number, options);
    header_.node_count = static_cast<std::uint32_t>(queue_.size());
}

void LightHierarchy::write_node(std::uint32_t number, const LightHierarchyOptions& options) {
    const std::span<const LightTreeNode> tree = tree_.nodes();
    const LightTreeNode& root = tree[queue_[number]];
    const Children children = open_children(tree, queue_[number], options.width);

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
