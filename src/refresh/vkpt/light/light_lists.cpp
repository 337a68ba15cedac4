// SPDX-License-Identifier: GPL-2.0-or-later
// Light lists from the node tree and the PVS: place each light, join the PVS rows of its clusters,
// take away the clusters behind it, and turn "light -> clusters" into "cluster -> lights".
#include "refresh/vkpt/light/light_lists.h"

#include "formats/bsp.h"
#include "level/pvs.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <fmt/format.h>
#include <limits>
#include <utility>

namespace vigil {
namespace {

/// Corners this close to a plane (map units) touch both of its sides; triangles that stay this
/// close lie in it.
constexpr float on_plane = 1.0f / 32.0f;

/// Leaf bounds are rounded to whole units in the file, and a point is looked up half a unit off its
/// surface.
constexpr float box_margin = 2.0f;

/// A convex piece of a triangle; each plane it is clipped by adds at most one corner.
using Polygon = std::vector<glm::vec3>;

struct PlaneSides {
    float lowest = std::numeric_limits<float>::max();
    float highest = std::numeric_limits<float>::lowest();
};

PlaneSides classify(const Polygon& polygon, const BspPlane& plane) {
    PlaneSides sides;
    for (const glm::vec3& corner : polygon) {
        const float distance = glm::dot(plane.normal, corner) - plane.dist;
        sides.lowest = std::min(sides.lowest, distance);
        sides.highest = std::max(sides.highest, distance);
    }
    return sides;
}

/// The part of a polygon where side * (dot(normal, p) - dist) >= 0.
Polygon clip(const Polygon& polygon, const BspPlane& plane, float side) {
    Polygon part;
    part.reserve(polygon.size() + 1);
    for (size_t i = 0; i < polygon.size(); ++i) {
        const glm::vec3 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
        const float da = side * (glm::dot(plane.normal, a) - plane.dist);
        const float db = side * (glm::dot(plane.normal, b) - plane.dist);
        if (da >= 0.0f) part.push_back(a);
        if ((da > 0.0f && db < 0.0f) || (da < 0.0f && db > 0.0f))
            part.push_back(a + (b - a) * (da / (da - db)));
    }
    return part;
}

void sort_unique(std::vector<uint32_t>& values) {
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
}

template <typename Visit> void for_each_bit(std::span<const uint64_t> words, Visit visit) {
    for (size_t w = 0; w < words.size(); ++w)
        for (uint64_t bits = words[w]; bits != 0; bits &= bits - 1)
            visit(static_cast<uint32_t>(w * 64) + static_cast<uint32_t>(std::countr_zero(bits)));
}

/// 64 rows of 64 bits: bit b of row a becomes bit a of row b.
using BitBlock = std::array<uint64_t, 64>;

void transpose(BitBlock& block) {
    // Swap the two quarters off the diagonal, then within each quarter those of half the size.
    uint64_t low_half = 0x00000000ffffffff;
    for (uint32_t half = 32; half > 0; half /= 2, low_half ^= low_half << half) {
        for (uint32_t row = 0; row < 64; ++row) {
            if ((row & half) != 0) continue;
            const uint64_t differ = (block[row] >> half ^ block[row + half]) & low_half;
            block[row] ^= differ << half;
            block[row + half] ^= differ;
        }
    }
}

/// Sight goes both ways, even where the compiler's rows disagree: sets bit b of row a wherever bit
/// a of row b is set.
void make_symmetric(std::span<uint64_t> rows, size_t row_count, size_t words) {
    const auto load = [&](size_t row_block, size_t word) {
        BitBlock block{};
        for (size_t row = 64 * row_block; row < std::min(64 * row_block + 64, row_count); ++row)
            block[row % 64] = rows[row * words + word];
        return block;
    };
    const auto add = [&](size_t row_block, size_t word, const BitBlock& block) {
        for (size_t row = 64 * row_block; row < std::min(64 * row_block + 64, row_count); ++row)
            rows[row * words + word] |= block[row % 64];
    };
    for (size_t a = 0; a < words; ++a) {
        for (size_t b = 0; b <= a; ++b) {
            BitBlock upper = load(a, b), lower = load(b, a);
            transpose(upper);
            transpose(lower);
            add(b, a, upper);
            add(a, b, lower);
        }
    }
}

/// Groups clusters whose lists are equal, exactly: all start in one group, and each light divides
/// the groups that it is seen from in part only.
class ListGroups {
public:
    explicit ListGroups(size_t clusters)
        : group_(clusters, 0), size_{clusters}, met_{0}, split_{0} {}

