// SPDX-License-Identifier: GPL-2.0-or-later
// See vlc_oracle.h. Every function follows its definition word by word; none of them is fast.
#include "vlc_oracle.h"

#include "shared/guiding_types.h"

#include <algorithm>
#include <cmath>

namespace vigil::test {
namespace {

/// Largest power of two that is not above `value`, which is at least 1.
uint32_t power_below(uint32_t value) {
    uint32_t power = 1;
    while (power <= value / 2)
        power *= 2;
    return power;
}

/// Smallest power of two that is not below `value`.
uint32_t power_above(uint32_t value) {
    uint32_t power = 1;
    while (power < value)
        power *= 2;
    return power;
}

/// Buckets that the hash table has room for.
uint32_t most_table_buckets(uint32_t bucket) {
    return power_below(std::min(shader::VLC_TABLE_MOST_BUCKETS, shader::VLC_TABLE_SIZE / bucket));
}

Lights visible_lights(std::span<const uint32_t> kept) {
    Lights lights;
    for (const size_t place : sample_places(kept.size(), shader::VLC_MOST_SAMPLES)) {
        const uint32_t sample = kept[place];
        if (sample >= shader::LIGHT_SAMPLE_VISIBLE) lights.insert(sample % (1u << 22));
    }
    return lights;
}

/// Second moments over the last 48 draws or so, and the share of draws with the least of both
/// together.
Explored explore(const Explored& before, std::span<const uint32_t> kept, bool appeared) {
    double listed = 0.0, found = 0.0, cached = 0.0, squares = 0.0;
    for (const size_t place : sample_places(kept.size(), shader::VLC_MOST_SAMPLES)) {
        const uint32_t sample = kept[place];
        const bool visible = sample >> 31 != 0;
        const double worth =
            visible ? std::ldexp(1.0, static_cast<int>(sample >> 22 & 127) - 64) : 0.0;
        switch (sample >> 29 & 3) {
        case 0: // by the cache
            cached += 1.0;
            squares += worth * worth;
            break;
        case 1: // by the table
            break;
        case 2: // by a list
            if (appeared) break;
            listed += 1.0;
            found += worth * worth;
            break;
        }
    }
    if (cached == 0.0 && found > 0.0) return {}; // there was no cache, but there will be one
    const double keep = std::max(0.0, 1.0 - listed / 48.0);
    const double keep_cached = before.cached > 0.0 ? std::max(0.0, 1.0 - cached / 48.0) : 0.0;
    Explored after{keep * before.listed + listed, keep * before.found + found, before.cached,
                   before.share};
    if (cached == 0.0) return after;
    after.cached = keep_cached * before.cached + (1.0 - keep_cached) * squares / cached;
    after.share = 0.0;
    const double a = std::sqrt(after.found), b = std::sqrt(after.listed * after.cached);
    if (a > 0.0) after.share = std::min(0.9, a / (a + b));
    return after;
}

/// What is remembered of each bucket after this frame's draws from the cache.
void learn_buckets(BucketDraws& drawn, std::span<const uint32_t> kept) {
    std::vector<double> draws(drawn.size()), squares(drawn.size());
    for (const size_t place : sample_places(kept.size(), shader::VLC_MOST_SAMPLES)) {
        const uint32_t sample = kept[place];
        if ((sample >> 29 & 3) != 0) continue; // not by the cache
        const size_t bucket = sample % drawn.size();
        draws[bucket] += 1.0;
        if (sample >> 31 != 0)
            squares[bucket] += std::ldexp(1.0, 2 * (static_cast<int>(sample >> 22 & 127) - 64));
    }
    for (size_t b = drawn.size(); b-- > 0;) {
        if (draws[b] == 0.0) continue;
        const double probability = drawn[b].until - (b > 0 ? drawn[b - 1].until : 0.0);
        const double fresh = squares[b] * probability * probability / draws[b];
        BucketDraw& memory = drawn[b];
        memory.draws = std::min(memory.draws + draws[b], 48.0);
        const double part = std::min(draws[b] / memory.draws, 1.0);
        memory.root = std::sqrt((1.0 - part) * memory.root * memory.root + part * fresh);
    }
}

/// What is remembered of `count` buckets where there were others: sums of importances add up.
BucketDraws hand_on_buckets(const BucketDraws& before, size_t count) {
    BucketDraws after(count);
    if (before.empty()) return after;
    if (before.size() >= count) {
        for (size_t b = 0; b < before.size(); ++b) {
            after[b % count].root += before[b].root;
            after[b % count].draws +=
                before[b].draws * static_cast<double>(count) / static_cast<double>(before.size());
        }
    } else {
        const double parts = static_cast<double>(count) / static_cast<double>(before.size());
        for (size_t b = 0; b < count; ++b) {
            after[b].root = before[b % before.size()].root / parts;
            after[b].draws = before[b % before.size()].draws;
        }
    }
    return after;
}

/// Nine tenths of the draws go where they are expected to bring most.
void share_draws(BucketDraws& drawn) {
    double draws = 0.0, known = 0.0, sum = 0.0;
    for (const BucketDraw& bucket : drawn) {
        draws += bucket.draws;
        known += bucket.draws * bucket.root;
    }
    const double typical = draws > 0.0 ? known / draws : 0.0;
    std::vector<double> expected;
    for (const BucketDraw& bucket : drawn) {
        expected.push_back((bucket.draws * bucket.root + 4.0 * typical) / (bucket.draws + 4.0));
        sum += expected.back();
    }
    double until = 0.0;
    for (size_t b = 0; b < drawn.size(); ++b) {
        const double even = 1.0 / static_cast<double>(drawn.size());
        until += sum > 0.0 ? 0.1 * even + 0.9 * expected[b] / sum : even;
        drawn[b].until = until;
    }
}

/// A hash table that keeps the first ids of a full bucket.
Buckets fill_table(const Lights& lights, uint32_t buckets, uint32_t bucket_size, bool& left_out) {
    Buckets table(buckets);
    for (const uint32_t light : lights) {
        Lights& bucket = table[light % buckets];
        bucket.insert(light);
        if (bucket.size() > bucket_size) {
            bucket.erase(std::prev(bucket.end()));
            left_out = true;
        }
    }
    return table;
}

Lights lights_in(const Buckets& table) {
    Lights lights;
    for (const Lights& bucket : table)
        lights.insert(bucket.begin(), bucket.end());
    return lights;
}

/// Halves the number of buckets while the merged ones hold what they have to.
Buckets merge_buckets(Buckets table, uint32_t previous_buckets, const CacheLimits& limits) {
    while (table.size() > 1) {
        const size_t half = table.size() / 2;
        const uint32_t limit = half < previous_buckets ? limits.small_bucket : limits.bucket;
        Buckets merged(half);
        size_t fullest = 0;
        for (size_t i = 0; i < half; ++i) {
            merged[i] = table[i];
            merged[i].insert(table[i + half].begin(), table[i + half].end());
            fullest = std::max(fullest, merged[i].size());
        }
        if (fullest > limit) break;
        table = merged;
    }
    return table;
}

} // namespace

bool LowBitsFirst::operator()(uint32_t a, uint32_t b) const {
    for (int bit = 0; bit < 32; ++bit)
        if ((a >> bit & 1u) != (b >> bit & 1u)) return (a >> bit & 1u) < (b >> bit & 1u);
    return false;
}

std::vector<size_t> sample_places(size_t kept, size_t most) {
    const size_t taken = std::min(kept, most);
    std::vector<size_t> places(taken);
    for (size_t i = 0; i < taken; ++i)
        places[i] = i * kept / taken;
    return places;
}

uint32_t table_buckets(uint32_t entries, uint32_t bucket) {
    const uint32_t wanted = (3 * entries + 2 * bucket - 1) / (2 * bucket);
    return std::min(power_above(wanted), most_table_buckets(bucket));
}

Caches make_caches(const InnerNodes& inner, const ByPath<LeafSamples>& samples,
                   const CacheLimits& limits) {
    Caches caches;

    // Deduplicate each leaf's samples.
    for (const auto& [leaf, leaf_samples] : samples) {
        const auto kept = static_cast<uint32_t>(leaf_samples.kept.size());
        const uint32_t processed = std::min(kept, shader::VLC_MOST_SAMPLES);
        const Buckets table =
            fill_table(visible_lights(leaf_samples.kept), table_buckets(processed, limits.bucket),
                       limits.bucket, caches.lights_left_out);
        caches.by_leaf[leaf].own = lights_in(table);
        caches.by_leaf[leaf].explored =
            leaf_samples.count > 0
                ? explore(leaf_samples.explored, leaf_samples.kept, limits.appeared)
                : leaf_samples.explored;
    }

    // All caches together fit in the buffer, even if every leaf that has samples or had a cache
    // used its quota.
    const auto listed = static_cast<uint32_t>(std::ranges::count_if(samples, [](const auto& leaf) {
        return leaf.second.count > 0 || leaf.second.previous_buckets > 0;
    }));
    const uint32_t quota = power_below(
        std::max(1u, limits.vlc_capacity / ((limits.bucket + 2) * std::max(listed, 1u))));

    const uint32_t most_buckets = std::min(most_table_buckets(limits.bucket), quota);

    for (auto& [leaf, cache] : caches.by_leaf) {
        // Where no surface was seen no cache is made, unless there is one to keep.
        const LeafSamples& leaf_samples = samples.at(leaf);
        if (leaf_samples.count == 0 && (limits.persist == 0 || leaf_samples.previous_buckets == 0))
            continue;

        // Merge with the neighbours' lights.
        Ages lights;
        uint32_t entries = 0;
        uint64_t samples_near = leaf_samples.count;
        const auto take_in = [&](const Lights& seen, uint32_t age) {
            for (const uint32_t light : seen)
                lights.try_emplace(light, age);
            entries += static_cast<uint32_t>(seen.size());
        };
        take_in(cache.own, 0);
        // What only neighbours see is soon too old.
        const uint32_t borrowed =
            limits.persist > shader::VLC_BORROWED ? limits.persist - shader::VLC_BORROWED : 0;
        for (int face = 0; face < 6; ++face) {
            if ((limits.merge_faces >> face & 1u) == 0) continue;
            const std::optional<Path> neighbour = neighbour_of(inner, leaf, face);
            if (!neighbour) continue;
            if (leaf_samples.count > 0) take_in(caches.by_leaf.at(*neighbour).own, borrowed);
            samples_near += samples.at(*neighbour).count;
        }

        // Keep those of the cache before, if the table has room enough for all. They age where
        // samples could have seen them, and sooner where a split left them behind.
        if (limits.persist > 0) {
            const auto before = static_cast<uint32_t>(leaf_samples.previous.size());
            if (3 * (entries + before) <= 2 * most_buckets * limits.bucket) {
                entries += before;
                uint32_t older = samples_near > 0 ? 1 : 0;
                if (leaf_samples.inherited) older = (7 * limits.persist + 7) / 8;
                for (const auto& [light, age] : leaf_samples.previous) {
                    if (age + older > limits.persist) continue;
                    uint32_t& least = lights.try_emplace(light, age + older).first->second;
                    least = std::min(least, age + older);
                }
            }
        }
        if (lights.empty()) continue;

        // Merge buckets, bottom-up.
        Lights ids;
        for (const auto& [light, age] : lights)
            ids.insert(light);
        const uint32_t buckets = std::min(table_buckets(entries, limits.bucket), quota);
        const Buckets table = fill_table(ids, buckets, limits.bucket, caches.lights_left_out);
        cache.buckets = merge_buckets(table, leaf_samples.previous_buckets, limits);
        for (const uint32_t light : lights_in(cache.buckets))
            cache.ages[light] = lights.at(light);

        // How to draw them.
        BucketDraws drawn = leaf_samples.drawn;
        if (drawn.size() > 1 && !leaf_samples.inherited) learn_buckets(drawn, leaf_samples.kept);
        const bool knows = limits.weigh && cache.buckets.size() > 1;
        cache.drawn = knows ? hand_on_buckets(drawn, cache.buckets.size())
                            : BucketDraws(cache.buckets.size());
        share_draws(cache.drawn);
    }
    return caches;
}

} // namespace vigil::test
