// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/light/light_cuts.h"

#include "formats/bsp.h"
#include "refresh/vkpt/light/light_power.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <tuple>
#include <utility>

namespace vigil {

namespace {

/// Of all lists together, shared ones counted once.
constexpr std::size_t most_ids = std::size_t{1} << 22;

/// Of all clusters, and of the whole level after them.
std::vector<Bounds> cluster_bounds(const Bsp& bsp, std::size_t lists) {
    std::vector<Bounds> bounds(lists);
    for (const BspLeaf& leaf : bsp.leafs) {
        if (leaf.cluster < 0) continue;
        bounds.back().grow({leaf.mins, leaf.maxs});
        if (static_cast<std::size_t>(leaf.cluster) + 1 < lists)
            bounds[static_cast<std::size_t>(leaf.cluster)].grow({leaf.mins, leaf.maxs});
    }
    return bounds;
}

double squared(const glm::vec3& v) {
    return static_cast<double>(glm::dot(v, v));
}

} // namespace

void LightCuts::set_still(const Bsp& bsp, const Part& part, std::uint32_t size) {
    still_ = {};
    set_moving(bsp, part, size); // beside nothing
    still_ = {cuts_.size(), entries_.size(), order_.size(), places_.size(), groups_.size()};
}

void LightCuts::set_moving(const Bsp& bsp, const Part& part, std::uint32_t size) {
    entries_.resize(still_.entries);
    order_.resize(still_.order);
    groups_.resize(still_.groups);
    places_.resize(still_.places);
    places_.resize(part.first + part.lights.size(), shader::NONE);
    tree_.build(part.lights, 1);
    first_id_ = part.first;
    for (std::uint32_t place = 0; place < tree_.lights().size(); ++place)
        places_[first_id_ + tree_.lights()[place].id] = place;

    // Clusters that share a list share its lights and groups.
    const LightLists& lists = part.lists;
    const std::size_t count = lists.ranges.size();
    cuts_.resize(still_.cuts);
    cuts_.resize(still_.cuts + count);
    const std::span<ClusterCut> cuts = std::span(cuts_).subspan(still_.cuts);
    const std::vector<Bounds> bounds = cluster_bounds(bsp, count);
    const bool too_many = lists.ids.size() > most_ids;
    const auto range_of = [&](std::size_t list) {
        const LightRange& range = too_many ? lists.ranges.back() : lists.ranges[list];
        return std::pair(range.first, range.count);
    };
    std::vector<std::size_t> by_list(count);
    std::iota(by_list.begin(), by_list.end(), std::size_t{0});
    std::ranges::sort(by_list, {}, range_of);
    std::vector<std::uint32_t> places;
    std::uint32_t sun = shader::NONE;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t list = by_list[i];
        ClusterCut& cluster = cuts[list];
        const auto [first, length] = range_of(list);
        if (i == 0 || range_of(by_list[i - 1]) != std::pair(first, length)) {
            places.clear();
            sun = shader::NONE;
            for (const std::uint32_t id : std::span(lists.ids).subspan(first, length)) {
                if ((part.lights[id - first_id_].flags & shader::LIGHT_SUN) != 0) sun = id;
                if (places_[id] != shader::NONE) places.push_back(places_[id]);
            }
            std::ranges::sort(places);
            cluster.first_light = static_cast<std::uint32_t>(order_.size());
            cluster.light_count = static_cast<std::uint32_t>(places.size());
            for (const std::uint32_t place : places)
                order_.push_back(first_id_ + tree_.lights()[place].id);
            nodes_.clear();
            if (!places.empty()) {
                grow(0, places, cluster.first_light);
                make_groups(0);
            }
        } else {
            cluster = cuts[by_list[i - 1]];
        }
        cluster.first = static_cast<std::uint32_t>(entries_.size());
        if (!nodes_.empty()) cut(bounds[list], size);
        if (sun != shader::NONE) add_run({&sun, 1});
        cluster.count = static_cast<std::uint32_t>(entries_.size()) - cluster.first;
    }
}

void LightCuts::grow(std::uint32_t number, std::span<const std::uint32_t> places,
                     std::uint32_t first) {
    // Down to where the list's lights part.
    std::size_t left = 0;
    while (places.size() > 1) {
        const std::uint32_t middle =
            tree_.nodes()[number + 1].first + tree_.nodes()[number + 1].count;
        left = static_cast<std::size_t>(std::ranges::lower_bound(places, middle) - places.begin());
        if (left != 0 && left != places.size()) break;
        number = left == 0 ? tree_.nodes()[number].right : number + 1;
    }
    const auto self = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({});
    Node node{};
    if (places.size() == 1) {
        const TreeLight& light = tree_.lights()[places.front()];
        node = {{light.lower, light.upper},
                light.normal,
                static_cast<double>(light.energy),
                first,
                1,
                0,
                shader::NONE};
    } else {
        grow(number + 1, places.first(left), first);
        node = nodes_[self + 1];
        node.right = static_cast<std::uint32_t>(nodes_.size());
        grow(tree_.nodes()[number].right, places.subspan(left),
             first + static_cast<std::uint32_t>(left));
        const Node& right = nodes_[node.right];
        node.bounds.grow(right.bounds);
        node.normal_sum += right.normal_sum;
        node.energy += right.energy;
        node.count += right.count;
        node.group = shader::NONE;
    }
    nodes_[self] = node;
}

