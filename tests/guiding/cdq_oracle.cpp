// SPDX-License-Identifier: GPL-2.0-or-later
// See cdq_oracle.h. Every function follows its definition word by word; none of them is fast.
#include "cdq_oracle.h"

#include "shared/guiding_types.h"
#include "vlc_oracle.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <utility>

namespace vigil::test {
namespace {

constexpr size_t max_depth = 12; // of a leaf; directions are stored with as many bits

/// A ray sample, decoded: 12 bits of u, 12 of v, and the contribution in quarters of a power of
/// two, 128 for 1; 0 for nothing.
Path lowest_square(uint32_t ray) {
    Path path;
    for (size_t level = 1; level <= max_depth; ++level) {
        const uint32_t u = ray >> (max_depth - level) & 1u;
        const uint32_t v = ray >> (2 * max_depth - level) & 1u;
        path = child_of(path, static_cast<int>(u + 2 * v));
    }
    return path;
}

double squared_contribution(uint32_t ray) {
    if (ray >> 24 == 0) return 0.0;
    const double contribution = std::exp2((static_cast<double>(ray >> 24) - 128.0) / 4.0);
    return contribution * contribution;
}

/// What the pass takes of stored rays: one in so many that no more than GUIDE_MOST_RAYS are left.
std::vector<StoredRay> taken_rays(const QuadtreeLessons& lessons) {
    size_t one_in = 1;
    while (lessons.rays() > one_in * shader::GUIDE_MOST_RAYS)
        ++one_in;
    std::vector<StoredRay> taken;
    const size_t stored = lessons.stored.size();
    for (const size_t place : sample_places(stored, static_cast<uint32_t>(stored / one_in)))
        taken.push_back(lessons.stored[place]);
    return taken;
}

/// Part of earlier knowledge that is kept.
double kept_part(size_t rays, uint32_t memory) {
    if (memory == 0) return 0.0;
    return std::clamp(1.0 - static_cast<double>(rays) / memory, 0.0, 0.98);
}

Sums sums_of(const Squares& inner, const std::vector<StoredRay>& rays) {
    Sums sums;
    for (const Path& leaf : nodes_of(inner))
        if (!inner.contains(leaf)) sums[leaf] = 0.0;
    for (const auto& [ray, estimate] : rays) {
        const Path square = lowest_square(ray);
        size_t depth = 1;
        while (inner.contains(square.substr(0, depth)))
            ++depth;
        sums.at(square.substr(0, depth)) += squared_contribution(ray);
    }
    return sums;
}

/// The largest power of two that a positive number is a multiple of.
double unit_of(double value) {
    int exponent = 0;
    auto digits = static_cast<uint64_t>(std::ldexp(std::frexp(value, &exponent), 53));
    for (exponent -= 53; digits % 2 == 0; ++exponent)
        digits /= 2;
    return std::ldexp(1.0, exponent);
}

/// Floats add these up without rounding, in any order.
bool are_exact(const Sums& sums) {
    double unit = 1e300, total = 0.0;
    for (const auto& [leaf, sum] : sums) {
        if (sum > 0.0) unit = std::min(unit, unit_of(sum));
        total += sum;
    }
    return total <= std::ldexp(unit, 24);
}

/// A leaf's part in the second moment of all rays, in proportion: its sum over the density of rays
/// there.
double moment_of(const Path& leaf, double sum, const QuadtreeLimits& limits) {
    const double density = std::exp2(2.0 * static_cast<double>(leaf.size()));
    return sum / (density + static_cast<double>(limits.even_density));
}

/// Inner nodes with four leaves, but for the root, and the moments of these.
Sums collapsible(const Squares& inner, const Sums& sums, const QuadtreeLimits& limits) {
    Sums found;
    for (const Path& node : inner) {
        double sum = 0.0;
        int leaves = 0;
        for (int child = 0; child < 4; ++child)
            if (const auto leaf = sums.find(child_of(node, child)); leaf != sums.end()) {
                sum += moment_of(leaf->first, leaf->second, limits);
                ++leaves;
            }
        if (leaves == 4 && !node.empty()) found[node] = sum;
    }
    return found;
}

Sums splittable(const Sums& sums, const QuadtreeLimits& limits) {
    Sums found;
    for (const auto& [leaf, sum] : sums)
        if (leaf.size() < max_depth) found[leaf] = moment_of(leaf, sum, limits);
    return found;
}

/// Slots of nodes: their bits before the first migration. Four children of a node hand theirs on.
using Slots = ByPath<size_t>;

/// Those that may be the largest (`sign` 1) or the least (-1) of sums with a relative `error`. Of
/// equal ones it is the one in the lowest slot, if floats are equal there, too: they are where all
/// are exact, where nothing was brought, and where four leaves are parts of one sum. Other equal
/// sums may come from different samples, whose powers of two a GPU need not round alike.
std::vector<Path> extremes(const Sums& sums, const Slots& slots, double sign, double error,
                           bool& tied) {
    double best = -1e300;
    std::map<size_t, std::pair<Path, double>> in_order;
    for (const auto& [path, sum] : sums) {
        best = std::max(best, sign * sum);
        in_order[slots.at(path)] = {path, sum};
    }
    std::vector<Path> found;
    std::set<std::pair<Path, double>> seen; // of children of one node where there is an error
    for (const auto& [slot, candidate] : in_order) {
        const auto& [path, sum] = candidate;
        if (best - sign * sum > 2.0 * error * std::abs(best)) continue;
        const bool parts = error > 0.0 && sum > 0.0;
        if (seen.emplace(parts ? path.substr(0, path.size() - 1) : Path(), sum).second)
            found.push_back(path);
        else
            tied |= sum > 0.0;
    }
    return found;
}

void migrate(Squares& inner, Sums& sums, Slots& slots, const Path& collapsed, const Path& split) {
    double collapsed_sum = 0.0;
    for (int child = 0; child < 4; ++child) {
        collapsed_sum += sums.at(child_of(collapsed, child));
        sums.erase(child_of(collapsed, child));
        slots[child_of(split, child)] = slots.at(child_of(collapsed, child));
        slots.erase(child_of(collapsed, child));
    }
    // Where in the leaf its samples lay is not asked again.
    for (int child = 0; child < 4; ++child)
        sums[child_of(split, child)] = sums.at(split) / 4.0;
    sums.erase(split);
    sums[collapsed] = collapsed_sum;
    inner.erase(collapsed);
    inner.insert(split);
}

/// Adds to `result` all trees that up to `limits.migrations` further migrations lead to.
void follow(const AdaptedQuadtree& tree, const Sums& sums, const Slots& slots,
            const QuadtreeLimits& limits, double error, AdaptedQuadtrees& result) {
    if (error == 0.0) result.exact &= are_exact(sums);
    const Sums inner = collapsible(tree.inner, sums, limits), leaves = splittable(sums, limits);
    if (tree.migrations == limits.migrations || inner.empty() || leaves.empty()) {
        result.allowed.emplace(tree, sums);
        return;
    }
    for (const Path& leaf : extremes(leaves, slots, 1.0, error, result.tied))
        for (const Path& node : extremes(inner, slots, -1.0, error, result.tied)) {
            // A product of floats, rounded once.
            const double gained = static_cast<float>(leaves.at(leaf)) * limits.margin;
            const double lost = inner.at(node);
            // No part of a sum is larger than it, however it is rounded.
            const bool own_child = leaf.starts_with(node);
            if (!own_child && gained * (1.0 + error) > lost * (1.0 - error)) {
                AdaptedQuadtree next = tree;
                Sums moved = sums;
                Slots handed_on = slots;
                migrate(next.inner, moved, handed_on, node, leaf);
                ++next.migrations;
                follow(next, moved, handed_on, limits, error, result);
            }
            if (own_child || gained * (1.0 - error) <= lost * (1.0 + error))
                result.allowed.emplace(tree, sums);
        }
}

/// Relative error of a sum of `count` squared contributions: Vulkan lets exp2(x) be wrong by 3 + 2
/// |x| units in the last place, |x| is 32 at most, and products and sums round.
double error_of(size_t count) {
    return std::ldexp(static_cast<double>(count) + 2.0 * (3.0 + 2.0 * 32.0) + 8.0, -23);
}

} // namespace

size_t QuadtreeLessons::rays() const {
    return blank + stored.size();
}

std::vector<Path> nodes_of(const Squares& inner) {
    std::vector<Path> nodes;
    for (const Path& node : inner)
        for (int child = 0; child < 4; ++child)
            nodes.push_back(child_of(node, child));
    return nodes;
}

glm::uvec4 field_of(const Squares& inner) {
    glm::uvec4 field(0);
    int bit = 0;
    for (const Path& node : nodes_of(inner)) {
        if (inner.contains(node)) field[bit / 32] |= 1u << bit % 32;
        ++bit;
    }
    return field;
}

std::optional<Squares> squares_of(glm::uvec4 field, uint32_t bits) {
    std::vector<Path> nodes = {"0", "1", "2", "3"};
    Squares inner{""};
    for (uint32_t bit = 0; bit < 128; ++bit) {
        if ((field[static_cast<int>(bit / 32)] >> bit % 32 & 1u) == 0) continue;
        if (bit >= nodes.size() || nodes[bit].size() == max_depth) return std::nullopt;
        inner.insert(nodes[bit]);
        for (int child = 0; child < 4; ++child)
            nodes.push_back(child_of(nodes[bit], child));
    }
    if (nodes.size() != bits) return std::nullopt;
    return inner;
}

AdaptedQuadtrees adapt_quadtree(const Squares& inner, const QuadtreeLessons& lessons,
                                const QuadtreeLimits& limits) {
    const std::vector<StoredRay> taken = taken_rays(lessons);
    Sums sums = sums_of(inner, taken);
    const double kept = kept_part(lessons.rays(), limits.memory);
    for (const auto& [leaf, sum] : lessons.remembered)
        sums.at(leaf) += kept * sum;
    AdaptedQuadtrees result;
    Slots slots;
    for (const Path& node : nodes_of(inner))
        slots.emplace(node, slots.size());
    // Only division by a power of two is exact.
    if (limits.even_density == 0.0f && kept == 0.0) {
        follow({inner, 0}, sums, slots, limits, 0.0, result);
        if (result.exact) return result;
    }
    result = {};
    result.exact = false;
    result.error = error_of(taken.size());
    follow({inner, 0}, sums, slots, limits, result.error, result);
    return result;
}

ShareState adapt_share(const ShareState& shared, const QuadtreeLessons& lessons, uint32_t memory,
                       double first) {
    const double used = shared.rays > 0.0 ? shared.share : first;
    double plain = 0.0, guided = 0.0, by_brdf = 0.0;
    for (const auto& [ray, estimate] : taken_rays(lessons)) {
        const double square = static_cast<double>(std::bit_cast<float>(estimate << 16));
        const double part = static_cast<double>(std::bit_cast<float>(estimate & 0xffff0000u));
        plain += square * (1.0 - part);
        guided += square * part;
        by_brdf += square * (1.0 - used) / std::max(1.0 - part, 1e-3);
    }
    const auto rays = static_cast<double>(lessons.rays());
    const double kept = 1.0 - 0.25 * (1.0 - kept_part(lessons.rays(), memory));
    ShareState after;
    after.plain = kept * shared.plain + (1.0 - used) * plain;
    after.guided = kept * shared.guided + used * guided;
    after.rays = kept * shared.rays + rays;
    after.plain_spread = std::sqrt(by_brdf * rays);
    after.guided_spread = std::sqrt((plain + guided) * rays);
    const double all = std::sqrt(after.guided) + std::sqrt(after.plain);
    const double best = all > 0.0 ? std::sqrt(after.guided) / all : first;
    const double trust = after.rays / (after.rays + 32.0);
    after.share =
        std::clamp(std::floor(16.0 * (first + trust * (best - first)) + 0.5) / 16.0, 0.125, 0.75);
    return after;
}

} // namespace vigil::test
