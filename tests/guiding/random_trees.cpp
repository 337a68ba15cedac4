// SPDX-License-Identifier: GPL-2.0-or-later
// See random_trees.h.
#include "random_trees.h"

#include "shared/octree.h"
#include "shared/scene_types.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace vigil::test {
namespace {

/// Counts of eight children that make `sum` together.
std::vector<uint32_t> shares(Dice& dice, uint32_t sum) {
    std::vector<uint32_t> counts(8);
    for (int child = 0; child < 7; ++child) {
        counts[child] = dice.chance(0.5) ? 0 : dice.below(sum / 2 + 1);
        sum -= counts[child];
    }
    counts[7] = sum;
    dice.shuffle(counts);
    return counts;
}

/// Counts of a node's children, near the thresholds.
std::vector<uint32_t> random_counts(Dice& dice, const shader::GuidingSettings& settings) {
    switch (dice.below(5)) {
    case 0:
        return std::vector<uint32_t>(8);
    case 1: // collapses, barely
        return shares(dice, settings.collapse - 1);
    case 2: // does not, barely
        return shares(dice, settings.collapse);
    default:
        break;
    }
    const std::array<uint32_t, 6> likely{0,
                                         dice.below(settings.collapse),
                                         settings.split,
                                         settings.split + 1,
                                         settings.split + 1,
                                         1 + dice.below(2 * settings.split)};
    std::vector<uint32_t> counts(8);
    for (uint32_t& count : counts)
        count = likely[dice.below(likely.size())];
    return counts;
}

/// Gives a leaf a cache at its `first_light`, if there is room.
void random_cache(Dice& dice, const RandomLights& lights, const shader::GuidingSettings& settings,
                  uint32_t first, uint32_t different, LeafState& leaf,
                  std::vector<uint32_t>& caches) {
    const uint32_t count = dice.chance(0.3) ? 0 : 1u << dice.below(7);
    if (count == 0 ||
        leaf.first_light + shader::vlc_cache_words(count, settings.bucket) > caches.size())
        return;
    Buckets buckets(count);
    for (uint32_t left = 1 + dice.below(60); left > 0; --left) {
        // Some are lights that samples may see again, others are not.
        const uint32_t light = first - lights.stride * dice.below(2 * different);
        Lights& bucket = buckets[light % count];
        if (bucket.size() == settings.bucket) continue;
        bucket.insert(light);
        // Some are too old, as if pt_vlc_persist had become lower.
        leaf.cached[light] = dice.below(std::min(settings.persist + 3, shader::VLC_OLDEST));
    }
    // Some buckets are not known, some bring nothing. Dice of their own: whoever counts what else
    // is random must not depend on how many buckets there are.
    Dice own(first + 31 * count);
    const bool known = own.chance(0.8);
    for (uint32_t b = 0; b < count; ++b) {
        BucketDraw bucket{(b + 1.0) / count, 0.0, 0.0};
        if (b + 1 < count) bucket.until -= own.below(1000) / 2000.0 / count;
        if (known && own.chance(0.8)) {
            bucket.draws = 1 + own.below(48);
            if (own.chance(0.8))
                bucket.root = std::ldexp(128 + own.below(128), static_cast<int>(own.below(6)));
        }
        leaf.drawn.push_back(bucket);
    }
    store_cache(leaf, buckets, settings.bucket, caches);
    leaf.inherited = dice.chance(0.2);
}

} // namespace

uint32_t two_halves(double low, double high) {
    return std::bit_cast<uint32_t>(static_cast<float>(low)) >> 16 |
           (std::bit_cast<uint32_t>(static_cast<float>(high)) & 0xffff0000u);
}

void store_cache(LeafState& leaf, const Buckets& buckets, uint32_t bucket_size,
                 std::vector<uint32_t>& caches) {
    for (size_t b = 0; b < buckets.size(); ++b) {
        size_t at = leaf.first_light + b * bucket_size;
        std::fill_n(caches.begin() + static_cast<ptrdiff_t>(at), bucket_size, shader::NONE);
        for (const uint32_t light : buckets[b])
            caches.at(at++) = light + (leaf.cached.at(light) << shader::VLC_AGE_SHIFT);
    }
    leaf.buckets = static_cast<uint32_t>(buckets.size());
    leaf.drawn.resize(buckets.size());
    size_t at = leaf.first_light + buckets.size() * bucket_size;
    for (const BucketDraw& bucket : leaf.drawn) {
        caches.at(at++) = std::bit_cast<uint32_t>(static_cast<float>(bucket.until));
        caches.at(at++) = two_halves(bucket.draws, bucket.root);
    }
}

