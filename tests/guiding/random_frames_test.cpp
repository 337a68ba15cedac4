// SPDX-License-Identifier: GPL-2.0-or-later
// Single frames from random trees and random samples: the passes' trees and caches are the
// oracle's, bit for bit. Each test also demands that the case it is named after occurred.
#include "guiding_fixture.h"
#include "numerics/record.h"
#include "shared/octree.h"

#include <algorithm>
#include <utility>

namespace vigil::test {
namespace {

/// Thresholds so high that leaves have thousands of samples.
shader::GuidingSettings crowded(uint32_t bucket, uint32_t persist = 0) {
    shader::GuidingSettings settings = settings_with(bucket, persist);
    settings.split = 4000;
    settings.collapse = 2000;
    return settings;
}

TEST_F(GuidingTest, RandomTreesOfAllSizes) {
    start(settings_with(32));
    uint32_t both = 0, empty = 0, dropped = 0, largest = 0;
    for (const uint32_t nodes : {1u, 2u, 3u, 9u, 10u, 33u, 64u, 65u, 250u, 1000u})
        for (const double deep : {0.0, 0.9}) {
            SCOPED_TRACE(testing::Message() << nodes << " nodes, deep " << deep);
            Dice dice(nodes + (deep > 0.0 ? 5000 : 0));
            random_frame(dice, random_tree(dice, nodes, deep), {});
            if (HasFatalFailure()) return;
            both += tree_.splits > 0 && tree_.collapses > 0 ? 1u : 0u;
            dropped += statistics_.dropped;
            empty += 7 * nodes + 1 - statistics_.sampled_leaves;
            largest = std::max(largest, statistics_.nodes);
        }
    EXPECT_GE(both, 10u);
    EXPECT_GT(empty, 1000u);
    EXPECT_GT(dropped, 1000u);
    EXPECT_GT(largest, 1500u);
}

TEST_F(GuidingTest, RandomFramesOneAfterAnother) {
    start(settings_with(8), 128);
    Dice dice(11);
    for (int i = 0; i < 12; ++i) {
        random_frame(dice, state_.inner, {});
        if (HasFatalFailure()) return;
    }
}

TEST_F(GuidingTest, ATreeThatUsesAllNodes) {
    start(settings_with(32));
    Dice dice(12);
    const uint32_t capacity = guiding().header().node_capacity;
    ASSERT_GE(capacity, 4096u);
    RandomLights lights;
    lights.most = 10;
    random_frame(dice, random_tree(dice, capacity, 0.1), lights);
    if (HasFatalFailure()) return;
    EXPECT_GT(statistics_.splits, 100u);
    EXPECT_GT(statistics_.collapses, 100u);
}

TEST_F(GuidingTest, SplitsWithoutRoomAreRefused) {
    start(crowded(32), 64);
    const uint32_t capacity = guiding().header().node_capacity;
    ASSERT_EQ(capacity, 64u);
    uint32_t refused = 0, splits = 0;
    for (uint32_t nodes = capacity - 20; nodes <= capacity; ++nodes) {
        Dice dice(nodes);
        random_frame(dice, random_tree(dice, nodes, 0.2), {});
        if (HasFatalFailure()) return;
        refused += statistics_.splits_refused;
        splits += statistics_.splits;
    }
    EXPECT_GT(refused, 0u);
    EXPECT_GT(splits, 0u);
    record("octree", "node budget exhausted", "splits beyond it are refused in order, and counted");
}

TEST_F(GuidingTest, EveryBucketSize) {
    for (const uint32_t bucket : {1u, 2u, 3u, 4u, 24u, 32u, 48u, 63u, 64u}) {
        SCOPED_TRACE(testing::Message() << "bucket of " << bucket);
        start(settings_with(bucket));
        Dice dice(bucket);
        for (const uint32_t most : {6u, 300u}) {
            RandomLights lights;
            lights.most = most;
            random_frame(dice, random_tree(dice, 40, 0.3), lights);
            if (HasFatalFailure()) return;
        }
    }
}

TEST_F(GuidingTest, FullTables) {
    for (const uint32_t bucket : {1u, 4u, 32u, 64u})
        for (const uint32_t stride : {1u, 3u, 16u, 256u, 1u << 12}) {
            SCOPED_TRACE(testing::Message() << "bucket of " << bucket << ", stride " << stride);
            start(crowded(bucket));
            Dice dice(bucket + stride);
            RandomLights lights;
            lights.fewest = 2500;
            lights.most = 4000;
            lights.visible = 0.9;
            lights.stride = stride;
            random_frame(dice, random_tree(dice, 5, 0.3), lights);
            if (HasFatalFailure()) return;
            EXPECT_GT(statistics_.lights_left_out, 0u);
        }
}

TEST_F(GuidingTest, TablesThatAreFullOnlyAfterMerging) {
    start(crowded(32));
    Dice dice(13);
    RandomLights lights;
    lights.fewest = 900;
    lights.most = 1000;
    lights.visible = 1.0;
    random_frame(dice, random_tree(dice, 3, 0.0), lights);
    if (HasFatalFailure()) return;
    size_t own = 0;
    for (const auto& [path, cache] : caches_.by_leaf)
        own = std::max(own, cache.own.size());
    EXPECT_GT(statistics_.most_lights, own);
    EXPECT_GT(statistics_.lights_left_out, 0u);
}

TEST_F(GuidingTest, LightIdsOfAllSizes) {
    start(settings_with(4));
    for (const uint32_t largest : {shader::VLC_ID_MASK - 1, 0x4000000u, 65536u, 400u}) {
        Dice dice(largest);
        RandomLights lights;
        lights.largest = largest;
        random_frame(dice, random_tree(dice, 30, 0.0), lights);
        if (HasFatalFailure()) return;
    }
}

TEST_F(GuidingTest, OneHugeLeafAmongEmptyOnes) {
    constexpr uint32_t most = shader::VLC_MOST_SAMPLES;
    for (const uint32_t bucket : {1u, 32u, 64u})
        for (const uint32_t count :
             {most - 1, most, most + 1, 2 * most - 1, 2 * most, 12 * most + 5}) {
            SCOPED_TRACE(testing::Message()
                         << "bucket of " << bucket << ", " << count << " samples");
            start(crowded(bucket));
            Dice dice(count + bucket);
            state_ =
                random_samples(dice, random_tree(dice, 20, 0.5), {}, settings_, guiding().header());
            for (auto& [path, leaf] : state_.leaves)
                leaf.count = leaf.room = 0;
            LeafState& huge = std::next(state_.leaves.begin(), dice.below(100))->second;
            huge.count = count + dice.below(2) * 1000;
            huge.first_sample = 123;
            huge.room = count;
            for (uint32_t i = 0; i < count; ++i)
                state_.samples[huge.first_sample + i] = random_light_sample(dice, {}, 50000, 2500);
            frame();
            if (HasFatalFailure()) return;
            EXPECT_EQ(tree_.splits, 1u);
            EXPECT_EQ(statistics_.sampled_leaves, 1u);
        }
}

TEST_F(GuidingTest, MillionsOfSamplesInOneLeaf) {
    // Counted as they come; stored as far as there is room. The largest picture, 16,384 pixels wide
    // and high, has 2^29 samples.
    for (const uint32_t count : {3000000u, 1u << 29}) {
        SCOPED_TRACE(count);
        constexpr uint32_t stored = 20000;
        start(crowded(32, 3));
        Dice dice(count);
        state_ =
            random_samples(dice, random_tree(dice, 20, 0.5), {}, settings_, guiding().header());
        for (auto& [path, leaf] : state_.leaves)
            leaf.count = leaf.room = 0;
        LeafState& huge = std::next(state_.leaves.begin(), 50)->second;
        huge.count = count;
        huge.first_sample = 123;
        huge.room = stored;
        for (uint32_t i = 0; i < stored; ++i)
            state_.samples[huge.first_sample + i] = random_light_sample(dice, {}, 50000, 2500);
        frame();
        if (HasFatalFailure()) return;
        EXPECT_EQ(tree_.splits, 1u);
        EXPECT_EQ(statistics_.dropped, count - stored);
    }
    record("octree", "3 million and 2^29 samples in one leaf, none elsewhere",
           "octree and caches of the plain implementation; what has no room is counted");
}

TEST_F(GuidingTest, LightsThatAppearDoNotTellWhatCachesLack) {
    start(settings_with(16, 3));
    for (uint32_t seed = 1; seed <= 6; ++seed) {
        Dice dice(seed);
        const bool appeared = std::exchange(appears_, seed % 3 != 0);
        const TreeState before =
            random_samples(dice, random_tree(dice, 60, 0.3), {}, settings_, guiding().header());
        state_ = before;
        frame();
        if (HasFatalFailure()) return;
        const auto changed = std::ranges::count_if(before.leaves, [&](const auto& entry) {
            return caches_.by_leaf.at(entry.first).explored.found != entry.second.explored.found;
        });
        if (appeared)
            EXPECT_EQ(changed, 0);
        else
            EXPECT_GT(changed, 20);
    }
}

TEST_F(GuidingTest, ThresholdsOfOneAndOfTwoToThe31) {
    for (const uint32_t threshold : {1u, 0x80000000u}) {
        SCOPED_TRACE(threshold);
        shader::GuidingSettings settings = settings_with(32);
        settings.split = threshold;
        settings.collapse = threshold;
        start(settings, 64);
        for (const uint32_t nodes : {1u, 20u, 64u}) {
            Dice dice(nodes);
            state_ = random_samples(dice, random_tree(dice, nodes, 0.3), {}, settings_with(32),
                                    guiding().header());
            frame();
            if (HasFatalFailure()) return;
        }
    }
    record("octree", "thresholds of 1 and 2^31 samples",
           "octree and caches of the plain implementation");
}

TEST_F(GuidingTest, NoSamplesAtAll) {
    start(settings_with(32));
    Dice dice(15);
    state_ = random_samples(dice, random_tree(dice, 500, 0.5), {}, settings_, guiding().header());
    for (auto& [path, leaf] : state_.leaves)
        leaf.count = 0;
    int frames = 0;
    for (; state_.inner.size() > 1; ++frames) {
        ASSERT_LE(frames, 16)
            << "a tree without samples is gone after as many frames as it has levels";
        frame();
        if (HasFatalFailure()) return;
        EXPECT_EQ(statistics_.cached_leaves, 0u);
    }
    EXPECT_GT(frames, 3);
    record("octree", "no samples anywhere", "the tree vanishes, a level in a frame");
}

TEST_F(GuidingTest, HysteresisHoldsBucketsThatWouldBeMerged) {
    start(settings_with(8));
    shader::GuidingSettings without = settings_;
    without.small_bucket = without.bucket;
    int held = 0, merged = 0, grown = 0;
    for (uint32_t seed = 1; seed <= 6; ++seed) {
        Dice dice(seed);
        RandomLights lights;
        lights.most = 60;
        lights.visible = 0.9;
        const TreeState before =
            random_samples(dice, random_tree(dice, 60, 0.2), lights, settings_, guiding().header());
        state_ = before;
        frame();
        if (HasFatalFailure()) return;
        ByPath<LeafSamples> samples;
        for (const auto& [path, leaf] : before.leaves)
            samples[path] = {std::span(before.samples).subspan(leaf.first_sample, leaf.kept()),
                             leaf.count,
                             leaf.buckets,
                             {},
                             false};
        const Caches plain = make_caches(
            before.inner, samples,
            {without.bucket, without.small_bucket, true, guiding().header().vlc_capacity});
        for (const auto& [path, cache] : caches_.by_leaf) {
            const size_t buckets = cache.buckets.size();
            const uint32_t previous = before.leaves.at(path).buckets;
            held += buckets > plain.by_leaf.at(path).buckets.size() ? 1 : 0;
            merged += buckets > 0 && buckets < previous ? 1 : 0;
            grown += buckets > previous ? 1 : 0;
        }
    }
    EXPECT_GT(held, 20);
    EXPECT_GT(merged, 20);
    EXPECT_GT(grown, 20);
}

TEST_F(GuidingTest, WithoutMergingNeighboursDoNotMatter) {
    shader::GuidingSettings settings = settings_with(16);
    settings.merge_faces = 0;
    start(settings);
    Dice dice(16);
    RandomLights lights;
    lights.most = 200;
    random_frame(dice, random_tree(dice, 200, 0.3), lights);
    if (HasFatalFailure()) return;
    for (const auto& [path, cache] : caches_.by_leaf) {
        EXPECT_EQ(cache.own.empty(), cache.buckets.empty()) << path;
    }
}

TEST_F(GuidingTest, TheBufferOfCachesIsShared) {
    // All nodes in use, and more lights around every leaf than its share of the buffer.
    start(crowded(64), 64);
    Dice dice(17);
    const uint32_t nodes = guiding().header().node_capacity;
    RandomLights lights;
    lights.fewest = 1000;
    lights.most = 2000;
    lights.visible = 1.0;
    state_ =
        random_samples(dice, random_tree(dice, nodes, 0.0), lights, settings_, guiding().header());
    const auto leaves = static_cast<uint32_t>(state_.leaves.size());
    const uint32_t each = guiding().header().sample_capacity / leaves;
    uint32_t first = 0;
    for (auto& [path, leaf] : state_.leaves) {
        leaf.count = leaf.room = each;
        leaf.first_sample = first;
        for (uint32_t i = 0; i < each; ++i)
            state_.samples[first + i] =
                random_light_sample(dice, lights, 5000 * (1 + first % 3), 2000);
        first += each;
    }
    frame();
    if (HasFatalFailure()) return;
    EXPECT_EQ(statistics_.cached_leaves, leaves);
    EXPECT_EQ(statistics_.most_lights, 64u); // one bucket
    EXPECT_GT(statistics_.lights_left_out, 0u);
}

class RoomForCaches : public GuidingTest {
protected:
    /// Makes little room at first. Sizes differ from test to test: a size that stays keeps its
    /// room.
    void start_with_little(uint32_t picture_size) {
        first_cache_part_ = vkpt::Guiding::Options{}.first_cache_part;
        start(settings_with(2, 16), picture_size);
        first_ = guiding().header().vlc_capacity;
        EXPECT_LE(first_, guiding().header().vlc_most / 4);
    }
    /// Many lights in each leaf of a tree, and so few samples that none is split.
    void see_many_lights(Dice& dice, uint32_t nodes) {
        RandomLights lights;
        lights.fewest = lights.most = 60;
        lights.visible = 1.0;
        state_ = random_samples(dice, random_tree(dice, nodes, 0.3), lights, settings_,
                                guiding().header());
        for (auto& [path, leaf] : state_.leaves)
            leaf.count = std::min(leaf.count, 40u);
    }
    uint32_t first_ = 0; // words
};

TEST_F(RoomForCaches, GrowsAndKeepsThem) {
    start_with_little(100);
    Dice dice(23);
    for (uint32_t nodes = 20; statistics_.vlc_used <= first_ / 8 * 7; nodes += 20) {
        see_many_lights(dice, nodes);
        frame();
        if (HasFatalFailure()) return;
        ASSERT_EQ(statistics_.caches_refused, 0u) << nodes << " nodes";
    }
    // The next frame has more room, and starts from the caches of this one.
    const uint32_t asked = statistics_.vlc_used;
    frame();
    if (HasFatalFailure()) return;
    EXPECT_EQ(guiding().worst().cache_words, asked);
    EXPECT_GE(guiding().header().vlc_capacity, asked + asked / 2);
    EXPECT_GT(statistics_.cached_lights, 1000u);
    frame();
}

TEST_F(RoomForCaches, CachesWaitForIt) {
    start_with_little(104);
    Dice dice(24);
    see_many_lights(dice, 600);
    upload();
    run_passes();
    EXPECT_GT(statistics_.caches_refused, 0u);
    EXPECT_GT(statistics_.cached_leaves, 0u);
    const uint32_t asked = statistics_.vlc_used;
    EXPECT_GT(asked, first_);
    run_passes();
    EXPECT_GE(guiding().header().vlc_capacity, asked + asked / 2);
    see_many_lights(dice, 600);
    frame();
    EXPECT_EQ(statistics_.caches_refused, 0u);
}

TEST_F(RoomForCaches, GrowsInTheFrameThatStartsAnew) {
    start_with_little(108);
    Dice dice(25);
    see_many_lights(dice, 600);
    upload();
    run_passes();
    EXPECT_GT(statistics_.vlc_used, first_);
    start(settings_, 108); // no validation message: the header is copied once
    EXPECT_GT(guiding().header().vlc_capacity, first_);
}

/// Lights of all caches that no sample saw in the last frame.
size_t aged_lights(const Caches& caches) {
    size_t aged = 0;
    for (const auto& [path, cache] : caches.by_leaf)
        for (const auto& [light, age] : cache.ages)
            aged += age > 0 ? 1 : 0;
    return aged;
}

TEST_F(GuidingTest, LightsStayForSomeFrames) {
    for (const uint32_t persist : {1u, 3u, 16u, shader::VLC_OLDEST}) {
        start(settings_with(8, persist));
        for (const uint32_t nodes : {1u, 20u, 600u}) {
            SCOPED_TRACE(testing::Message() << persist << " frames, " << nodes << " nodes");
            Dice dice(persist + nodes);
            RandomLights lights;
            lights.visible = 0.2;
            random_frame(dice, random_tree(dice, nodes, 0.3), lights);
            if (HasFatalFailure()) return;
        }
        EXPECT_GT(aged_lights(caches_), 100u);
    }
}

TEST_F(GuidingTest, LightsStayWithoutNeighbours) {
    shader::GuidingSettings settings = settings_with(16, 5);
    settings.merge_faces = 0;
    start(settings);
    Dice dice(18);
    random_frame(dice, random_tree(dice, 200, 0.3), {});
}

TEST_F(GuidingTest, FullTablesHaveNoRoomForLightsThatWereNotSeen) {
    for (const uint32_t bucket : {1u, 4u, 32u, 64u}) {
        SCOPED_TRACE(testing::Message() << "bucket of " << bucket);
        start(crowded(bucket, 10));
        Dice dice(bucket);
        for (const uint32_t most : {200u, 1000u, 4000u}) {
            RandomLights lights;
            lights.fewest = most / 2;
            lights.most = most;
            lights.stride = 3;
            random_frame(dice, random_tree(dice, 5, 0.3), lights);
            if (HasFatalFailure()) return;
        }
        EXPECT_GT(statistics_.lights_left_out, 0u);
    }
}

TEST_F(GuidingTest, LightsStayInATreeThatUsesAllNodes) {
    start(settings_with(32, 4));
    Dice dice(19);
    RandomLights lights;
    lights.most = 10;
    random_frame(dice, random_tree(dice, guiding().header().node_capacity, 0.1), lights);
}

TEST_F(GuidingTest, LightsStayIfAllJustHaveRoom) {
    // Two thirds of a table of 32 buckets are 512 lights.
    shader::GuidingSettings settings = settings_with(24, 5);
    settings.merge_faces = 0;
    start(settings);
    ASSERT_EQ(table_buckets(shader::VLC_TABLE_SIZE, 24), 32u);
    Dice dice(20);
    state_ = random_samples(dice, {""}, {}, settings, guiding().header());
    uint32_t at = 0, before = 108; // lights in the cache of the leaf; 400 others are seen
    for (auto& [path, leaf] : state_.leaves) {
        leaf.first_sample = at;
        leaf.count = leaf.room = 400;
        for (uint32_t light = 0; light < 400; ++light)
            state_.samples[at + light] = light | shader::LIGHT_SAMPLE_VISIBLE;
        leaf.inherited = false;
        leaf.first_light = at + 16 * (before - 108);
        leaf.cached.clear();
        leaf.drawn.clear();
        Buckets buckets(16);
        for (uint32_t light = 1000; light < 1000 + before; ++light) {
            leaf.cached[light] = 1;
            buckets[light % 16].insert(light);
        }
        store_cache(leaf, buckets, 24, state_.caches);
        at += 400;
        ++before;
    }
    frame();
    if (HasFatalFailure()) return;
    EXPECT_EQ(caches_.by_leaf.at("4").ages.size(), 512u);
    EXPECT_EQ(caches_.by_leaf.at("5").ages.size(), 400u);
}

} // namespace
} // namespace vigil::test
