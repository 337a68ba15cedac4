// SPDX-License-Identifier: GPL-2.0-or-later
// The firewall's question, of every kind of float; and what the caches pack, of random bits.
#include "record.h"
#include "shared/firewall.h"
#include "shared/guiding_types.h"
#include "shared/octree.h"
#include "shared/random.h"
#include "shared/shadow_statistics.h"

#include <array>

namespace vigil::shader {
namespace {

using test::any_float;
using test::record;
using test::slowdown;
using test::Worst;

uint any_word(Random& random) {
    return random_next_bits(random).x;
}

TEST(Firewall, AdmitsWhatIsFiniteAndNotNegative) {
    // Every exponent, sign and edge of the mantissa, and a walk through all bit patterns.
    constexpr uint step = 97 * slowdown;
    uint words = 0;
    for (uint64_t bits = 0; bits <= UINT32_MAX; bits += step, ++words) {
        const float value = any_float(static_cast<uint32_t>(bits));
        ASSERT_EQ(is_finite_nonnegative(value), std::isfinite(value) && !(value < 0.0f)) << bits;
    }
    for (uint exponent = 0; exponent < 256; ++exponent)
        for (const uint sign : {0u, 0x80000000u})
            for (const uint mantissa : {0u, 1u, 0x400000u, 0x7fffffu}) {
                const float value = any_float(sign | exponent << 23 | mantissa);
                ASSERT_EQ(is_finite_nonnegative(value), std::isfinite(value) && !(value < 0.0f));
            }
    record("the firewall", "all exponents and signs, NaN, infinity, -0, denormals",
           "finite and not negative, asked of the bits", "");
}

TEST(Packing, AnyBitsGiveSoundSamples) {
    Random random = random_begin(uvec2(0, 0), 0, 1);
    for (int i = 0; i < 2000000 / slowdown; ++i) {
        const float value = any_float(any_word(random));
        const float ray = ray_sample_contribution(ray_sample_pack(uvec2(4095, 0), value));
        ASSERT_TRUE(ray == 0.0f || (ray > 0x1p-32f && ray <= 3.7e9f)) << value;
        ASSERT_EQ(ray_sample_grid(ray_sample_pack(uvec2(4095, 17), value)), uvec2(4095, 17));
        const float estimate = light_sample_estimate(light_sample_pack_estimate(value));
        ASSERT_TRUE(estimate >= 0x1p-64f && estimate <= 0x1p63f) << value;
        ASSERT_EQ(light_sample_pack_estimate(value) & ~(127u << LIGHT_SAMPLE_ESTIMATE_SHIFT), 0u);
        const uvec3 cell = octree_grid(vec3(value, any_float(any_word(random)), 1.0f),
                                       vec3(-4096.0f), any_float(any_word(random)));
        ASSERT_TRUE(cell.x < 65536u && cell.y < 65536u && cell.z < 65536u);
    }
    record("caches", "ray and light samples of any bits, NaN and infinity included",
           "a value of the format's range", "");
    record("octree", "positions and scales of any bits, NaN and infinity included",
           "a cell of the root's cube", "");
}

TEST(Packing, SamplesAreOffByAsMuchAsStated) {
    Random random = random_begin(uvec2(0, 0), 0, 2);
    Worst ray, estimate;
    for (int i = 0; i < 500000 / slowdown; ++i) {
        const float u = random_next(random);
        const float contribution = std::exp2(63.5f * u - 31.8f);
        ray.add(std::abs(double(ray_sample_contribution(ray_sample_pack(uvec2(0), contribution))) /
                             double(contribution) -
                         1.0));
        const float value = std::exp2(126.0f * u - 63.0f);
        const double ratio =
            double(light_sample_estimate(light_sample_pack_estimate(value))) / double(value);
        estimate.add(std::max(ratio, 1.0 / ratio));
    }
    EXPECT_LT(ray.value(), 0.0906); // 2^(1/8) - 1, and the rounding of log2
    EXPECT_LT(estimate.value(), 1.41422);
    record("precision", "ray sample's contribution, 8 bits", "relative error below 9.1%",
           fmt::format("{:.3f}%", 100.0 * ray.value()));
    record("precision", "light sample's estimate, 7 bits", "a factor of at most sqrt(2)",
           fmt::format("{:.4f}", estimate.value()));
}

TEST(Packing, SumsOfSquaredContributionsCannotOverflow) {
    // The largest contribution there is, squared, of all rays that a quadtree takes in a frame, for
    // ever: a frame keeps at most 0.98 of what was there.
    const double largest = double(ray_sample_contribution(ray_sample_pack(uvec2(0), INFINITY)));
    const double rays = GUIDE_MOST_RAYS;
    GuidingSettings settings{};
    settings.memory_words = CDQ_SUM_WORDS;
    settings.memory_rays = 1000000;
    const double kept = double(guide_kept(settings, 0));
    EXPECT_LE(kept, 0.98 + 1e-6);
    const double sum = rays * largest * largest / (1.0 - kept);
    EXPECT_LT(sum, 1e37); // what cdq clamps sums to
    EXPECT_TRUE(is_finite_nonnegative(unpack_sum(pack_sums(1e37f, 3e38f), 0)));
    EXPECT_TRUE(is_finite_nonnegative(unpack_sum(pack_sums(1e37f, 3e38f), 1)));
    record("directional quadtree",
           "squared contributions of all rays at the format's top, for ever", "sums below 1e37",
           fmt::format("{:.1g}", sum));
}

TEST(Packing, SumsAreOffByAsMuchAsStated) {
    Random random = random_begin(uvec2(0, 0), 0, 3);
    Worst error;
    for (int i = 0; i < 500000 / slowdown; ++i) {
        const float value = std::pow(10.0f, 74.0f * random_next(random) - 37.0f);
        const uint word = pack_sums(value, 0.5f * value);
        error.add(std::abs(double(unpack_sum(word, 0)) / double(value) - 1.0));
        error.add(std::abs(double(unpack_sum(word, 1)) / (0.5 * double(value)) - 1.0));
    }
    EXPECT_LE(error.value(), 0x1p-8);
    record("precision", "sums of quadtrees and of exploring, 16 bits (bfloat16)",
           "relative error of at most 2^-8", fmt::format("{:.4f}", error.value()));
}

TEST(ExploreMemory, StaysSoundForAnySums) {
    Random random = random_begin(uvec2(0, 0), 0, 4);
    const auto amount = [&](float most) { // from nothing to `most`, over all powers of ten
        const float u = random_next(random);
        return u < 0.1f ? 0.0f : u > 0.9f ? most : std::pow(10.0f, 44.0f * u) * 1e-6f;
    };
    for (int i = 0; i < 20000 / slowdown; ++i) {
        ExploreMemory memory = explore_unpack(uvec2(0));
        for (int frame = 0; frame < 20; ++frame) {
            // 4,096 estimates of 2^63 at most, and their squares, whose sum is beyond all floats.
            memory =
                explore_update(memory, random_next(random) < 0.3f ? 0.0f : 4096.0f,
                               amount(INFINITY), float(any_word(random) % 4096u), amount(INFINITY));
            memory = explore_unpack(explore_pack(memory));
            ASSERT_TRUE(is_finite_nonnegative(memory.listed) &&
                        is_finite_nonnegative(memory.found) &&
                        is_finite_nonnegative(memory.cached));
            ASSERT_TRUE(is_finite_nonnegative(memory.share) && memory.share <= EXPLORE_MOST * 1.01f)
                << memory.share;
        }
    }
    record("caches", "draws estimate 0 to 2^63, squares that overflow",
           "every number finite, the share of walks at most 0.9", "");
}

TEST(ShadowStatistics, CountsOfAnySizeGiveALoss) {
    Random random = random_begin(uvec2(0, 0), 0, 5);
    std::array<uint, 6> edges{0u, 1u, SHADOW_RAY, 0x7fffffffu, 0xfffffffeu, 0xffffffffu};
    for (int i = 0; i < 100000 / slowdown; ++i) {
        const uint a = i % 2 == 0 ? any_word(random) : edges[any_word(random) % edges.size()];
        const uint b = i % 3 == 0 ? any_word(random) : edges[any_word(random) % edges.size()];
        const float loss = shadow_loss(a, b);
        ASSERT_TRUE(loss >= 0.0f && loss <= SHADOW_MOST_LOSS) << a << " " << b;
        ASSERT_LE(fade_shadow_count(a), a);
    }
    record("counters that wrap", "shadow statistics: more than 2^26 rays of one slot in a frame",
           "a loss within [0, 0.9] whatever the count: weights stay above 0, so no bias", "");
}

} // namespace
} // namespace vigil::shader