InnerNodes random_tree(Dice& dice, uint32_t nodes, double deep) {
    InnerNodes inner{""};
    std::vector<Path> leaves = leaves_of(inner);
    while (inner.size() < nodes) {
        const auto count = static_cast<uint32_t>(leaves.size());
        const uint32_t at = dice.chance(deep) ? count - 1 - dice.below(8) : dice.below(count);
        const Path chosen = leaves[at];
        if (chosen.size() >= shader::OCTREE_MAX_DEPTH) {
            dice.shuffle(leaves);
            continue;
        }
        leaves.erase(leaves.begin() + at);
        inner.insert(chosen);
        for (int child = 0; child < 8; ++child)
            leaves.push_back(child_of(chosen, child));
    }
    return inner;
}

uint32_t random_light_sample(Dice& dice, const RandomLights& lights, uint32_t first,
                             uint32_t different) {
    // Drawn in one of three ways, with a power of two that matters to two of them.
    const uint32_t drawn = dice.below(3) << 29 | (40 + dice.below(50)) << 22;
    if (dice.chance(0.05)) return shader::LIGHT_SAMPLE_NONE | drawn;
    // Some lights are never seen, others always.
    const uint32_t which = dice.below(different);
    const bool visible = which % 7 != 3 && dice.chance(lights.visible);
    const uint32_t id = first - lights.stride * which;
    return id | drawn | (visible ? shader::LIGHT_SAMPLE_VISIBLE : 0);
}

TreeState random_samples(Dice& dice, const InnerNodes& inner, const RandomLights& lights,
                         const shader::GuidingSettings& settings,
                         const shader::GuidingHeader& header) {
    const uint32_t sample_capacity = header.sample_capacity;
    TreeState state;
    state.inner = inner;
    for (const Path& node : inner) {
        const std::vector<uint32_t> counts = random_counts(dice, settings);
        for (int child = 0; child < 8; ++child)
            if (const Path leaf = child_of(node, child); !inner.contains(leaf))
                state.leaves[leaf].count = counts[child];
    }

    // Ranges lie in any order in the buffer, with gaps; at its end there is room for nothing.
    std::vector<Path> order = leaves_of(inner);
    dice.shuffle(order);
    state.samples.resize(sample_capacity);
    for (uint32_t& sample : state.samples)
        sample = dice.word() | shader::LIGHT_SAMPLE_VISIBLE;
    state.caches.resize(header.vlc_capacity);
    for (uint32_t& light : state.caches)
        light = dice.word();
    uint32_t used = 0, cached = 0;
    for (const Path& path : order) {
        LeafState& leaf = state.leaves.at(path);
        const std::array<uint32_t, 4> rooms{leaf.count, leaf.count + dice.below(10), leaf.count / 2,
                                            0};
        // Few leaves lose samples.
        leaf.room = rooms[dice.chance(0.8) ? dice.below(2) : dice.below(4)];
        leaf.first_sample = used + (dice.chance(0.1) ? dice.below(10) : 0);
        leaf.first_sample = std::min(leaf.first_sample, sample_capacity);
        leaf.room = std::min(leaf.room, sample_capacity - leaf.first_sample);
        used = leaf.first_sample + leaf.room;

        const uint32_t different = lights.fewest + dice.below(lights.most - lights.fewest + 1);
        const uint32_t first = lights.largest - lights.stride * (lights.fewest * dice.below(4));
        for (uint32_t i = 0; i < leaf.kept(); ++i)
            state.samples[leaf.first_sample + i] =
                random_light_sample(dice, lights, first, different);

        for (double Explored::*sum : {&Explored::listed, &Explored::found, &Explored::cached})
            leaf.explored.*sum =
                dice.chance(0.2)
                    ? 0.0
                    : std::ldexp(128 + dice.below(128), static_cast<int>(dice.below(20)) - 10);

        leaf.first_light = cached;
        random_cache(dice, lights, settings, first, different, leaf, state.caches);
        cached += shader::vlc_cache_words(leaf.buckets, settings.bucket);
    }
    return state;
}

} // namespace vigil::test
