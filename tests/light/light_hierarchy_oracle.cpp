// SPDX-License-Identifier: GPL-2.0-or-later
#include "light_hierarchy_oracle.h"

#include <algorithm>
#include <cmath>

namespace vigil::test {

namespace {

constexpr double pi = 3.14159265358979323846;

/// Byte `number` of a node, counted from its first.
uint32_t byte_of(const HierarchyWords& words, uint32_t node, uint32_t number) {
    const uint32_t bytes_of_node = words.header.groups == 1 ? 64 : 128;
    const uint32_t at = node * bytes_of_node + number;
    return words.nodes[at / 16][static_cast<glm::length_t>(at / 4 % 4)] >> (8 * (at % 4)) & 0xffu;
}

uint32_t word_of(const HierarchyWords& words, uint32_t node, uint32_t first_byte) {
    uint32_t word = 0;
    for (uint32_t i = 0; i < 4; ++i)
        word |= byte_of(words, node, first_byte + i) << (8 * i);
    return word;
}

double float_of(uint32_t bits) {
    float value;
    static_assert(sizeof(value) == sizeof(bits));
    std::memcpy(&value, &bits, sizeof(value));
    return static_cast<double>(value);
}

double energy_of(uint32_t code) {
    return std::ldexp(1.0 + (code & 1023) / 1024.0, static_cast<int>(code >> 10) - 63);
}

glm::dvec3 axis_of(uint32_t x, uint32_t y) {
    const double a = (x - 127.0) / 127.0, b = (y - 127.0) / 127.0;
    const double z = 1.0 - std::abs(a) - std::abs(b);
    glm::dvec3 axis(a, b, z);
    if (z < 0.0)
        axis = {(1.0 - std::abs(b)) * (a < 0.0 ? -1.0 : 1.0),
                (1.0 - std::abs(a)) * (b < 0.0 ? -1.0 : 1.0), z};
    return glm::normalize(axis);
}

/// Mean of max(x, 0) over an interval.
double mean_above(double middle, double reach) {
    if (middle >= reach) return middle;
    const double top = middle + reach;
    return top <= 0.0 ? 0.0 : top * top / (4.0 * reach);
}

struct ChildImportance {
    double value;
    bool doubtful;
};

ChildImportance child_importance(const OracleChild& child, double slack, glm::dvec3 position,
                                 glm::dvec3 normal) {
    const glm::dvec3 middle = 0.5 * (child.lower + child.upper) - position;
    const glm::dvec3 half = 0.5 * (child.upper - child.lower);
    const double distance =
        std::sqrt(std::max(glm::dot(middle, middle) + glm::dot(half, half) / 3.0, 1e-6));

    const double height = glm::dot(normal, middle), height_reach = glm::dot(glm::abs(normal), half);
    const double facing = -glm::dot(child.axis, middle),
                 facing_reach = glm::dot(glm::abs(child.axis), half);
    const double farthest = glm::dot(glm::abs(middle) + half, glm::dvec3(1.0));
    const double turned = (std::cos(child.angle) < 0.01 ? 2.0 : std::sin(child.angle)) * farthest;
    const double highest = height + height_reach, foremost = facing + facing_reach + turned;
    ChildImportance result{0.0, std::abs(highest + slack) < 0.4 * slack ||
                                    std::abs(foremost + slack) < 0.4 * slack};
    if (highest <= -slack || foremost <= -slack) return result;

    const double between = std::acos(std::clamp(facing / distance, -1.0, 1.0));
    const double best = std::cos(std::max(0.0, between - child.angle));
    const double mean = std::cos(between) * (1.0 + std::cos(child.angle)) / 2.0;
    const double light_cosine =
        mean_above(mean, std::max(best - mean, 0.0) + facing_reach / distance);
    const double surface_cosine = mean_above(height / distance, height_reach / distance);
    result.value =
        std::max(child.energy * light_cosine * surface_cosine / (distance * distance), 1e-33);
    return result;
}

} // namespace

std::vector<OracleChild> decode_children(const HierarchyWords& words, uint32_t node) {
    const glm::dvec3 origin(float_of(word_of(words, node, 0)), float_of(word_of(words, node, 4)),
                            float_of(word_of(words, node, 8)));
    glm::dvec3 step;
    for (uint32_t axis = 0; axis < 3; ++axis)
        step[static_cast<glm::length_t>(axis)] =
            std::ldexp(1.0, static_cast<int>(byte_of(words, node, 12 + axis)) - 127);
    const uint32_t inner = byte_of(words, node, 15);
    const uint32_t slots = 4 * words.header.groups;
    uint32_t next_inner = word_of(words, node, 60);
    std::vector<OracleChild> children;
    for (uint32_t i = 0; i < slots; ++i) {
        const uint32_t group = 16 + 48 * (i / 4), in_group = group + i % 4;
        const uint32_t energy = byte_of(words, node, group + 36 + 2 * (i % 4)) |
                                byte_of(words, node, group + 37 + 2 * (i % 4)) << 8;
        if (energy == 0) continue;
        OracleChild child;
        for (uint32_t axis = 0; axis < 3; ++axis) {
            const auto at = static_cast<glm::length_t>(axis);
            child.lower[at] = origin[at] + step[at] * byte_of(words, node, in_group + 4 * axis);
            child.upper[at] =
                origin[at] + step[at] * byte_of(words, node, in_group + 12 + 4 * axis);
        }
        child.axis =
            axis_of(byte_of(words, node, in_group + 24), byte_of(words, node, in_group + 28));
        child.angle = 2.0 * std::asin(byte_of(words, node, in_group + 32) / 255.0);
        child.energy = energy_of(energy);
        child.inner = (inner >> i & 1u) != 0;
        child.node = child.inner ? next_inner++ : 0;
        child.place = (node * slots + i) * words.header.leaf_size;
        child.number = i;
        children.push_back(child);
    }
    return children;
}

std::vector<uint32_t> lights_of_leaf(const HierarchyWords& words, const OracleChild& leaf) {
    std::vector<uint32_t> lights;
    for (uint32_t i = 0; i < words.header.leaf_size; ++i)
        if (words.leaf_lights[leaf.place + i] != shader::NONE)
            lights.push_back(words.leaf_lights[leaf.place + i]);
    return lights;
}

OracleProbabilities oracle_probabilities(const HierarchyWords& words,
                                         std::span<const shader::Light> lights,
                                         const shader::LtcSurface& surface) {
    OracleProbabilities result;
    result.by_light.resize(lights.size(), 0.0);
    if (words.header.light_count == 0) return result;
    const glm::dvec3 position(surface.position), normal(surface.normal);
    struct Visit {
        uint32_t node;
        double probability;
    };
    std::vector<Visit> visits{{0, 1.0}};
    while (!visits.empty()) {
        const Visit visit = visits.back();
        visits.pop_back();
        const std::vector<OracleChild> children = decode_children(words, visit.node);
        // The rounding that shaders grant themselves: a millionth of the coordinates.
        double slack = 0.0;
        for (uint32_t axis = 0; axis < 3; ++axis)
            slack +=
                1e-6 *
                (std::abs(float_of(word_of(words, visit.node, 4 * axis)) -
                          position[static_cast<glm::length_t>(axis)]) +
                 255.0 * std::ldexp(1.0,
                                    static_cast<int>(byte_of(words, visit.node, 12 + axis)) - 127));
        std::vector<double> weights;
        double largest = 0.0, sum = 0.0;
        for (const OracleChild& child : children) {
            const ChildImportance importance = child_importance(child, slack, position, normal);
            result.doubtful |= importance.doubtful;
            weights.push_back(importance.value);
            largest = std::max(largest, importance.value);
        }
        for (double& weight : weights) {
            if (weight > 0.0) weight = std::max(weight, largest / 4096.0);
            sum += weight;
        }
        for (size_t i = 0; i < children.size(); ++i) {
            if (!(weights[i] > 0.0)) continue;
            const double probability = visit.probability * weights[i] / sum;
            if (children[i].inner) {
                visits.push_back({children[i].node, probability});
                continue;
            }
            const std::vector<uint32_t> ids = lights_of_leaf(words, children[i]);
            double all = 0.0;
            for (const uint32_t id : ids)
                all += static_cast<double>(shader::ltc_importance(surface, lights[id], true));
            for (const uint32_t id : ids)
                if (all > 0.0)
                    result.by_light[id] =
                        probability *
                        static_cast<double>(shader::ltc_importance(surface, lights[id], true)) /
                        all;
        }
    }
    return result;
}

} // namespace vigil::test
