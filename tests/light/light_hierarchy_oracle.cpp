// SPDX-License-Identifier: GPL-2.0-or-later
#include "light_hierarchy_oracle.h"

#include <algorithm>
#include <cmath>

namespace vigil::test {

namespace {

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
    return std::ldexp(1.0 + (code & 3) / 4.0, static_cast<int>(code >> 2) - 63) -
           std::ldexp(1.0, -63);
}

double signed_byte(uint32_t byte) {
    return byte < 128 ? byte : byte - 256.0;
}

/// Mean of max(x, 0) over an interval.
double mean_above(double middle, double reach) {
    if (middle >= reach) return middle;
    const double top = middle + reach;
    return top <= 0.0 ? 0.0 : top * top / (4.0 * reach);
}

/// By how much single precision may be off, as a part of the largest coordinate: 6e-8 in each of a
/// dozen operations, a few times that in Vulkan's divisions and roots.
constexpr double rounding = 4e-6;

/// What an error of `slack` in both numbers does to that mean, as a part of it.
double mean_error(double middle, double reach, double slack) {
    if (middle >= reach) return slack / middle;
    return 2.0 * slack / (middle + reach) + slack / reach;
}

struct ChildImportance {
    double value;
    double error; // by which single precision may be off, as a part of the value
    bool doubtful;
};

/// `reach`: no coordinate in the node is larger.
ChildImportance child_importance(const OracleChild& child, double reach, glm::dvec3 position,
                                 glm::dvec3 normal) {
    const glm::dvec3 middle = 0.5 * (child.lower + child.upper) - position;
    const glm::dvec3 half = 0.5 * (child.upper - child.lower);
    const double squared =
        std::max(glm::dot(middle, middle) + glm::dot(half, half) / 3.0, 1e-8 * reach * reach);

    const double height = glm::dot(normal, middle), height_reach = glm::dot(glm::abs(normal), half);
    const double facing = -glm::dot(child.axis, middle),
                 facing_reach = glm::dot(glm::abs(child.axis), half);
    const double farthest = glm::dot(glm::abs(middle) + half, glm::dvec3(1.0));
    const double turned = child.spread * farthest;
    const double slack = 1e-6 * reach;
    const double highest = height + height_reach, foremost = facing + facing_reach + turned;
    ChildImportance result{0.0, 0.0,
                           std::abs(highest + slack) < 0.4 * slack ||
                               std::abs(foremost + slack) < 0.4 * slack};
    if (highest <= -slack || foremost <= -slack) return result;

    const double mean = facing * (1.0 - child.spread * child.spread / 4.0);
    const double mean_reach = facing_reach + 0.4 * turned;
    const double per_energy =
        mean_above(height, height_reach) * mean_above(mean, mean_reach) / (squared * squared);
    const double least = 1e-15 / (reach * reach), off = rounding * reach;
    result.value = child.energy * std::max(per_energy, least);
    if (per_energy > least)
        result.error = mean_error(height, height_reach, off) + mean_error(mean, mean_reach, off) +
                       4.0 * off / std::sqrt(squared);
    return result;
}

struct LightImportance {
    double value;
    double error;
};

/// By how much form factors by contours may be off, on each of two devices
/// (tests/numerics/lights_test.cpp).
constexpr double contour_rounding = 2.0 * 3e-6;

/// Whether form_factor() goes by the contour of this light, not by points on it.
bool by_contour(const shader::Light& light, const shader::LtcSurface& surface) {
    const glm::vec3 v0 = light.v0 - surface.position, normal = surface.normal;
    const glm::vec3 height = glm::dot(normal, v0) + glm::vec3(0.0f, glm::dot(normal, light.e1),
                                                              glm::dot(normal, light.e2));
    const float facing = shader::light_facing(light, surface.position);
    return shader::form_factor(normal, v0, light.e1, light.e2, facing) !=
           shader::point_form_factor(v0, light.e1, light.e2, height, facing).x;
}

/// The importance that shaders give a light of a leaf. Its error is what happens to it where single
/// precision moves the surface a little, and what contours have of their own.
LightImportance light_importance(const shader::Light& light, const shader::LtcSurface& surface) {
    float farthest = 0.0f;
    for (const glm::vec3 corner : {light.v0, light.v0 + light.e1, light.v0 + light.e2})
        farthest = std::max(farthest, glm::distance(corner, surface.position));
    const auto value_at = [&](glm::vec3 offset) {
        shader::LtcSurface moved = surface;
        moved.position += 2.0f * static_cast<float>(rounding) * farthest * offset;
        return static_cast<double>(shader::ltc_importance(moved, light, true));
    };
    LightImportance result{value_at(glm::vec3(0.0f)), 0.0};
    for (const glm::vec3 side :
         {surface.normal, glm::vec3(1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(0, 0, 1)})
        for (const float sign : {-1.0f, 1.0f})
            result.error = std::max(result.error, std::abs(value_at(sign * side) - result.value));
    if (result.value > 0.0 && by_contour(light, surface))
        result.error += contour_rounding *
                        static_cast<double>(surface.diffuse * shader::luminance(light.radiance));
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
        const uint32_t in_group = 16 + 48 * (i / 4) + i % 4;
        const uint32_t energy = byte_of(words, node, in_group + 40);
        if (energy == 0) continue;
        OracleChild child;
        for (uint32_t axis = 0; axis < 3; ++axis) {
            const auto at = static_cast<glm::length_t>(axis);
            const double middle = byte_of(words, node, in_group + 4 * axis);
            const double half = 0.5 * byte_of(words, node, in_group + 12 + 4 * axis);
            child.lower[at] = origin[at] + step[at] * (middle - half);
            child.upper[at] = origin[at] + step[at] * (middle + half);
            child.axis[at] = signed_byte(byte_of(words, node, in_group + 24 + 4 * axis)) / 127.0;
        }
        child.spread = byte_of(words, node, in_group + 36) / 127.0;
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
    result.errors.resize(lights.size(), 0.0);
    if (words.header.light_count == 0) return result;
    const glm::dvec3 position(surface.position), normal(surface.normal);
    struct Visit {
        uint32_t node;
        double probability, error;
    };
    std::vector<Visit> visits{{0, 1.0, 0.0}};
    while (!visits.empty()) {
        const Visit visit = visits.back();
        visits.pop_back();
        const std::vector<OracleChild> children = decode_children(words, visit.node);
        double reach = 0.0;
        for (uint32_t axis = 0; axis < 3; ++axis) {
            const double step =
                std::ldexp(1.0, static_cast<int>(byte_of(words, visit.node, 12 + axis)) - 127);
            reach += std::abs(float_of(word_of(words, visit.node, 4 * axis)) -
                              position[static_cast<glm::length_t>(axis)]) +
                     255.0 * step;
        }
        std::vector<double> weights, errors;
        double largest = 0.0, sum = 0.0;
        for (const OracleChild& child : children) {
            const ChildImportance importance = child_importance(child, reach, position, normal);
            result.doubtful |= importance.doubtful;
            weights.push_back(importance.value);
            errors.push_back(importance.error);
            largest = std::max(largest, importance.value);
        }
        for (double& weight : weights) {
            if (weight > 0.0) weight = std::max(weight, largest / 4096.0);
            sum += weight;
        }
        double sum_error = 0.0;
        for (size_t i = 0; i < children.size(); ++i)
            if (weights[i] > 0.0) sum_error += weights[i] / sum * errors[i];
        for (size_t i = 0; i < children.size(); ++i) {
            if (!(weights[i] > 0.0)) continue;
            const double probability = visit.probability * weights[i] / sum;
            const double error = visit.error + errors[i] + sum_error;
            if (children[i].inner) {
                visits.push_back({children[i].node, probability, error});
                continue;
            }
            const std::vector<uint32_t> ids = lights_of_leaf(words, children[i]);
            double all = 0.0, all_errors = 0.0;
            std::vector<LightImportance> importances;
            for (const uint32_t id : ids) {
                importances.push_back(light_importance(lights[id], surface));
                all += importances.back().value;
                all_errors += importances.back().error;
            }
            for (size_t k = 0; k < ids.size(); ++k) {
                if (!(all > 0.0)) break;
                const auto& [value, own_error] = importances[k];
                result.by_light[ids[k]] = probability * value / all;
                result.errors[ids[k]] =
                    probability * (error * value + own_error + value / all * all_errors) / all;
            }
        }
    }
    return result;
}

} // namespace vigil::test