void LightCuts::cut(const Bounds& cluster, std::uint32_t size) {
    // How far off a node's estimate may be in the cluster: its energy over squared distance, times
    // how much of that its extent and the turns of its lights leave open.
    const double least = squared(cluster.extent()) / 64.0 + 1024.0;
    const auto error = [&](std::uint32_t number) {
        const Node& node = nodes_[number];
        if (node.count == 1) return 0.0;
        const double distance = squared(
            glm::max(glm::max(cluster.lower - node.bounds.upper, node.bounds.lower - cluster.upper),
                     glm::vec3(0.0f)));
        const double extent = 0.25 * squared(node.bounds.extent());
        const double turns = 1.0 - std::sqrt(squared(node.normal_sum)) / node.count;
        return node.energy * (std::sqrt(extent / (distance + extent + 1.0)) + 2.0 * turns) /
               (distance + least);
    };
    std::vector<std::pair<double, std::uint32_t>> open{{error(0), 0}};
    while (open.front().first > 0.0) {
        std::ranges::pop_heap(open);
        const std::uint32_t parent = open.back().second;
        const bool halves = nodes_[parent].count > shader::CUT_LEAF;
        if (open.size() + (halves ? 2 : nodes_[parent].count) > size + 1) {
            open.back().first *= -1.0; // no room: it stays, in its order
            std::ranges::push_heap(open);
            continue;
        }
        open.pop_back();
        const auto add = [&](std::uint32_t child) {
            open.emplace_back(error(child), child);
            std::ranges::push_heap(open);
        };
        if (halves) {
            add(parent + 1);
            add(nodes_[parent].right);
            continue;
        }
        for (std::uint32_t node = parent; node < parent + 2 * nodes_[parent].count - 1; ++node)
            if (nodes_[node].count == 1) add(node);
    }
    // What is opened comes first, and single lights last.
    std::ranges::sort(open, std::greater{}, [this](const auto& node) {
        const std::uint32_t number = node.second;
        return std::tuple(nodes_[number].count > 1, std::abs(node.first), number);
    });
    std::vector<std::uint32_t> lights;
    for (const auto& [_, number] : open) {
        const Node& node = nodes_[number];
        if (node.count == 1)
            lights.push_back(order_[node.first]);
        else
            entries_.push_back(shader::CUT_GROUP | node.group);
    }
    add_run(lights);
}

void LightCuts::add_run(std::span<const std::uint32_t> lights) {
    while (!lights.empty()) {
        const auto run = lights.first(std::min<std::size_t>(lights.size(), shader::CUT_RUN));
        entries_.push_back(shader::cut_run(static_cast<std::uint32_t>(order_.size()),
                                           static_cast<std::uint32_t>(run.size())));
        order_.insert(order_.end(), run.begin(), run.end());
        lights = lights.subspan(run.size());
    }
}

void LightCuts::make_groups(std::uint32_t number) {
    const auto self = static_cast<std::uint32_t>(groups_.size());
    groups_.push_back({});
    nodes_[number].group = self;
    const Node& node = nodes_[number];
    if (node.count > shader::CUT_LEAF) {
        make_groups(number + 1);
        make_groups(node.right);
    }
    shader::CutGroup group{};
    group.middle = node.bounds.center();
    group.reach = glm::max(node.bounds.upper - group.middle, group.middle - node.bounds.lower);
    const float length = glm::length(node.normal_sum);
    group.mean = std::min(length / static_cast<float>(node.count), 1.0f);
    if (length > 1e-3f) group.axis = node.normal_sum / length;
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
        const TreeLight& light = tree_.lights()[places_[order_[i]]];
        group.spread = std::max(group.spread, glm::distance(light.normal, group.axis) +
                                                  light.normal_error + 1e-6f);
    }
    group.first = node.first;
    group.count = node.count;
    group.next = static_cast<std::uint32_t>(groups_.size());
    groups_[self] = group;
}

void LightCuts::set_energies(std::span<const shader::Light> lights) {
    // Halves come after their group.
    for (std::size_t i = groups_.size(); i-- > 0;) {
        shader::CutGroup& group = groups_[i];
        if (group.count > shader::CUT_LEAF) {
            group.energy = groups_[i + 1].energy + groups_[groups_[i + 1].next].energy;
            continue;
        }
        double energy = 0.0;
        for (const std::uint32_t id : std::span(order_).subspan(group.first, group.count))
            energy += static_cast<double>(light_power(lights[id]));
        group.energy = static_cast<float>(energy);
    }
}

} // namespace vigil
