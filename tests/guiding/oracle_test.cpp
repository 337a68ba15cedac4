// SPDX-License-Identifier: GPL-2.0-or-later
// The oracle itself, on cases small enough to be worked out by hand. What agrees with the oracle is
// only as right as the oracle.
#include "random_trees.h"
#include "shared/guiding_types.h"
#include "vlc_oracle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace vigil::test {
namespace {

constexpr uint32_t visible = shader::LIGHT_SAMPLE_VISIBLE;

ByPath<uint32_t> counts_of(const InnerNodes& inner, const ByPath<uint32_t>& known) {
    ByPath<uint32_t> counts;
    for (const Path& leaf : leaves_of(inner)) {
        const auto found = known.find(leaf);
        counts[leaf] = found == known.end() ? 0 : found->second;
    }
    return counts;
}

constexpr OctreeLimits roomy{100, 50, 1000, 16};

TEST(OctreeOracle, LeavesComeInTheOrderOfTheirIndices) {
    const InnerNodes inner{"", "1", "6", "14"};
    const std::vector<Path> expected{"0",   "2",   "3",   "4",   "5",  "7",   "10",  "11",
                                     "12",  "13",  "15",  "16",  "17", "60",  "61",  "62",
                                     "63",  "64",  "65",  "66",  "67", "140", "141", "142",
                                     "143", "144", "145", "146", "147"};
    EXPECT_EQ(leaves_of(inner), expected);
}

TEST(OctreeOracle, LeavesTileTheRoot) {
    Dice dice(3);
    const InnerNodes inner = random_tree(dice, 200, 0.3);
    uint64_t volume = 0;
    for (const Path& leaf : leaves_of(inner)) {
        const Cube cube = cube_of(leaf);
        volume += static_cast<uint64_t>(cube.size) * cube.size * cube.size;
        EXPECT_EQ(leaf_with(inner, cube.lowest), leaf);
        EXPECT_EQ(leaf_with(inner, cube.lowest + cube.size - 1), leaf);
    }
    EXPECT_EQ(volume, uint64_t{1} << 48);
}

TEST(OctreeOracle, NeighboursLieBeyondTheMiddleOfTheFaces) {
    const InnerNodes inner{"", "1"};
    EXPECT_EQ(neighbour_of(inner, "0", 0), std::nullopt);
    // The centre of the face towards +x is a corner of four cubes; the one above it in y and z
    // counts.
    EXPECT_EQ(neighbour_of(inner, "0", 1), "16");
    EXPECT_EQ(neighbour_of(inner, "0", 3), "2");
    EXPECT_EQ(neighbour_of(inner, "16", 0), "0"); // one that is larger
    EXPECT_EQ(neighbour_of(inner, "16", 1), "17");
    EXPECT_EQ(neighbour_of(inner, "16", 5), "5");
    EXPECT_EQ(neighbour_of(inner, "17", 1), std::nullopt);
}

TEST(OctreeOracle, NoLeafIsANeighbourTwice) {
    Dice dice(4);
    const InnerNodes inner = random_tree(dice, 300, 0.5);
    for (const Path& leaf : leaves_of(inner)) {
        std::set<Path> neighbours{leaf};
        size_t faces = 1;
        for (int face = 0; face < 6; ++face)
            if (const std::optional<Path> neighbour = neighbour_of(inner, leaf, face)) {
                neighbours.insert(*neighbour);
                ++faces;
            }
        EXPECT_EQ(neighbours.size(), faces) << leaf;
    }
}

TEST(OctreeOracle, ThresholdsAreSharp) {
    const InnerNodes inner{"", "1", "2"};
    const ByPath<uint32_t> counts =
        counts_of(inner, {{"0", 100}, {"3", 101}, {"10", 49}, {"20", 25}, {"27", 25}});
    const AdaptedOctree result = adapt(inner, counts, roomy);
    EXPECT_EQ(result.inner, (InnerNodes{"", "2", "3"}));
    EXPECT_EQ(result.splits, 1u);
    EXPECT_EQ(result.collapses, 1u);
    EXPECT_EQ(result.source.at("0"), "0");
    EXPECT_EQ(result.source.at("1"), "10");
    EXPECT_EQ(result.source.at("35"), "3");
}

TEST(OctreeOracle, TheRootStaysDivided) {
    const InnerNodes inner{""};
    EXPECT_EQ(adapt(inner, counts_of(inner, {}), roomy).inner, inner);
}

TEST(OctreeOracle, OnlyNodesOfEightLeavesCollapse) {
    const InnerNodes inner{"", "1", "10"};
    EXPECT_EQ(adapt(inner, counts_of(inner, {}), roomy).inner, (InnerNodes{"", "1"}));
}

TEST(OctreeOracle, ACollapsedNodeTakesTheFirstOfItsMostSampledChildren) {
    const InnerNodes inner{"", "4"};
    const ByPath<uint32_t> counts = counts_of(inner, {{"42", 3}, {"45", 7}, {"47", 7}});
    EXPECT_EQ(adapt(inner, counts, roomy).source.at("4"), "45");
    EXPECT_EQ(adapt(inner, counts_of(inner, {}), roomy).source.at("4"), "40");
}

TEST(OctreeOracle, SplitsAreRefusedFromWhereRoomRunsOut) {
    const InnerNodes inner{"", "1", "2"};
    const ByPath<uint32_t> counts = counts_of(
        inner, {{"0", 500}, {"4", 500}, {"5", 500}, {"10", 500}}); // "2" is empty and makes room
    OctreeLimits limits = roomy;
    limits.node_capacity = 4;
    const AdaptedOctree result = adapt(inner, counts, limits);
    EXPECT_EQ(result.inner, (InnerNodes{"", "0", "1", "4"}));
    EXPECT_EQ(result.splits, 2u);
    EXPECT_EQ(result.splits_refused, 2u);
}

TEST(OctreeOracle, ThereIsADeepestLevel) {
    InnerNodes inner;
    for (Path path; path.size() < 15; path += '7')
        inner.insert(path);
    const Path last(15, '7');
    inner = adapt(inner, counts_of(inner, {{last, 1000}}), roomy).inner;
    EXPECT_TRUE(inner.contains(last));
    EXPECT_EQ(cube_of(last + '0').size, 1);
    const AdaptedOctree again = adapt(inner, counts_of(inner, {{last + '7', 1000}}), roomy);
    EXPECT_EQ(again.inner, inner);
    EXPECT_EQ(again.splits + again.splits_refused, 0u);
}

class VlcOracle : public testing::Test {
protected:
    /// A cache of leaf "0" in a tree of eight leaves of which only "0" and "1" have samples.
    Cache cache(const std::vector<uint32_t>& own, const std::vector<uint32_t>& neighbour,
                const CacheLimits& limits, uint32_t previous_buckets = 0) {
        const InnerNodes inner{""};
        ByPath<LeafSamples> samples;
        for (const Path& leaf : leaves_of(inner))
            samples[leaf] = {};
        samples["0"].kept = own;
        samples["0"].count = static_cast<uint32_t>(own.size());
        samples["0"].previous_buckets = previous_buckets;
        samples["1"].kept = neighbour;
        const Caches caches = make_caches(inner, samples, limits);
        left_out_ = caches.lights_left_out;
        return caches.by_leaf.at("0");
    }
    static std::vector<uint32_t> seen(std::vector<uint32_t> lights) {
        for (uint32_t& light : lights)
            light |= visible;
        return lights;
    }
    static std::vector<uint32_t> range(uint32_t first, uint32_t count, uint32_t stride = 1) {
        std::vector<uint32_t> lights;
        for (uint32_t i = 0; i < count; ++i)
            lights.push_back(first + stride * i);
        return lights;
    }
    bool left_out_ = false;
};

constexpr CacheLimits plenty{4, 3, 0x3f, 1u << 20};

TEST_F(VlcOracle, OnlyVisibleSamplesCountAndOnlyOnce) {
    const Cache found =
        cache({visible | 5, 6, visible | 5, shader::LIGHT_SAMPLE_NONE, visible | 2}, {}, plenty);
    EXPECT_EQ(found.own, (Lights{2, 5}));
    EXPECT_EQ(found.buckets, (Buckets{{2, 5}}));
    EXPECT_FALSE(left_out_);
}

TEST_F(VlcOracle, NoLightsNoBuckets) {
    EXPECT_TRUE(cache({1, 2, shader::LIGHT_SAMPLE_NONE}, {}, plenty).buckets.empty());
}

TEST_F(VlcOracle, NeighboursAreTakenInUnlessMergingIsOff) {
    const Cache merged = cache(seen({8}), seen({1, 8}), plenty);
    EXPECT_EQ(merged.own, (Lights{8}));
    EXPECT_EQ(merged.buckets, (Buckets{{1, 8}}));
    CacheLimits alone = plenty;
    alone.merge_faces = 0;
    EXPECT_EQ(cache(seen({8}), seen({1, 8}), alone).buckets, (Buckets{{8}}));
}

TEST_F(VlcOracle, LightsSpreadOverAsFewBucketsAsHoldThem) {
    EXPECT_EQ(cache(seen({0, 1, 2, 3}), {}, plenty).buckets.size(), 1u);
    EXPECT_EQ(cache(seen({0, 1, 2, 3, 4}), {}, plenty).buckets, (Buckets{{0, 2, 4}, {1, 3}}));
    // Six of nine lights are even: one of two buckets would be too full.
    EXPECT_EQ(cache(seen({0, 1, 2, 3, 4, 5, 6, 8, 10}), {}, plenty).buckets,
              (Buckets{{0, 4, 8}, {1, 5}, {2, 6, 10}, {3}}));
}

TEST_F(VlcOracle, LightsAreOrderedByTheirLowBits) {
    const Lights lights{0, 1, 2, 3, 4, 5, 6, 7, 0x40000000, 0x7ffffffe};
    EXPECT_EQ(std::vector<uint32_t>(lights.begin(), lights.end()),
              (std::vector<uint32_t>{0, 0x40000000, 4, 2, 6, 0x7ffffffe, 1, 5, 3, 7}));
}

TEST_F(VlcOracle, FewerBucketsThanBeforeNeedMoreSpace) {
    const std::vector<uint32_t> lights = seen({0, 1, 2, 3});
    EXPECT_EQ(cache(lights, {}, plenty, 1).buckets.size(), 1u);
    EXPECT_EQ(cache(lights, {}, plenty, 2).buckets.size(), 2u); // 4 > 3
    EXPECT_EQ(cache(seen({0, 1, 2}), {}, plenty, 2).buckets.size(), 1u);
}

TEST_F(VlcOracle, AFullBucketKeepsItsFirstIds) {
    // 6 samples: 4 buckets. All in bucket 0; in units of 8 the order is 0 .. 4, 2, 6, 1, 5, 3.
    const Cache found = cache(seen({48, 8, 40, 32, 16, 24}), {}, plenty);
    EXPECT_EQ(found.own, (Lights{32, 16, 48, 8}));
    EXPECT_TRUE(left_out_);
}

TEST_F(VlcOracle, TheBufferLimitsBuckets) {
    CacheLimits narrow = plenty;
    narrow.vlc_capacity = (4 + 2) * 3; // 3, so 2 buckets for the leaf that has samples
    const Cache found = cache(seen(range(0, 100)), {}, narrow);
    EXPECT_EQ(found.own.size(), 100u);
    EXPECT_EQ(found.buckets, (Buckets{{0, 64, 32, 96}, {1, 65, 33, 97}}));
}

TEST_F(VlcOracle, TableSizesAreTheDefinitions) {
    EXPECT_EQ(table_buckets(0, 32), 1u);
    EXPECT_EQ(table_buckets(21, 32), 1u);
    EXPECT_EQ(table_buckets(22, 32), 2u);
    EXPECT_EQ(table_buckets(16384, 32), shader::VLC_TABLE_SIZE / 32);
    EXPECT_EQ(table_buckets(16384, 33), shader::VLC_TABLE_SIZE / 64);
    EXPECT_EQ(table_buckets(16384, 64), shader::VLC_TABLE_SIZE / 64);
    EXPECT_EQ(table_buckets(16384, 1), shader::VLC_TABLE_MOST_BUCKETS);
    EXPECT_EQ(table_buckets(6, 4), 4u);
}

TEST_F(VlcOracle, ManySamplesArePassedOverEvenly) {
    EXPECT_EQ(sample_places(3, 4), (std::vector<size_t>{0, 1, 2}));
    EXPECT_EQ(sample_places(7, 4), (std::vector<size_t>{0, 1, 3, 5}));
    EXPECT_EQ(sample_places(12345, 4000).back(), 12341u);
    for (const uint kept : {4096u, 4097u, 10000u, 0xffffffffu})
        for (const uint i : {0u, 1u, 4095u})
            EXPECT_EQ(shader::spread_place(i, kept, 4096), size_t{i} * kept / 4096);
    constexpr uint32_t most = shader::VLC_MOST_SAMPLES;
    std::vector<uint32_t> samples(2 * most + most / 2, shader::LIGHT_SAMPLE_NONE);
    samples[0] = visible | 1;
    samples[1] = visible | 2; // passed over
    samples[2 * most - 2] = visible | 3;
    samples[samples.size() - 3] = visible | 4; // the last one taken
    EXPECT_EQ(cache(samples, {}, plenty).own, (Lights{1, 3, 4}));
}

TEST_F(VlcOracle, LightsThatWereNotSeenGrowOlder) {
    const InnerNodes inner{""};
    const std::vector<uint32_t> own = seen({1, 2});
    ByPath<LeafSamples> samples;
    for (const Path& leaf : leaves_of(inner))
        samples[leaf] = {};
    samples["0"] = {own, 5, 1, {{2, 3}, {4, 1}, {8, 4}}, false};
    samples["7"] = {{}, 0, 1, {{4, 1}}, false}; // no samples in it and around it
    CacheLimits limits = plenty;
    limits.persist = 4;
    Caches caches = make_caches(inner, samples, limits);
    EXPECT_EQ(caches.by_leaf.at("0").ages, (Ages{{1, 0}, {2, 0}, {4, 2}})); // 8 is too old
    EXPECT_EQ(caches.by_leaf.at("7").ages, (Ages{{4, 1}}));

    // What was learned in a larger leaf is forgotten after an eighth of the time.
    samples["0"].inherited = true;
    limits.persist = 16;
    caches = make_caches(inner, samples, limits);
    EXPECT_EQ(caches.by_leaf.at("0").ages, (Ages{{1, 0}, {2, 0}, {4, 15}}));

    limits.persist = 0;
    caches = make_caches(inner, samples, limits);
    EXPECT_EQ(caches.by_leaf.at("0").ages, (Ages{{1, 0}, {2, 0}}));
    EXPECT_TRUE(caches.by_leaf.at("7").buckets.empty());
}

TEST_F(VlcOracle, LightsThatOnlyNeighboursSeeAreOldAlready) {
    CacheLimits limits = plenty;
    limits.persist = 4;
    EXPECT_EQ(cache(seen({8}), seen({1, 8}), limits).ages, (Ages{{1, 2}, {8, 0}}));
    limits.persist = 1;
    EXPECT_EQ(cache(seen({8}), seen({1, 8}), limits).ages, (Ages{{1, 0}, {8, 0}}));
}

TEST_F(VlcOracle, LightsThatWereNotSeenMustAllHaveRoom) {
    const InnerNodes inner{""};
    CacheLimits limits = plenty;
    limits.persist = 4;
    limits.vlc_capacity = (4 + 2) * 2; // two buckets of four for the leaf: room for 5.3 lights
    const std::vector<uint32_t> own = seen({1, 2, 3});
    for (const uint32_t before : {2u, 3u}) {
        ByPath<LeafSamples> samples;
        for (const Path& leaf : leaves_of(inner))
            samples[leaf] = {};
        samples["0"] = {own, 3, 1, {}, false};
        for (uint32_t light = 0; light < before; ++light)
            samples["0"].previous[10 + light] = 0;
        const Caches caches = make_caches(inner, samples, limits);
        EXPECT_EQ(caches.by_leaf.at("0").ages.size(), before == 2 ? 5u : 3u);
    }
}

} // namespace
} // namespace vigil::test
