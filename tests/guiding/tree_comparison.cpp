// SPDX-License-Identifier: GPL-2.0-or-later
// See tree_comparison.h.
#include "tree_comparison.h"

#include "shared/octree.h"
#include "shared/scene_types.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>

namespace vigil::test {

using namespace shader;

namespace {

std::string name(const Path& leaf, const Numbering& numbers) {
    return fmt::format("leaf {} at '{}'", numbers.leaf(leaf), leaf);
}

size_t lights_in(const Cache& cache) {
    size_t lights = 0;
    for (const Lights& bucket : cache.buckets)
        lights += bucket.size();
    return lights;
}

struct Range {
    uint64_t first, end;
    std::string owner;
};

/// Ranges of different owners that overlap, and those that pass the end of their buffer.
void check_ranges(std::vector<Range> ranges, uint64_t capacity, const char* what,
                  Disagreements& found) {
    std::sort(ranges.begin(), ranges.end(),
              [](const Range& a, const Range& b) { return a.first < b.first; });
    uint64_t end = 0;
    for (const Range& range : ranges) {
        if (range.first < end || range.end > capacity)
            found.add(fmt::format("{}: {}: expected at {} or later and before {}, seen {} .. {}",
                                  range.owner, what, end, capacity, range.first, range.end));
        end = std::max(end, range.end);
    }
}

/// Adds the room that an owner has, which should be no less than `least`.
void add_range(std::string owner, uint32_t first, uint32_t room, uint32_t least,
               std::vector<Range>& ranges, Disagreements& found) {
    if (room < least)
        found.add(fmt::format("{}: room: expected at least {}, seen {}", owner, least, room));
    if (room > 0) ranges.push_back({first, uint64_t{first} + room, std::move(owner)});
}

} // namespace

void Disagreements::add(std::string line) {
    if (++count_ <= 8) lines_.push_back(std::move(line));
}

std::string Disagreements::text() const {
    return fmt::format("{} disagreements\n  {}{}", count_, fmt::join(lines_, "\n  "),
                       count_ > lines_.size() ? "\n  ..." : "");
}

Disagreements compare_tree(const AdaptedOctree& expected, const InnerNodes& old,
                           const TreeWords& seen) {
    Disagreements found;
    const auto check = [&](const auto& where, const char* what, uint32_t want, uint32_t got) {
        if (want != got)
            found.add(fmt::format("{}: {}: expected {:#x}, seen {:#x}", where, what, want, got));
    };
    const Numbering numbers(expected.inner);
    const Numbering old_numbers(old);
    check("tree", "nodes", static_cast<uint32_t>(expected.inner.size()), seen.nodes[0]);

    for (const Path& node : expected.inner) {
        const uint32_t number = numbers.node(node);
        const std::string where = fmt::format("node {} at '{}'", number, node);
        const uint32_t word = seen.nodes[1 + number];
        check(where, "leaf mask", leaf_mask(expected.inner, node), word & 0xffu);
        if (const std::optional<Path> first = first_inner_child(expected.inner, node))
            check(where, "offset", numbers.node(*first), word >> 8u);
        const Cube cube = cube_of(node);
        const uvec3 corner(cube.lowest);
        check(where, "cell x, y", corner.x + (corner.y << 16), seen.cells[2 * number]);
        check(where, "cell z, depth", corner.z + (static_cast<uint32_t>(node.size()) << 16),
              seen.cells[2 * number + 1]);
    }
    for (const auto& [leaf, source] : expected.source) {
        const uint32_t number = numbers.leaf(leaf);
        const std::string where = name(leaf, numbers);
        check(where, "count", 0, seen.at(LEAF_COUNT, number));
        check(where, "visible lights", 0, seen.at(LEAF_VISIBLE, number));
        check(where, "source",
              old_numbers.leaf(source) | (leaf.size() > source.size() ? SOURCE_SPLIT : 0),
              seen.at(LEAF_SOURCE, number));
        for (int face = 0; face < 6; ++face)
            check(where, fmt::format("neighbour {}", face).c_str(),
                  neighbour_number(expected.inner, numbers, leaf, face),
                  seen.at(LEAF_NEIGHBOURS, number, face));
    }
    return found;
}

Disagreements compare_storage(const InnerNodes& inner, const TreeWords& seen,
                              uint32_t sample_capacity) {
    Disagreements found;
    const Numbering numbers(inner);
    const std::vector<Path> leaves = leaves_of(inner);
    std::vector<Range> ranges;
    for (const Path& leaf : leaves)
        add_range(name(leaf, numbers), seen.at(LEAF_STORAGE, numbers.leaf(leaf), 0),
                  seen.at(LEAF_STORAGE, numbers.leaf(leaf), 1),
                  static_cast<uint32_t>(sample_capacity / 4 / leaves.size()), ranges, found);
    check_ranges(std::move(ranges), sample_capacity, "sample storage", found);
    return found;
}

Disagreements compare_ray_storage(const InnerNodes& inner, const TreeWords& seen,
                                  uint32_t ray_capacity) {
    Disagreements found;
    const Numbering numbers(inner);
    std::vector<Range> ranges;
    for (const Path& node : inner) {
        const uint32_t number = numbers.node(node);
        const std::string owner = fmt::format("node '{}'", node);
        add_range(owner, seen.at(NODE_RAY_STORAGE, number, 0), seen.at(NODE_RAY_STORAGE, number, 1),
                  static_cast<uint32_t>(ray_capacity / 4 / inner.size()), ranges, found);
        for (uint32_t word = 0; word < NODE_RAYS.words; ++word)
            if (const uint32_t rays = seen.at(NODE_RAYS, number, word); rays != 0)
                found.add(fmt::format("{}: rays, word {}: expected 0, seen {}", owner, word, rays));
    }
    check_ranges(std::move(ranges), ray_capacity, "ray storage", found);
    return found;
}

Disagreements compare_caches(const Caches& expected, const TreeWords& seen_old,
                             const InnerNodes& old, std::span<const uint32_t> lights,
                             uint32_t bucket) {
    Disagreements found;
    const Numbering numbers(old);
    std::vector<Range> ranges;
    for (const auto& [leaf, cache] : expected.by_leaf) {
        const uint32_t number = numbers.leaf(leaf);
        const std::string where = name(leaf, numbers);

        // Lights of its own.
        const uint32_t visible = seen_old.at(LEAF_VISIBLE, number);
        if (visible != cache.own.size())
            found.add(fmt::format("{}: visible lights: expected {}, seen {}", where,
                                  cache.own.size(), visible));

        // What draws were worth: floats of two bytes, whose error the share shares; subnormal ones
        // have less.
        const Explored explored = explored_at(seen_old, number);
        for (double Explored::*value :
             {&Explored::listed, &Explored::found, &Explored::cached, &Explored::share})
            if (std::abs(explored.*value - cache.explored.*value) >
                0.01 * cache.explored.*value + 1e-38)
                found.add(fmt::format("{}: explored: expected {}, seen {}", where,
                                      cache.explored.*value, explored.*value));

        // Buckets.
        const uint32_t cached = seen_old.at(LEAF_CACHED, number);
        if (cached != cache.ages.size())
            found.add(fmt::format("{}: cached lights: expected {}, seen {}", where,
                                  cache.ages.size(), cached));
        const uint32_t first = seen_old.at(LEAF_VLC, number, 0);
        const uint32_t buckets = seen_old.at(LEAF_VLC, number, 1);
        if (buckets != cache.buckets.size()) {
            found.add(fmt::format("{}: buckets: expected {}, seen {}", where, cache.buckets.size(),
                                  buckets));
            continue;
        }
        if (buckets == 0) continue;
        const uint64_t end = uint64_t{first} + vlc_cache_words(buckets, bucket);
        ranges.push_back({first, end, where});
        if (end > lights.size()) continue; // reported with the ranges

        // Ids in their order, with their ages, then NONE.
        for (uint32_t b = 0; b < buckets; ++b) {
            std::vector<uint32_t> want;
            for (const uint32_t light : cache.buckets[b])
                want.push_back(light + (cache.ages.at(light) << VLC_AGE_SHIFT));
            want.resize(bucket, NONE);
            const std::span<const uint32_t> got = lights.subspan(first + b * bucket, want.size());
            if (!std::equal(want.begin(), want.end(), got.begin()))
                found.add(fmt::format("{}: bucket {} of {}: expected {}, seen {}", where, b,
                                      buckets, want, got));
        }

        // How they are drawn: memories are rounded to two bytes, twice.
        const BucketDraws drawn =
            drawn_at(lights.subspan(first + buckets * bucket, size_t{2} * buckets));
        for (uint32_t b = 0; b < buckets; ++b) {
            const BucketDraw& want = cache.drawn[b];
            const BucketDraw& got = drawn[b];
            if (std::abs(got.until - want.until) > 0.01 ||
                std::abs(got.draws - want.draws) > 0.01 * want.draws ||
                std::abs(got.root - want.root) > 0.012 * want.root + 1e-18)
                found.add(fmt::format(
                    "{}: bucket {} of {}: expected {} draws of {}, until {}, seen {} of {}, {}",
                    where, b, buckets, want.draws, want.root, want.until, got.draws, got.root,
                    got.until));
        }
        if (drawn.back().until != 1.0)
            found.add(fmt::format("{}: buckets are drawn until {}", where, drawn.back().until));
    }
    check_ranges(std::move(ranges), lights.size(), "cache", found);
    return found;
}

Disagreements compare_handed_on(const AdaptedOctree& expected, const Caches& caches,
                                const TreeWords& seen, const InnerNodes& old,
                                const TreeWords& seen_old) {
    Disagreements found;
    const Numbering numbers(expected.inner);
    const Numbering old_numbers(old);
    for (const auto& [leaf, source] : expected.source) {
        const uint32_t from = old_numbers.leaf(source);
        const uint32_t to = numbers.leaf(leaf);
        const uvec2 want(seen_old.at(LEAF_VLC, from, 0), seen_old.at(LEAF_VLC, from, 1));
        const uvec2 got(seen.at(LEAF_VLC, to, 0), seen.at(LEAF_VLC, to, 1));
        if (want.y != got.y || (want.y > 0 && want.x != got.x))
            found.add(fmt::format("{}: cache: expected {} buckets at {} of old {}, seen {} at {}",
                                  name(leaf, numbers), want.y, want.x, name(source, old_numbers),
                                  got.y, got.x));
        for (uint32_t word = 0; word < 2; ++word)
            if (seen.at(LEAF_EXPLORE, to, word) != seen_old.at(LEAF_EXPLORE, from, word))
                found.add(fmt::format("{}: explored, word {}: not that of old {}",
                                      name(leaf, numbers), word, name(source, old_numbers)));
        const auto cached = static_cast<uint32_t>(caches.by_leaf.at(source).ages.size());
        if (seen.at(LEAF_CACHED, to) != cached)
            found.add(fmt::format("{}: cached lights: expected {}, seen {}", name(leaf, numbers),
                                  cached, seen.at(LEAF_CACHED, to)));
    }
    return found;
}

Disagreements compare_guides_handed_on(const AdaptedOctree& expected, const TreeWords& seen,
                                       const InnerNodes& old, const TreeWords& seen_old,
                                       bool remember) {
    Disagreements found;
    const Numbering numbers(expected.inner);
    const Numbering old_numbers(old);
    for (const Path& node : expected.inner) {
        // A new node was a leaf of the node above.
        const bool split = !old.contains(node);
        const uint32_t from = old_numbers.node(split ? node.substr(0, node.size() - 1) : node);
        const uint32_t to = numbers.node(node);
        for (uint32_t word = 0; word < 4; ++word)
            if (seen.at(NODE_GUIDE, to, word) != seen_old.at(NODE_GUIDE, from, word))
                found.add(fmt::format("node '{}': quadtree word {}: expected {:#x}, seen {:#x}",
                                      node, word, seen_old.at(NODE_GUIDE, from, word),
                                      seen.at(NODE_GUIDE, to, word)));
        for (uint32_t word = 0; remember && word < CDQ_SUM_WORDS; ++word)
            if (seen.at(guide_memory(CDQ_SUM_WORDS), to, word) !=
                seen_old.at(guide_memory(CDQ_SUM_WORDS), from, word))
                found.add(
                    fmt::format("node '{}': sums, word {}: not those of its source", node, word));
        ShareState want = shared_at(seen_old, from);
        if (split) want = {0.0, 0.0, std::min(want.rays, 1.0), want.share};
        const ShareState got = shared_at(seen, to);
        for (double ShareState::*value :
             {&ShareState::plain, &ShareState::guided, &ShareState::rays, &ShareState::share})
            if (got.*value != want.*value)
                found.add(fmt::format("node '{}': share: expected {}, seen {}", node, want.*value,
                                      got.*value));
    }
    return found;
}

Disagreements compare_shares(const TreeState& old, const ByPath<ShareState>& expected,
                             const TreeWords& seen_old, const GuidingWork& statistics) {
    Disagreements found;
    const Numbering numbers(old.inner);
    double spreads[2] = {};
    for (const auto& [path, want] : expected) {
        spreads[shader::GUIDE_SPREAD_PLAIN] += want.plain_spread;
        spreads[shader::GUIDE_SPREAD_GUIDED] += want.guided_spread;
        const ShareState got = shared_at(seen_old, numbers.node(path));
        // Floats of two bytes.
        for (double ShareState::*value :
             {&ShareState::plain, &ShareState::guided, &ShareState::rays, &ShareState::share})
            if (std::abs(got.*value - want.*value) > 0.01 * want.*value + 1e-37)
                found.add(fmt::format("node '{}': share: expected {}, seen {}", path, want.*value,
                                      got.*value));
    }
    for (const uint32_t kind : {shader::GUIDE_SPREAD_PLAIN, shader::GUIDE_SPREAD_GUIDED}) {
        const auto got = static_cast<double>(std::bit_cast<float>(statistics.spreads[kind]));
        if (!(std::abs(got - spreads[kind]) <= 1e-4 * spreads[kind]))
            found.add(fmt::format("spread {}: expected {}, seen {}", kind, spreads[kind], got));
    }
    return found;
}

Disagreements compare_quadtrees(const TreeState& old, const AdaptedByNode& expected, uint32_t bits,
                                bool remember, const TreeWords& seen_old,
                                const GuidingWork& statistics) {
    Disagreements found;
    const Numbering numbers(old.inner);
    uint32_t fewest = 0, most = 0;
    for (const auto& [path, node] : old.nodes) {
        const uint32_t number = numbers.node(path);
        const bool adapts = old.lessons_of(node).rays() > 0;
        const glm::uvec4 field = quadtree_at(seen_old, number);
        const auto text = [](glm::uvec4 words) {
            return fmt::format("{:08x} {:08x} {:08x} {:08x}", words.x, words.y, words.z, words.w);
        };
        const AdaptedQuadtrees& adapted = expected.at(path);
        bool match = false;
        uint32_t least = UINT32_MAX, largest = 0;
        for (const auto& [tree, sums] : adapted.allowed) {
            if (field_of(tree.inner) == field) {
                match = true;
                // Where rounding decides, different ways may lead to the same tree.
                if (remember && adapted.allowed.size() == 1)
                    for (const auto& [square, sum] : sums_at(seen_old, number, tree.inner))
                        if (const double want = (adapts ? sums : node.remembered).at(square);
                            std::abs(sum - want) > (adapted.error + 0.005) * want + 1e-37)
                            found.add(
                                fmt::format("node '{}': sum in square {}: expected {}, seen {}",
                                            path, square, want, sum));
            }
            least = std::min(least, tree.migrations);
            largest = std::max(largest, tree.migrations);
        }
        if (!match)
            found.add(fmt::format(
                "node '{}': quadtree {}: expected {}{}, seen {}{}", path,
                text(field_of(node.quadtree)), text(field_of(adapted.allowed.begin()->first.inner)),
                adapted.allowed.size() > 1
                    ? fmt::format(" or one of {}", adapted.allowed.size() - 1)
                    : "",
                text(field), squares_of(field, bits) ? "" : ", which is no quadtree"));
        fewest += least;
        most += largest;
    }
    if (statistics.cdq_migrations < fewest || statistics.cdq_migrations > most)
        found.add(fmt::format("statistics: migrations: expected {} to {}, seen {}", fewest, most,
                              statistics.cdq_migrations));
    return found;
}

Disagreements compare_statistics(const TreeState& old, const AdaptedOctree& tree,
                                 const Caches& caches, const GuidingWork& seen) {
    GuidingWork want{};
    want.nodes = static_cast<uint32_t>(tree.inner.size());
    want.depth =
        static_cast<uint32_t>(tree.inner.rbegin()->size() + 1); // the last node is a deepest
    for (const auto& [path, leaf] : old.leaves) {
        want.samples += leaf.count;
        want.dropped += leaf.count - leaf.kept();
        want.sampled_leaves += leaf.count > 0 ? 1u : 0u;
    }
    for (const auto& [path, cache] : caches.by_leaf) {
        const auto lights = static_cast<uint32_t>(lights_in(cache));
        want.cached_leaves += lights > 0 ? 1u : 0u;
        want.cached_lights += lights;
        want.cached_buckets += static_cast<uint32_t>(cache.buckets.size());
        want.most_lights = std::max(want.most_lights, lights);
    }

    Disagreements found;
    const auto check = [&](const char* what, uint32_t expected, uint32_t got) {
        if (expected != got)
            found.add(fmt::format("statistics: {}: expected {}, seen {}", what, expected, got));
    };
    check("nodes", want.nodes, seen.nodes);
    check("depth", want.depth, seen.depth);
    check("samples", want.samples, seen.samples);
    check("dropped", want.dropped, seen.dropped);
    check("sampled leaves", want.sampled_leaves, seen.sampled_leaves);
    check("cached leaves", want.cached_leaves, seen.cached_leaves);
    check("cached lights", want.cached_lights, seen.cached_lights);
    check("cached buckets", want.cached_buckets, seen.cached_buckets);
    check("most lights", want.most_lights, seen.most_lights);
    check("any lights left out", caches.lights_left_out, seen.lights_left_out > 0);
    check("splits", tree.splits, seen.splits);
    check("splits refused", tree.splits_refused, seen.splits_refused);
    check("collapses", tree.collapses, seen.collapses);
    return found;
}

} // namespace vigil::test
