// SPDX-License-Identifier: GPL-2.0-or-later
// Decompression of visibility: exact rows for hand-made and random input, and damaged rows.
#include "formats/bsp.h"
#include "formats/small_level.h"
#include "level/pvs.h"

#include <gtest/gtest.h>

#include <bit>
#include <random>

namespace vigil {
namespace {

/// A level that consists of visibility rows alone, already checked.
Bsp level_with_rows(uint32_t clusters, const std::vector<Bytes>& rows) {
    Bsp bsp;
    bsp.cluster_count = clusters;
    for (const Bytes& row : rows) {
        const auto offset = static_cast<uint32_t>(bsp.visibility.size());
        bsp.visibility_offsets.push_back({offset, offset});
        append_bytes(bsp.visibility, row);
    }
    return bsp;
}

Bytes compress(const std::vector<bool>& row) {
    Bytes bytes((row.size() + 7) / 8, 0);
    for (size_t i = 0; i < row.size(); ++i)
        if (row[i]) bytes[i / 8] = static_cast<uint8_t>(bytes[i / 8] | 1u << i % 8);
    Bytes out;
    for (size_t i = 0; i < bytes.size();) {
        out.push_back(bytes[i]);
        if (bytes[i++] != 0) continue;
        uint8_t run = 1;
        for (; i < bytes.size() && bytes[i] == 0 && run < 255; ++i)
            ++run;
        out.push_back(run);
    }
    return out;
}

TEST(Pvs, SmallLevelIsAsymmetric) {
    const Pvs pvs(parse_bsp("x.bsp", write_level(small_level())));
    EXPECT_FALSE(pvs.sees_everything());
    EXPECT_TRUE(pvs.visible(0, 0));
    EXPECT_FALSE(pvs.visible(0, 1));
    EXPECT_TRUE(pvs.visible(1, 0));
    EXPECT_TRUE(pvs.visible(-1, 1));
    EXPECT_TRUE(pvs.visible(0, -1));
    EXPECT_EQ(pvs.row(0)[0], 1u);
    EXPECT_EQ(pvs.row(-1)[0], 3u);
}

TEST(Pvs, RandomRowsSurviveCompression) {
    std::mt19937 random(1);
    for (const uint32_t clusters : {1u, 7u, 8u, 63u, 64u, 65u, 130u, 2100u}) {
        std::vector<std::vector<bool>> rows(clusters, std::vector<bool>(clusters));
        std::vector<Bytes> compressed;
        for (uint32_t c = 0; c < clusters; ++c) {
            // Sparse, so that runs of zero bytes of every length appear.
            for (uint32_t i = 0; i < 1 + clusters / 50; ++i)
                rows[c][random() % clusters] = true;
            rows[c][c] = true;
            compressed.push_back(compress(rows[c]));
        }
        const Pvs pvs(level_with_rows(clusters, compressed));
        EXPECT_EQ(pvs.damaged_rows(), 0u);
        EXPECT_EQ(pvs.words_per_row(), (clusters + 63) / 64);
        size_t wrong = 0;
        for (uint32_t from = 0; from < clusters; ++from)
            for (uint32_t to = 0; to < clusters; ++to)
                wrong +=
                    pvs.visible(static_cast<int>(from), static_cast<int>(to)) != rows[from][to];
        EXPECT_EQ(wrong, 0u) << clusters;
    }
}

TEST(Pvs, WithoutVisibilityEverythingIsSeen) {
    Bsp bsp;
    bsp.cluster_count = 70;
    const Pvs pvs(bsp);
    EXPECT_TRUE(pvs.sees_everything());
    EXPECT_TRUE(pvs.visible(3, 69));
    int seen = 0;
    for (const uint64_t word : pvs.row(12))
        seen += std::popcount(word);
    EXPECT_EQ(seen, 70);

    const Pvs none{Bsp{}};
    EXPECT_TRUE(none.visible(0, 0));
    EXPECT_TRUE(none.row(-1).empty());
}

TEST(Pvs, DamagedRowsAreRepairedAndCounted) {
    // Row 0 ends early, row 1 runs past its end, row 2 ends inside a run, row 3 is whole.
    const Pvs pvs(level_with_rows(4, {{0, 9}, {0, 2}, {0xff}, {0}}));
    EXPECT_EQ(pvs.damaged_rows(), 3u);
    for (int cluster = 0; cluster < 4; ++cluster)
        EXPECT_TRUE(pvs.visible(cluster, cluster));
    EXPECT_FALSE(pvs.visible(0, 1));
    EXPECT_EQ(pvs.row(2)[0], 0xfu) << "bits past the last cluster are dropped";
}

} // namespace
} // namespace vigil
