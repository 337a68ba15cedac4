// SPDX-License-Identifier: GPL-2.0-or-later
// Top-down build: cut where the surface area heuristic is least, partition in place, recurse. Many
// items are binned along each axis, a few are sorted. Items that no plane separates are halved by
// count.
#include "refresh/vkpt/scene/sah_builder.h"

#include <algorithm>
#include <future>
#include <span>

namespace vigil {

namespace {

constexpr std::uint32_t BIN_COUNT = 32;
constexpr std::uint32_t SORTED_ITEMS = 4; // up to this many are cut exactly; more measured worse
constexpr std::uint32_t PARALLEL_ITEMS = 8192;
constexpr int WIDTH = 4;

struct Bin {
    Bounds bounds;
    std::uint32_t count = 0;
};

struct Split {
    float cost = std::numeric_limits<float>::infinity();
    int axis = -1;
    std::uint32_t position =
        0; // first bin of the right side; for sorted items their number on the left
};

float center(const SahItem& item, int axis) {
    return 0.5f * (item.bounds.lower[axis] + item.bounds.upper[axis]);
}

/// Maps centres to bins along the three axes; the same arithmetic bins and partitions.
class Binning {
public:
    explicit Binning(const Bounds& centers) : lower_(centers.lower) {
        const glm::vec3 extent = centers.extent();
        for (int axis = 0; axis < 3; ++axis) {
            scale_[axis] = extent[axis] > 0.0f ? BIN_COUNT * 0.9999f / extent[axis] : 0.0f;
            if (!std::isfinite(scale_[axis])) scale_[axis] = 0.0f;
        }
    }
    bool usable(int axis) const { return scale_[axis] > 0.0f; }
    std::uint32_t bin(const SahItem& item, int axis) const {
        const float position = (center(item, axis) - lower_[axis]) * scale_[axis];
        return std::min(static_cast<std::uint32_t>(std::max(position, 0.0f)), BIN_COUNT - 1);
    }

private:
    glm::vec3 lower_;
    glm::vec3 scale_{0.0f};
};

Split best_binned_split(std::span<const SahItem> items, const Binning& binning) {
    std::array<std::array<Bin, BIN_COUNT>, 3> bins;
    for (const SahItem& item : items) {
        for (int axis = 0; axis < 3; ++axis) {
            Bin& bin = bins[axis][binning.bin(item, axis)];
            bin.bounds.grow(item.bounds);
            bin.count += 1;
        }
    }
    Split best;
    for (int axis = 0; axis < 3; ++axis) {
        if (!binning.usable(axis)) continue;
        // Sweep from the right to know every right side, then from the left to evaluate.
        std::array<float, BIN_COUNT> right_cost{};
        Bin side;
        for (std::uint32_t i = BIN_COUNT; i-- > 1;) {
            side.bounds.grow(bins[axis][i].bounds);
            side.count += bins[axis][i].count;
            right_cost[i] = side.bounds.half_area() * static_cast<float>(side.count);
        }
        side = Bin{};
        for (std::uint32_t i = 1; i < BIN_COUNT; ++i) {
            side.bounds.grow(bins[axis][i - 1].bounds);
            side.count += bins[axis][i - 1].count;
            if (side.count == 0 || side.count == items.size()) continue;
            const float cost =
                side.bounds.half_area() * static_cast<float>(side.count) + right_cost[i];
            if (cost < best.cost) best = {cost, axis, i};
        }
    }
    return best;
}

void sort_along(std::span<SahItem> items, int axis) {
    std::sort(items.begin(), items.end(), [axis](const SahItem& a, const SahItem& b) {
        const float center_a = center(a, axis);
        const float center_b = center(b, axis);
        return center_a != center_b ? center_a < center_b : a.index < b.index;
    });
}

/// Tries every cut of the sorted items; leaves them sorted along the last axis tried.
Split best_sorted_split(std::span<SahItem> items) {
    Split best;
    for (int axis = 0; axis < 3; ++axis) {
        sort_along(items, axis);
        std::array<float, SORTED_ITEMS> right_cost{};
        Bounds side;
        for (std::size_t i = items.size(); i-- > 1;) {
            side.grow(items[i].bounds);
            right_cost[i] = side.half_area() * static_cast<float>(items.size() - i);
        }
        side = Bounds{};
        for (std::size_t i = 1; i < items.size(); ++i) {
            side.grow(items[i - 1].bounds);
            const float cost = side.half_area() * static_cast<float>(i) + right_cost[i];
            if (cost < best.cost) best = {cost, axis, static_cast<std::uint32_t>(i)};
        }
    }
    return best;
}

class Builder {
public:
    Builder(std::vector<SahItem>& items, const SahOptions& options)
        : items_(items), options_(options) {}

