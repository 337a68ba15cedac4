// SPDX-License-Identifier: GPL-2.0-or-later
// Hours of frames: random sequences and running means that go on for long.
#include "record.h"
#include "shared/random.h"
#include "shared/running_mean.h"

#include <algorithm>
#include <vector>

namespace vigil::shader {
namespace {

using test::record;
using test::slowdown;
using test::Worst;

TEST(LongRuns, PathsAreCountedIn64Bits) {
    for (const uint frame : {0u, 1u, 262143u, 262144u, 0x3fffffffu, 0xffffffffu})
        for (const uint per_frame : {1u, 7u, 4096u})
            for (const uint path : {0u, per_frame - 1u}) {
                const uint64_t exact = uint64_t{frame} * per_frame + path;
                const uvec2 number = path_number(frame, per_frame, path);
                ASSERT_EQ(uint64_t{number.y} << 32 | number.x, exact);
            }
    // The last words of 32 bits, and the first beyond.
    EXPECT_EQ(path_number(0xffffffffu, 4096u, 4095u), uvec2(0xffffffffu, 4095u));
}

TEST(LongRuns, StreamsDoNotRepeat) {
    // Every pixel and stream of paths that are equal in their lowest 30 bits, or nearly: what was
    // one stream after 2^30 paths, 73 minutes at 4,096 paths per frame and 60 frames per second.
    std::vector<uint64_t> keys;
    for (uint bit = 30; bit <= 44; ++bit)
        for (const uint64_t low :
             {uint64_t{0}, uint64_t{1}, uint64_t{12345}, (uint64_t{1} << 30) - 1})
            for (const uvec2 pixel : {uvec2(0, 0), uvec2(1, 0), uvec2(0, 1), uvec2(16383, 16383)})
                for (uint stream = 0; stream < RANDOM_STREAMS; ++stream) {
                    const uint64_t path = (bit == 44 ? 0 : uint64_t{1} << bit) + low;
                    const uvec2 number(static_cast<uint>(path), static_cast<uint>(path >> 32));
                    const Random random = random_path(pixel, number, stream, 0);
                    keys.push_back(uint64_t{random.key.x} << 32 | random.key.y);
                }
    std::ranges::sort(keys);
    EXPECT_EQ(std::ranges::adjacent_find(keys), keys.end());
    // The first paths are those of a plain count: pictures of a seed stay the same.
    EXPECT_EQ(random_path({3, 4}, {5, 0}, 2, 6).key, random_begin({3, 4}, 22, 6).key);
    record("counters that wrap", "random streams after 2^30 paths of a pixel",
           "all different up to 2^44 paths: 2^32 frames of 4,096", "");
}

/// Relative error of a running mean of `frames` values from `draw`, against double precision.
template <typename Draw> double error_of_mean(uint frames, const Draw& draw) {
    vec3 mean(0.0f), carry(0.0f);
    double sum = 0.0;
    for (uint i = 0; i < frames; ++i) {
        const float value = draw();
        add_to_mean(mean, carry, i, vec3(value));
        sum += double(value);
    }
    const double exact = sum / double(frames);
    return (double(mean.x) - exact) / exact;
}

TEST(LongRuns, MeansKeepTheirDigitsForHours) {
    // Four hours and a half at 60 frames per second.
    constexpr uint frames = (1u << 20) / slowdown;
    Random random = random_begin(uvec2(0, 0), 0, 1);
    Worst even, rare, constant;
    for (int run = 0; run < 10; ++run) {
        even.add(std::abs(error_of_mean(frames, [&] { return random_next(random); })));
        // A firefly: 1,000 in one of 1,000 frames, else nothing.
        rare.add(std::abs(
            error_of_mean(frames, [&] { return random_next(random) < 1e-3f ? 1000.0f : 0.0f; })));
        const float value = std::pow(10.0f, float(2 * run - 10)) * 1.2345f;
        constant.add(std::abs(error_of_mean(frames, [&] { return value; })));
    }
    EXPECT_LT(even.value(), 1e-6);
    EXPECT_LT(rare.value(), 1e-6);
    EXPECT_LT(constant.value(), 1e-6);
    record("hours of frames", "mean of 2^20 frames of even noise",
           "relative error of rounding below 1e-6", even.text());
    record("hours of frames", "mean of 2^20 frames with fireflies (1,000 in one of 1,000)",
           "relative error of rounding below 1e-6", rare.text());
    record("hours of frames", "mean of 2^20 equal frames", "relative error below 1e-6",
           constant.text());
}

} // namespace
} // namespace vigil::shader
