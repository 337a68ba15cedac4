// SPDX-License-Identifier: GPL-2.0-or-later
// Top-down build: bin the items' centres along each axis, cut where the surface area heuristic is
// least, partition in place, recurse. Items that no plane separates are halved by count.
#include "refresh/vkpt/scene/sah_builder.h"

#include <algorithm>
#include <array>
#include <future>
#include <span>

namespace vigil {

namespace {

constexpr std::uint32_t BIN_COUNT = 32;
constexpr std::uint32_t PARALLEL_ITEMS = 8192;

struct Bin {
    Bounds bounds;
    std::uint32_t count = 0;
};

struct Split {
    float cost = std::numeric_limits<float>::infinity();
    int axis = -1;
    std::uint32_t bin = 0; // first bin of the right side
};

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
    std::uint32_t bin(const Bounds& bounds, int axis) const {
        const float center = 0.5f * (bounds.lower[axis] + bounds.upper[axis]);
        const float position = (center - lower_[axis]) * scale_[axis];
        return std::min(static_cast<std::uint32_t>(std::max(position, 0.0f)), BIN_COUNT - 1);
    }

private:
    glm::vec3 lower_;
    glm::vec3 scale_{0.0f};
};

Split best_split(std::span<const SahItem> items, const Binning& binning) {
    std::array<std::array<Bin, BIN_COUNT>, 3> bins;
    for (const SahItem& item : items) {
        for (int axis = 0; axis < 3; ++axis) {
            Bin& bin = bins[axis][binning.bin(item.bounds, axis)];
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

class Builder {
public:
    Builder(std::vector<SahItem>& items, const SahOptions& options)
        : items_(items), options_(options) {}

    std::unique_ptr<SahNode> build(std::uint32_t first, std::uint32_t count, std::uint32_t depth,
                                   bool threads) {
        auto node = std::make_unique<SahNode>();
        node->first = first;
        node->count = count;
        const std::span<SahItem> items(items_.data() + first, count);
        Bounds centers;
        for (const SahItem& item : items) {
            node->bounds.grow(item.bounds);
            centers.grow(item.bounds.center());
        }
        if (count == 1) return node;

        // Choose between a leaf, the heuristic's cut and halving.
        Split split;
        const Binning binning(centers);
        if (depth < SAH_SPLIT_DEPTH) split = best_split(items, binning);
        const float area = node->bounds.half_area();
        const bool cheaper_leaf = split.axis < 0 || split.cost + options_.traversal_cost * area >=
                                                        static_cast<float>(count) * area;
        if (count <= options_.max_leaf && cheaper_leaf) return node;
        std::uint32_t left = count / 2;
        if (split.axis >= 0) {
            const auto middle = std::partition(items.begin(), items.end(), [&](const auto& item) {
                return binning.bin(item.bounds, split.axis) < split.bin;
            });
            left = static_cast<std::uint32_t>(middle - items.begin());
        }

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
    std::vector<SahItem>& items_;
    const SahOptions& options_;
};

} // namespace

std::unique_ptr<SahNode> build_sah(std::vector<SahItem>& items, const SahOptions& options) {
    return Builder(items, options)
        .build(0, static_cast<std::uint32_t>(items.size()), 1, options.threads);
}

} // namespace vigil
