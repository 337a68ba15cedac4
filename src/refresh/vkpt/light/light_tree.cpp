// SPDX-License-Identifier: GPL-2.0-or-later
// Top-down build: lights are binned by the middle of their boxes along each axis, cut where the heuristic
// is least, and partitioned in place. A subtree of n lights has its 2 n - 1 nodes to itself, so both sides of a cut can be
// built at the same time and nothing is allocated.
#include "refresh/vkpt/light/light_tree.h"

#include "refresh/vkpt/light/light_power.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <future>
#include <limits>
#include <optional>

namespace vigil {

namespace {

constexpr std::uint32_t MOST_BINS = 16;
constexpr std::uint32_t HALVED_DEPTH = 64; // deeper nodes are halved by count, which bounds the depth
constexpr std::uint32_t PARALLEL_LIGHTS = 4096;
constexpr float PI = 3.14159265f;

/// The nearest single-precision box around double-precision points.
float round_down(double value) {
    const auto rounded = static_cast<float>(value);
    return static_cast<double>(rounded) > value
               ? std::nextafter(rounded, -std::numeric_limits<float>::infinity())
               : rounded;
}
float round_up(double value) {
    return -round_down(-value);
}

/// How far off the line along its unit `direction` single precision may compute the cross product
/// of two vectors: 2^-23 of the products in each component. 0 if these are along an axis.
float cross_error(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& direction) {
    const glm::dvec3 products(std::abs(a.y * b.z) + std::abs(a.z * b.y),
                              std::abs(a.z * b.x) + std::abs(a.x * b.z),
                              std::abs(a.x * b.y) + std::abs(a.y * b.x));
    const glm::dvec3 across = glm::sqrt(glm::max(1.0 - direction * direction, glm::dvec3(0.0)));
    return static_cast<float>(1.2e-7 * glm::dot(products, across));
}

/// The light as the tree sees it; nothing if it can never light anything.
std::optional<TreeLight> make_tree_light(const shader::Light& light, std::uint32_t id) {
    if (!(shader::luminance(light.radiance) > 0.0f)) return std::nullopt;
    const glm::dvec3 v0(light.v0), e1(light.e1), e2(light.e2);
    const glm::dvec3 across = glm::cross(e1, e2);
    const double length = glm::length(across);
    if (!(length > 0.0) || !std::isfinite(length)) return std::nullopt;
    const glm::dvec3 lower = glm::min(v0, glm::min(v0 + e1, v0 + e2));
    const glm::dvec3 upper = glm::max(v0, glm::max(v0 + e1, v0 + e2));
    TreeLight result;
    for (glm::length_t axis = 0; axis < 3; ++axis) {
        result.lower[axis] = round_down(lower[axis]);
        result.upper[axis] = round_up(upper[axis]);
        if (!std::isfinite(result.lower[axis]) || !std::isfinite(result.upper[axis]))
            return std::nullopt;
    }
    result.normal = glm::vec3(across / length);
    result.normal_error = cross_error(e1, e2, across / length) / static_cast<float>(length);
    result.energy = std::max(light_power(light), 1e-30f);
    result.id = id;
    return result;
}

/// What is known of a set of lights, and can be added up.
struct Cluster {
    glm::vec3 lower{std::numeric_limits<float>::infinity()};
    glm::vec3 upper{-std::numeric_limits<float>::infinity()};
    glm::vec3 normal_sum{0.0f};
    float energy = 0.0f;
    std::uint32_t count = 0;

