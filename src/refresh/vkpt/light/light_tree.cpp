// SPDX-License-Identifier: GPL-2.0-or-later
// Top-down build: lights are binned by the middle of their boxes along each axis, cut where the
// heuristic is least, and partitioned in place. A subtree of n lights has its 2 n - 1 nodes to
// itself, so both sides of a cut can be built at the same time and nothing is allocated.
#include "refresh/vkpt/light/light_tree.h"

#include "refresh/vkpt/light/light_power.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <future>
#include <limits>
#include <optional>

namespace vigil {

namespace {

constexpr std::uint32_t MOST_BINS = 16;
constexpr std::uint32_t HALVED_DEPTH =
    64; // deeper nodes are halved by count, which bounds the depth
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
    if ((light.flags & shader::LIGHT_SUN) != 0) return std::nullopt; // it is nowhere
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
    result.unused = 0.0f;
    result.id = id;
    return result;
}

/// Four floats in one register, by an extension that GCC and Clang share.
using Lanes [[gnu::vector_size(16)]] = float;

Lanes load(const float* row) {
    Lanes lanes;
    std::memcpy(&lanes, row, sizeof(lanes));
    return lanes;
}
Lanes lower_of(Lanes a, Lanes b) {
    return a < b ? a : b;
}
Lanes upper_of(Lanes a, Lanes b) {
    return a > b ? a : b;
}
glm::vec3 to_vec3(Lanes lanes) {
    return {lanes[0], lanes[1], lanes[2]};
}

/// A light's rows.
Lanes lower_row(const TreeLight& light) {
    return load(&light.lower.x);
}
Lanes upper_row(const TreeLight& light) {
    return load(&light.upper.x);
}
Lanes sum_row(const TreeLight& light) {
    return load(&light.normal.x);
}
static_assert(offsetof(TreeLight, upper) == 16 && offsetof(TreeLight, normal) == 32);

/// Middle of the light's box.
Lanes middle(const TreeLight& light) {
    return 0.5f * lower_row(light) + 0.5f * upper_row(light);
}

constexpr float INFINITE = std::numeric_limits<float>::infinity();

struct Box {
    Lanes lower{INFINITE, INFINITE, INFINITE, INFINITE};
    Lanes upper{-INFINITE, -INFINITE, -INFINITE, -INFINITE};

    void add(Lanes other_lower, Lanes other_upper) {
        lower = lower_of(lower, other_lower);
        upper = upper_of(upper, other_upper);
    }
};

/// What is known of a set of lights, and can be added up.
struct Cluster {
    Box box;
    Lanes sum{0.0f, 0.0f, 0.0f, 0.0f}; // of the normals, and of the energies
    std::uint32_t count = 0;

    float energy() const { return sum[3]; }
    void add(const TreeLight& light) {
        box.add(lower_row(light), upper_row(light));
        sum += sum_row(light);
        count += 1;
    }
    void add(const Cluster& other) {
        box.add(other.box.lower, other.box.upper);
        sum += other.sum;
        count += other.count;
    }
};

/// Area of a box, with a trace of its squared diagonal, so that lights in a line have one.
float box_area(const Box& box) {
    const Lanes e = box.upper - box.lower;
    return e[0] * e[1] + e[1] * e[2] + e[2] * e[0] +
           1e-3f * (e[0] * e[0] + e[1] * e[1] + e[2] * e[2]);
}

/// The orientation measure of the heuristic for Lambertian emitters whose normals have a sum of
/// this length, per light: the solid angle they shine into, weighted by the cosine beyond the cone
/// of their normals. The half angle of the cone is taken from `mean_length`: evenly filled, its
/// cosine is twice that minus 1. Between pi (one normal) and 4 pi.
float orientation_measure(float mean_length) {
    const float cosine = std::clamp(2.0f * mean_length - 1.0f, -1.0f, 1.0f);
    const float sine = std::sqrt(1.0f - cosine * cosine);
    // 2 pi (1 - cos) + pi / 2 (2 w sin - cos(a - 2 w) - 2 a sin + cos), where w = min(a + pi / 2,
    // pi).
    if (cosine >= 0.0f) return PI * (2.0f - cosine) + 0.5f * PI * PI * sine;
    // b sin(b) for b = pi - a up to 1.6% off.
    const float rest = 1.0f + cosine;
    return 2.0f * PI * (1.0f - cosine) + PI * rest * (2.0f - 0.43f * rest);
}

/// Energy times area times orientation; `scale` keeps energies near 1.
float measure(const Cluster& cluster, float scale) {
    const float mean_length = glm::length(to_vec3(cluster.sum)) / static_cast<float>(cluster.count);
    return cluster.energy() * scale * box_area(cluster.box) * orientation_measure(mean_length);
}

/// Maps middles to bins along the three axes; the same arithmetic bins and partitions.
class Binning {
public:
    using Bins [[gnu::vector_size(16)]] = int;