    std::unique_ptr<SahNode> build(std::uint32_t first, std::uint32_t count, std::uint32_t depth,
                                   bool threads) {
        auto node = std::make_unique<SahNode>();
        const std::span<SahItem> items(items_.data() + first, count);
        for (const SahItem& item : items)
            node->bounds.grow(item.bounds);
        if (count == 1) {
            node->item = first;
            return node;
        }
        const std::uint32_t left = partition(items, depth);
        if (threads && count >= PARALLEL_ITEMS) {
            auto other = std::async(std::launch::async, [&] {
                return build(first + left, count - left, depth + 1, false);
            });
            node->child[0] = build(first, left, depth + 1, false);
            node->child[1] = other.get();
        } else {
            node->child[0] = build(first, left, depth + 1, false);
            node->child[1] = build(first + left, count - left, depth + 1, false);
        }
        return node;
    }

private:
    /// Reorders two or more items into a left and a right part; returns the size of the left one.
    std::uint32_t partition(std::span<SahItem> items, std::uint32_t depth) const {
        const auto half = static_cast<std::uint32_t>(items.size() / 2);
        if (depth >= options_.split_depth) return half;
        if (items.size() <= SORTED_ITEMS) {
            const Split split = best_sorted_split(items);
            if (split.axis < 0) return half;
            if (split.axis != 2) sort_along(items, split.axis);
            return split.position;
        }
        Bounds centers;
        for (const SahItem& item : items)
            centers.grow(item.bounds.center());
        const Binning binning(centers);
        const Split split = best_binned_split(items, binning);
        if (split.axis < 0) return half;
        const auto middle = std::partition(items.begin(), items.end(), [&](const SahItem& item) {
            return binning.bin(item, split.axis) < split.position;
        });
        return static_cast<std::uint32_t>(middle - items.begin());
    }

    std::vector<SahItem>& items_;
    const SahOptions& options_;
};

/// Cheapest way to show both children of `node` as `count` nodes side by side.
std::pair<float, std::uint8_t> best_share(const SahNode& node, int count) {
    std::pair<float, std::uint8_t> best{std::numeric_limits<float>::infinity(), 1};
    for (int left = 1; left < count; ++left) {
        const float cost = node.child[0]->cost[left - 1] + node.child[1]->cost[count - left - 1];
        if (cost < best.first) best = {cost, static_cast<std::uint8_t>(left)};
    }
    return best;
}

void collect(const SahNode& node, int count, std::vector<const SahNode*>& nodes) {
    while (count > 1 && node.left_share[count - 1] == 0)
        count -= 1;
    if (node.leaf() || count == 1) {
        nodes.push_back(&node);
        return;
    }
    const int left = node.left_share[count - 1];
    collect(*node.child[0], left, nodes);
    collect(*node.child[1], count - left, nodes);
}

} // namespace

std::unique_ptr<SahNode> build_sah(std::vector<SahItem>& items, const SahOptions& options) {
    return Builder(items, options)
        .build(0, static_cast<std::uint32_t>(items.size()), 1, options.threads);
}

void plan_wide_nodes(SahNode& root) {
    const float area = root.bounds.half_area();
    if (root.leaf()) {
        root.cost.fill(area);
        return;
    }
    plan_wide_nodes(*root.child[0]);
    plan_wide_nodes(*root.child[1]);
    // As one node it costs a visit and its children; as several it is not there itself.
    root.cost[0] = area + best_share(root, WIDTH).first;
    for (int count = 2; count <= WIDTH; ++count) {
        std::tie(root.cost[count - 1], root.left_share[count - 1]) = best_share(root, count);
        if (root.cost[count - 2] <= root.cost[count - 1]) {
            root.cost[count - 1] = root.cost[count - 2];
            root.left_share[count - 1] = 0;
        }
    }
}

std::vector<const SahNode*> wide_children(const SahNode& node) {
    std::vector<const SahNode*> children;
    const int left = best_share(node, WIDTH).second;
    collect(*node.child[0], left, children);
    collect(*node.child[1], WIDTH - left, children);
    return children;
}

} // namespace vigil