    void add(const TreeLight& light) {
        lower = glm::min(lower, light.lower);
        upper = glm::max(upper, light.upper);
        normal_sum += light.normal;
        energy += light.energy;
        count += 1;
    }
    void add(const Cluster& other) {
        lower = glm::min(lower, other.lower);
        upper = glm::max(upper, other.upper);
        normal_sum += other.normal_sum;
        energy += other.energy;
        count += other.count;
    }
};

/// Area of a box, with a trace of its squared diagonal, so that lights in a line have one.
float box_area(const glm::vec3& lower, const glm::vec3& upper) {
    const glm::vec3 e = upper - lower;
    return e.x * e.y + e.y * e.z + e.z * e.x + 1e-3f * glm::dot(e, e);
}

/// The orientation measure of the heuristic for Lambertian emitters whose normals have a sum of this
/// length, per light: the solid angle they shine into, weighted by the cosine beyond the cone of their
/// normals. The half angle of the cone is taken from `mean_length`: evenly filled, its cosine
/// is twice that minus 1. Between pi (one normal) and 4 pi.
float orientation_measure(float mean_length) {
    const float cosine = std::clamp(2.0f * mean_length - 1.0f, -1.0f, 1.0f);
    const float sine = std::sqrt(1.0f - cosine * cosine);
    // 2 pi (1 - cos) + pi / 2 (2 w sin - cos(a - 2 w) - 2 a sin + cos), where w = min(a + pi / 2, pi).
    if (cosine >= 0.0f) return PI * (2.0f - cosine) + 0.5f * PI * PI * sine;
    // b sin(b) for b = pi - a up to 1.6% off.
    const float rest = 1.0f + cosine;
    return 2.0f * PI * (1.0f - cosine) + PI * rest * (2.0f - 0.43f * rest);
}

/// Energy times area times orientation; `scale` keeps energies near 1.
float measure(const Cluster& cluster, float scale) {
    const float mean_length = glm::length(cluster.normal_sum) / static_cast<float>(cluster.count);
    return cluster.energy * scale * box_area(cluster.lower, cluster.upper) *
           orientation_measure(mean_length);
}

glm::vec3 middle(const TreeLight& light) {
    return 0.5f * light.lower + 0.5f * light.upper;
}

/// Maps middles to bins along the three axes; the same arithmetic bins and partitions.
class Binning {
public:
    Binning(const glm::vec3& lower, const glm::vec3& upper, std::uint32_t bins)
        : lower_(lower), bins_(bins) {
        for (glm::length_t axis = 0; axis < 3; ++axis) {
            const float extent = upper[axis] - lower[axis];
            scale_[axis] = extent > 0.0f ? static_cast<float>(bins) * 0.9999f / extent : 0.0f;
            if (!std::isfinite(scale_[axis])) scale_[axis] = 0.0f;
        }
    }
    std::uint32_t bins() const { return bins_; }
    bool usable(glm::length_t axis) const { return scale_[axis] > 0.0f; }
    std::uint32_t bin(const glm::vec3& middle, glm::length_t axis) const {
        const auto number = static_cast<int>((middle[axis] - lower_[axis]) * scale_[axis]);
        return std::min(static_cast<std::uint32_t>(std::max(number, 0)), bins_ - 1);
    }

private:
    glm::vec3 lower_, scale_{0.0f};
    std::uint32_t bins_;
};

struct Split {
    float cost = std::numeric_limits<float>::infinity();
    glm::length_t axis = 0;
    std::uint32_t position = 0; // first bin of the right side; 0: no cut parts them
};

/// `scale` brings energies near 1; `extent` is that of the whole box.
Split best_split(std::span<const TreeLight> lights, const Binning& binning, const glm::vec3& extent,
                 float scale) {
    std::array<std::array<Cluster, MOST_BINS>, 3> bins;
    for (const TreeLight& light : lights) {
        const glm::vec3 at = middle(light);
        for (glm::length_t axis = 0; axis < 3; ++axis)
            bins[axis][binning.bin(at, axis)].add(light);
    }
    const float longest = std::max(extent.x, std::max(extent.y, extent.z));
    Split best;
    for (glm::length_t axis = 0; axis < 3; ++axis) {
        if (!binning.usable(axis)) continue;
        // Sweep from the right to know every right side, then from the left to evaluate. Thin boxes
        // are not cut across their thin side.
        const float thin = longest / std::max(extent[axis], 1e-3f * longest);
        std::array<float, MOST_BINS> right_cost;
        Cluster side;
        for (std::uint32_t i = binning.bins(); i-- > 1;) {
            side.add(bins[axis][i]);
            right_cost[i] = side.count > 0 ? measure(side, scale) : 0.0f;
        }
        side = Cluster{};
        for (std::uint32_t i = 1; i < binning.bins(); ++i) {
            side.add(bins[axis][i - 1]);
            if (side.count == 0 || side.count == lights.size()) continue;
            const float cost = thin * (measure(side, scale) + right_cost[i]);
            if (cost < best.cost) best = {cost, axis, i};
        }
    }
    return best;
}

/// Reorders two or more lights into a left and a right part; returns the size of the left one.
std::uint32_t partition(std::span<TreeLight> lights, const Cluster& all, const glm::vec3& lower,
                        const glm::vec3& upper, std::uint32_t depth) {
    const auto half = static_cast<std::uint32_t>(lights.size() / 2);
    if (depth >= HALVED_DEPTH) return half;
    // Few lights need few bins.
    const std::uint32_t bins = std::min(MOST_BINS, 2 * static_cast<std::uint32_t>(lights.size()));
    const Binning binning(lower, upper, bins);
    const Split split = best_split(lights, binning, all.upper - all.lower, 1.0f / all.energy);
    if (split.position == 0) return half; // all in one place
    const auto end = std::partition(lights.begin(), lights.end(), [&](const TreeLight& light) {
        return binning.bin(middle(light), split.axis) < split.position;
    });
    return static_cast<std::uint32_t>(end - lights.begin());
}

} // namespace

void LightTree::build(std::span<const shader::Light> lights, std::uint32_t leaf_size) {
    leaf_size_ = std::max(leaf_size, 1u);
    lights_.clear();
    lights_.reserve(lights.size());
    for (std::uint32_t id = 0; id < lights.size(); ++id)
        if (const std::optional<TreeLight> light = make_tree_light(lights[id], id))
            lights_.push_back(*light);
    const auto count = static_cast<std::uint32_t>(lights_.size());
    nodes_.resize(count > 0 ? 2 * size_t{count} - 1 : 0);
    if (count == 0) return;
    float energy = 0.0f;
    for (const TreeLight& light : lights_)
        energy += light.energy;
    scale_ = 1.0f / energy;
    build_node(0, 0, count, 1);
}

void LightTree::build_node(std::uint32_t number, std::uint32_t first, std::uint32_t count,
                           std::uint32_t depth) {
    const std::span<TreeLight> lights(lights_.data() + first, count);
    Cluster all;
    glm::vec3 lower(std::numeric_limits<float>::infinity()), upper = -lower; // of the middles
    for (const TreeLight& light : lights) {
        all.add(light);
        lower = glm::min(lower, middle(light));
        upper = glm::max(upper, middle(light));
    }
    LightTreeNode& node = nodes_[number];
    node = {all.lower, all.upper, all.normal_sum, all.energy, measure(all, scale_),
            first,     count,     0};
    if (count <= leaf_size_) return;
    const std::uint32_t left = partition(lights, all, lower, upper, depth);
    node.right = number + 2 * left;
    const auto build_left = [&] { build_node(number + 1, first, left, depth + 1); };
    const auto build_right = [&] {
        build_node(node.right, first + left, count - left, depth + 1);
    };
    if (depth <= 2 && count >= PARALLEL_LIGHTS) {
        std::future<void> other = std::async(std::launch::async, build_left);
        build_right();
        other.get();
    } else {
        build_left();
        build_right();
    }
}

} // namespace vigil
