// SPDX-License-Identifier: GPL-2.0-or-later
// The random streams: range, distribution, and independence within a stream and between
// neighbouring ones.
#include "shared/random.h"
#include "statistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

namespace vigil::shader {
namespace {

using test::chi_square_z;
using test::Sample;
using test::z_limit;

constexpr int draws = 1 << 20;

/// Chi-square score of pairs (x, y) in a 64 x 64 grid.
double pair_z(const std::function<vec2(uint)>& pair) {
    std::vector<uint64_t> counts(64 * 64);
    for (uint i = 0; i < draws; ++i) {
        const vec2 p = pair(i);
        ++counts[static_cast<size_t>(p.x * 64.0f) * 64 + static_cast<size_t>(p.y * 64.0f)];
    }
    return chi_square_z(counts);
}

float first(uvec2 pixel, uint frame, uint seed) {
    Random random = random_begin(pixel, frame, seed);
    return random_next(random);
}

uvec2 pixel_of(uint i) {
    return {i % 1024, i / 1024};
}

TEST(Random, UnitFloatsCoverZeroToJustBelowOne) {
    EXPECT_EQ(unit_float(0u), 0.0f);
    EXPECT_EQ(unit_float(0xffffffffu), 1.0f - 1.0f / 16777216.0f);
    EXPECT_EQ(unit_float(0x80000000u), 0.5f);
    EXPECT_EQ(unit_float(0x100u), 1.0f / 16777216.0f);
}

TEST(Random, CopiesContinueAlike) {
    Random a = random_begin(uvec2(3, 4), 5, 6);
    random_next(a);
    Random b = a;
    for (int i = 0; i < 10; ++i)
        EXPECT_EQ(random_next3(a), random_next3(b));
}

TEST(Random, MomentsAreUniform) {
    Random random = random_begin(uvec2(17, 4), 9, 1);
    Sample mean, square, cube;
    for (int i = 0; i < draws; ++i) {
        const double u = random_next(random);
        ASSERT_GE(u, 0.0);
        ASSERT_LT(u, 1.0);
        mean.add(u);
        square.add(u * u);
        cube.add(u * u * u);
    }
    EXPECT_LT(std::abs(mean.z(1.0 / 2.0)), z_limit);
    EXPECT_LT(std::abs(square.z(1.0 / 3.0)), z_limit);
    EXPECT_LT(std::abs(cube.z(1.0 / 4.0)), z_limit);
}

TEST(Random, EveryComponentIsEven) {
    std::vector<uint64_t> counts[3], bits[2];
    for (auto& c : counts)
        c.resize(1024);
    for (auto& c : bits)
        c.resize(1024);
    Random random = random_begin(uvec2(0, 0), 0, 0);
    for (int i = 0; i < draws; ++i) {
        const vec3 u = random_next3(random);
        for (int k = 0; k < 3; ++k)
            ++counts[k][static_cast<size_t>(u[k] * 1024.0f)];
        // The low bits are used by no float; the alias table needs them.
        const uvec2 words = random_next_bits(random);
        for (int k = 0; k < 2; ++k)
            ++bits[k][words[k] & 1023u];
    }
    for (const auto& c : counts)
        EXPECT_LT(std::abs(chi_square_z(c)), z_limit);
    for (const auto& c : bits)
        EXPECT_LT(std::abs(chi_square_z(c)), z_limit);
}

TEST(Random, SerialPairsAreEven) {
    Random random = random_begin(uvec2(5, 5), 2, 3);
    float previous = random_next(random);
    EXPECT_LT(std::abs(pair_z([&](uint) {
                  const vec2 pair(previous, random_next(random));
                  previous = pair.y;
                  return pair;
              })),
              z_limit);
}

TEST(Random, ComponentsOfOneDrawAreIndependent) {
    Random random = random_begin(uvec2(1, 2), 3, 4);
    EXPECT_LT(std::abs(pair_z([&](uint) { return random_next2(random); })), z_limit);
    EXPECT_LT(std::abs(pair_z([&](uint) {
                  const vec3 u = random_next3(random);
                  return vec2(u.y, u.z);
              })),
              z_limit);
}

TEST(Random, NeighbouringStreamsAreIndependent) {
    const auto frame0 = [](uint i) { return first(pixel_of(i), 0, 0); };
    EXPECT_LT(std::abs(pair_z(
                  [&](uint i) { return vec2(frame0(i), first(pixel_of(i) + uvec2(1, 0), 0, 0)); })),
              z_limit)
        << "pixel to the right";
    EXPECT_LT(std::abs(pair_z(
                  [&](uint i) { return vec2(frame0(i), first(pixel_of(i) + uvec2(0, 1), 0, 0)); })),
              z_limit)
        << "pixel below";
    EXPECT_LT(std::abs(pair_z([&](uint i) { return vec2(frame0(i), first(pixel_of(i), 1, 0)); })),
              z_limit)
        << "next frame";
    EXPECT_LT(std::abs(pair_z([&](uint i) { return vec2(frame0(i), first(pixel_of(i), 0, 1)); })),
              z_limit)
        << "next seed";
    // One pixel over a million frames, as accumulation draws it; and its correlation with the frame
    // after.
    EXPECT_LT(std::abs(pair_z([&](uint i) {
                  return vec2(first(uvec2(7, 9), i, 0), first(uvec2(7, 9), i + 1, 0));
              })),
              z_limit)
        << "successive frames of a pixel";
}

TEST(Random, StreamsAreUncorrelated) {
    Sample products[4];
    for (uint i = 0; i < draws; ++i) {
        const float here = first(pixel_of(i), 0, 0) - 0.5f;
        products[0].add(here * (first(pixel_of(i) + uvec2(1, 0), 0, 0) - 0.5f));
        products[1].add(here * (first(pixel_of(i) + uvec2(0, 1), 0, 0) - 0.5f));
        products[2].add(here * (first(pixel_of(i), 1, 0) - 0.5f));
        products[3].add(here * (first(pixel_of(i), 0, 1) - 0.5f));
    }
    for (const Sample& product : products)
        EXPECT_LT(std::abs(product.z(0.0)), z_limit);
}

TEST(Random, NoTwoPixelsShareAStream) {
    std::vector<uint64_t> keys;
    for (uint frame = 0; frame < 2; ++frame) {
        for (uint i = 0; i < draws / 2; ++i) {
            const Random random = random_begin(pixel_of(i), frame, 0);
            keys.push_back(uint64_t{random.key.x} << 32 | random.key.y);
        }
    }
    std::sort(keys.begin(), keys.end());
    EXPECT_EQ(std::adjacent_find(keys.begin(), keys.end()), keys.end());
}

} // namespace
} // namespace vigil::shader