    uint32_t group_of(size_t cluster) const { return group_[cluster]; }
    size_t group_count() const { return size_.size(); }

    void divide(std::span<const uint64_t> seen) {
        touched_.clear();
        for_each_bit(seen, [&](uint32_t cluster) {
            const uint32_t group = group_[cluster];
            if (met_[group]++ == 0) touched_.push_back(group);
        });
        bool divides = false;
        for (const uint32_t group : touched_) {
            split_[group] = group;
            if (met_[group] < size_[group]) {
                split_[group] = static_cast<uint32_t>(size_.size());
                size_[group] -= met_[group];
                size_.push_back(met_[group]);
                met_.push_back(0);
                split_.push_back(0);
                divides = true;
            }
            met_[group] = 0;
        }
        if (divides)
            for_each_bit(seen,
                         [&](uint32_t cluster) { group_[cluster] = split_[group_[cluster]]; });
    }

private:
    std::vector<uint32_t> group_; // per cluster
    std::vector<size_t> size_;    // per group: its clusters
    std::vector<size_t> met_;     // per group, while dividing: clusters that see the light
    std::vector<uint32_t> split_; // per group, while dividing: where those go
    std::vector<uint32_t> touched_;
};

} // namespace

LightLister::LightLister(const Bsp& bsp, const Pvs& pvs)
    : bsp_(bsp), cluster_count_(pvs.cluster_count()), words_(pvs.words_per_row()) {
    rows_.resize(cluster_count_ * words_);
    for (uint32_t a = 0; a < cluster_count_; ++a)
        std::ranges::copy(pvs.row(static_cast<int32_t>(a)), rows_.begin() + a * words_);
    if (!pvs.sees_everything()) make_symmetric(rows_, cluster_count_, words_);

    constexpr float huge = std::numeric_limits<float>::max();
    boxes_.assign(cluster_count_, {glm::vec3(huge), glm::vec3(-huge)});
    for (const BspLeaf& leaf : bsp.leafs) {
        if (leaf.cluster < 0 || static_cast<uint32_t>(leaf.cluster) >= cluster_count_) continue;
        Box& box = boxes_[static_cast<size_t>(leaf.cluster)];
        // A leaf without bounds in the file may be anywhere.
        const bool bounded = glm::all(glm::lessThan(leaf.mins, leaf.maxs));
        box.mins = bounded ? glm::min(box.mins, leaf.mins - box_margin) : glm::vec3(-huge);
        box.maxs = bounded ? glm::max(box.maxs, leaf.maxs + box_margin) : glm::vec3(huge);
    }
}

uint64_t LightLister::clusters_touched(const LightTriangle& light,
                                       std::vector<uint32_t>& clusters) const {
    struct Visit {
        int32_t child;
        Polygon polygon;
    };
    clusters.clear();
    uint64_t corners = 0;
    const glm::vec3 normal = glm::cross(light.v1 - light.v0, light.v2 - light.v0);
    std::vector<Visit> stack;
    stack.push_back({bsp_.models.front().headnode, {light.v0, light.v1, light.v2}});
    while (!stack.empty()) {
        Visit visit = std::move(stack.back());
        stack.pop_back();
        // Walk down as long as the piece stays whole.
        while (visit.child >= 0) {
            const BspNode& node = bsp_.nodes[static_cast<size_t>(visit.child)];
            const BspPlane& plane = bsp_.planes[node.plane];
            corners += visit.polygon.size();
            const PlaneSides sides = classify(visit.polygon, plane);
            bool front = sides.highest >= -on_plane, back = sides.lowest <= on_plane;
            if (sides.lowest >= -on_plane && sides.highest <= on_plane) {
                // In the plane: what the light shines on lies on its lit side. Slivers whose normal
                // says nothing go to both.
                const float facing = glm::dot(plane.normal, normal);
                if (std::abs(facing) > 0.5f * glm::length(normal))
                    (facing > 0.0f ? back : front) = false;
            } else if (front && back && sides.lowest < -on_plane && sides.highest > on_plane) {
                stack.push_back({node.children[1], clip(visit.polygon, plane, -1.0f)});
                visit.polygon = clip(visit.polygon, plane, 1.0f);
                back = false;
            }
            if (front && back) stack.push_back({node.children[1], visit.polygon});
            visit.child = node.children[front ? 0 : 1];
        }
        const int32_t cluster = bsp_.leafs[static_cast<size_t>(-1 - visit.child)].cluster;
        if (cluster >= 0 && static_cast<uint32_t>(cluster) < cluster_count_)
            clusters.push_back(static_cast<uint32_t>(cluster));
    }
    sort_unique(clusters);
    return corners;
}

/// Adds to `seen` the clusters that a triangle may shine on. `clusters` are those it touches.
/// Returns the words and boxes that were looked at.
uint64_t LightLister::add_visibility(const LightTriangle& light, std::span<const uint32_t> clusters,
                                     std::span<uint64_t> seen) const {
    uint64_t steps = words_ * (1 + clusters.size());
    std::vector<uint64_t> reach(words_, 0);
    if (clusters.empty()) {
        for (uint32_t c = 0; c < cluster_count_; ++c)
            reach[c / 64] |= uint64_t{1} << (c % 64);
    }
    for (const uint32_t cluster : clusters)
        for (size_t w = 0; w < words_; ++w)
            reach[w] |= rows_[cluster * words_ + w];
    // A cluster wholly behind the light's plane gets none of its light. Double precision: the
    // margin above is the only one.
    const glm::dvec3 v0(light.v0);
    const glm::dvec3 normal = glm::cross(glm::dvec3(light.v1) - v0, glm::dvec3(light.v2) - v0);
    for_each_bit(reach, [&](uint32_t c) {
        ++steps;
        const Box& box = boxes_[c];
        const glm::dvec3 corner(normal.x > 0.0 ? box.maxs.x : box.mins.x,
                                normal.y > 0.0 ? box.maxs.y : box.mins.y,
                                normal.z > 0.0 ? box.maxs.z : box.mins.z);
        if (glm::dot(normal, corner - v0) > 0.0) seen[c / 64] |= uint64_t{1} << (c % 64);
    });
    return steps;
}

LightLists LightLister::build(std::span<const LightTriangle> lights,
                              const LightListLimits& limits) const {
    LightLists lists;
    std::vector<uint32_t> order(lights.size());
    for (uint32_t i = 0; i < order.size(); ++i)
        order[i] = i;
    std::stable_sort(order.begin(), order.end(),
                     [&](uint32_t a, uint32_t b) { return lights[a].id < lights[b].id; });
    std::vector<uint32_t> ids;
    std::vector<size_t> first_triangle; // of each id, in `order`
    for (size_t i = 0; i < order.size(); ++i) {
        if (!ids.empty() && ids.back() == lights[order[i]].id) continue;
        ids.push_back(lights[order[i]].id);
        first_triangle.push_back(i);
    }
    first_triangle.push_back(order.size());

    // One list for all, where lists of their own would take too much.
    const auto share_all = [&](std::string why) {
        lists.ranges.assign(size_t{cluster_count_} + 1, {0, static_cast<uint32_t>(ids.size())});
        lists.pair_count = uint64_t{cluster_count_} * ids.size();
        lists.ids = std::move(ids);
        lists.refused = std::move(why);
        return std::move(lists);
    };

    // A walk visits light by light in order of ids, with the clusters it is seen from as a bit set.
    // False where that would take too long.
    const bool keep = ids.size() * words_ <= limits.kept_words;
    std::vector<uint64_t> sets(words_ * (keep ? ids.size() : 1));
    std::vector<uint32_t> clusters;
    bool walked = false;
    const auto walk = [&](auto visit) {
        for (size_t light = 0; light < ids.size(); ++light) {
            const auto seen = std::span(sets).subspan(keep ? light * words_ : 0, words_);
            if (!keep || !walked) {
                std::ranges::fill(seen, 0);
                for (size_t i = first_triangle[light]; i < first_triangle[light + 1]; ++i) {
                    lists.steps += clusters_touched(lights[order[i]], clusters);
                    lists.steps += add_visibility(lights[order[i]], clusters, seen);
                    if (clusters.empty() && !walked) ++lists.unplaced;
                }
                if (lists.steps > limits.steps) return false;
            }
            visit(ids[light], seen);
        }
        walked = true;
        return true;
    };
    const std::string too_long = "would take too long to make";

    // Clusters with equal lists share one; the first cluster of a group owns it.
    ListGroups groups(cluster_count_);
    if (!walk([&](uint32_t, std::span<const uint64_t> seen) { groups.divide(seen); }))
        return share_all(too_long);
    constexpr uint32_t nobody = UINT32_MAX;
    std::vector<uint32_t> owner(groups.group_count(), nobody);
    std::vector<uint64_t> owners(words_, 0);
    for (uint32_t c = 0; c < cluster_count_; ++c) {
        if (owner[groups.group_of(c)] != nobody) continue;
        owner[groups.group_of(c)] = c;
        owners[c / 64] |= uint64_t{1} << (c % 64);
    }

    // Count, lay out, fill: lights come in order, so lists come out sorted.
    const auto for_each_pair = [&](auto visit) {
        std::vector<uint64_t> owned(words_);
        return walk([&](uint32_t id, std::span<const uint64_t> seen) {
            for (size_t w = 0; w < words_; ++w)
                owned[w] = seen[w] & owners[w];
            for_each_bit(owned, [&](uint32_t c) { visit(c, id); });
        });
    };
    lists.ranges.resize(size_t{cluster_count_} + 1);
    if (!for_each_pair([&](uint32_t c, uint32_t) { ++lists.ranges[c].count; }))
        return share_all(too_long);
    uint64_t first = 0;
    for (uint32_t c = 0; c < cluster_count_; ++c) {
        lists.ranges[c].first = static_cast<uint32_t>(first);
        first += lists.ranges[c].count;
        if (first + ids.size() > limits.ids)
            return share_all(fmt::format("would have more than {} entries", limits.ids));
    }
    lists.ids.resize(first + ids.size());
    std::vector<uint32_t> filled(cluster_count_, 0);
    if (!for_each_pair(
            [&](uint32_t c, uint32_t id) { lists.ids[lists.ranges[c].first + filled[c]++] = id; }))
        return share_all(too_long);

    for (uint32_t c = 0; c < cluster_count_; ++c) {
        lists.ranges[c] = lists.ranges[owner[groups.group_of(c)]];
        lists.pair_count += lists.ranges[c].count;
    }
    std::copy(ids.begin(), ids.end(), lists.ids.begin() + static_cast<std::ptrdiff_t>(first));
    lists.ranges[cluster_count_] = {static_cast<uint32_t>(first),
                                    static_cast<uint32_t>(ids.size())};
    return lists;
}

} // namespace vigil