    /// `middles` is the box around them.
    Binning(const Box& middles, std::uint32_t bins)
        : lower_(middles.lower), scale_{}, last_(static_cast<int>(bins) - 1) {
        for (int axis = 0; axis < 3; ++axis) {
            const float extent = middles.upper[axis] - middles.lower[axis];
            const float scale = static_cast<float>(bins) * 0.9999f / extent;
            scale_[axis] = extent > 0.0f && std::isfinite(scale) ? scale : 0.0f;
        }
    }
    std::uint32_t bins() const { return static_cast<std::uint32_t>(last_) + 1; }
    bool usable(int axis) const { return scale_[axis] > 0.0f; }
    /// Numbers of the bins along each axis.
    Bins bins_of(const TreeLight& light) const {
        const Bins numbers = __builtin_convertvector((middle(light) - lower_) * scale_, Bins);
        const Bins last{last_, last_, last_, last_};
        return numbers < last ? numbers : last;
    }

private:
    Lanes lower_, scale_;
    int last_;
};

struct Split {
    float cost = INFINITE;
    int axis = 0;
    int position = 0; // first bin of the right side; 0: no cut parts them
};

/// `all` is what is known of all of the lights.
Split best_split(std::span<const TreeLight> lights, const Binning& binning, const Cluster& all) {
    std::array<std::array<Cluster, MOST_BINS>, 3> bins;
    const auto count = binning.bins();
    for (auto& along : bins)
        std::fill_n(along.begin(), count, Cluster());
    for (const TreeLight& light : lights) {
        const Binning::Bins number = binning.bins_of(light);
        for (int axis = 0; axis < 3; ++axis)
            bins[axis][number[axis]].add(light);
    }
    const Lanes extent = all.box.upper - all.box.lower;
    const float longest = std::max(extent[0], std::max(extent[1], extent[2]));
    const float scale = 1.0f / all.energy();
    Split best;
    for (int axis = 0; axis < 3; ++axis) {
        if (!binning.usable(axis)) continue;
        // Sweep from the right to know every right side, then from the left to evaluate. A cut
        // beside an empty bin is the one before it. Thin boxes are not cut across their thin side.
        const float thin = longest / std::max(extent[axis], 1e-3f * longest);
        std::array<float, MOST_BINS> right_cost;
        Cluster side;
        for (std::uint32_t i = count; i-- > 1;) {
            if (bins[axis][i].count == 0) continue;
            side.add(bins[axis][i]);
            right_cost[i] = measure(side, scale);
        }
        side = bins[axis][0]; // the first bin always holds a light, and so does the last
        for (std::uint32_t i = 1; i < count; ++i) {
            if (bins[axis][i].count == 0) continue;
            const float cost = thin * (measure(side, scale) + right_cost[i]);
            if (cost < best.cost) best = {cost, axis, static_cast<int>(i)};
            side.add(bins[axis][i]);
        }
    }
    return best;
}

/// Reorders two or more lights into a left and a right part; returns the size of the left one.
/// `middles` is the box around the middles of the lights.
std::uint32_t partition(std::span<TreeLight> lights, const Cluster& all, const Box& middles,
                        std::uint32_t depth) {
    const auto count = static_cast<std::uint32_t>(lights.size());
    if (depth >= HALVED_DEPTH) return count / 2;
    const Binning binning(middles, std::min(MOST_BINS, count + 1)); // few lights need few bins
    const Split split = best_split(lights, binning, all);
    if (split.position == 0) return count / 2; // all in one place
    const auto end = std::partition(lights.begin(), lights.end(), [&](const TreeLight& light) {
        return binning.bins_of(light)[split.axis] < split.position;
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
    build_node(0, 0, count, 1);
}

void LightTree::build_node(std::uint32_t number, std::uint32_t first, std::uint32_t count,
                           std::uint32_t depth) {
    const std::span<TreeLight> lights(lights_.data() + first, count);
    Cluster all;
    Box middles;
    for (const TreeLight& light : lights) {
        all.add(light);
        middles.add(middle(light), middle(light));
    }
    LightTreeNode& node = nodes_[number];
    node = {to_vec3(all.box.lower),
            to_vec3(all.box.upper),
            to_vec3(all.sum),
            all.energy(),
            first,
            count,
            0};
    if (count <= leaf_size_) return;
    const std::uint32_t left = partition(lights, all, middles, depth);
    node.right = number + 2 * left;
    const auto build_left = [&] { build_node(number + 1, first, left, depth + 1); };
    const auto build_right = [&] { build_node(node.right, first + left, count - left, depth + 1); };
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
