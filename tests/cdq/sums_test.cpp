// SPDX-License-Identifier: GPL-2.0-or-later
// What a node remembers of its rays: how sums are stored, how much of them stays, how dense the
// BRDF's rays count, and the mean that tails bring.
#include "shared/guiding_types.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace vigil::shader {
namespace {

TEST(QuadtreeSums, AreStoredToHalfAPercent) {
    for (float exponent = -36.0f; exponent < 37.0f; exponent += 0.37f) {
        const float low = std::pow(10.0f, exponent), high = std::pow(10.0f, -exponent);
        const uint word = pack_sums(low, high);
        EXPECT_NEAR(unpack_sum(word, 0), low, 0.004f * low);
        EXPECT_NEAR(unpack_sum(word, 1), high, 0.004f * high);
    }
    EXPECT_EQ(unpack_sum(pack_sums(0.0f, 3.0f), 0), 0.0f);
    EXPECT_EQ(unpack_sum(pack_sums(0.0f, 3.0f), 1), 3.0f);
}

// Rounding must not hold up what fades: a sum that nothing is added to halves in time.
TEST(QuadtreeSums, FadeAsTheyShould) {
    GuidingSettings settings{};
    settings.memory_rays = 1024;
    uint word = pack_sums(1.0f, 1e-3f);
    for (int frame = 0; frame < 100; ++frame) {
        const float kept = guide_kept(settings, 40);
        word = pack_sums(kept * unpack_sum(word, 0), kept * unpack_sum(word, 1));
    }
    const double expected = std::pow(1.0 - 40.0 / 1024.0, 100);
    EXPECT_NEAR(unpack_sum(word, 0), expected, 0.1 * expected);
    EXPECT_NEAR(unpack_sum(word, 1), 1e-3 * expected, 1e-4 * expected);
}

TEST(QuadtreeSums, KeepLessTheMoreRaysThereAre) {
    GuidingSettings settings{};
    EXPECT_EQ(guide_kept(settings, 10), 0.0f) << "no memory";
    settings.memory_rays = 1000;
    EXPECT_FLOAT_EQ(guide_kept(settings, 250), 0.75f);
    EXPECT_EQ(guide_kept(settings, 1000), 0.0f);
    EXPECT_EQ(guide_kept(settings, 1000000), 0.0f);
    EXPECT_FLOAT_EQ(guide_kept(settings, 0), 0.98f) << "nothing is for ever";
}

TEST(QuadtreeSums, TheBrdfsRaysAreTwiceAsDenseAsAnEvenSphere) {
    // A tree of one level has 4 leaves of pi steradian; half of all rays are the BRDF's, 1 / (2
    // pi).
    for (const uint bits : {32u, 128u}) {
        const double leaf_density =
            1.0 / (cdq_leaf_count(bits) * 4.0 * 3.14159265); // times 4^depth
        const double even = 0.5 / (2.0 * 3.14159265) / (0.5 * leaf_density);
        EXPECT_NEAR(cdq_even_density(bits, 0.5f), even, 1e-5 * even);
        EXPECT_EQ(cdq_even_density(bits, 0.0f), 0.0f);
        EXPECT_TRUE(std::isfinite(cdq_even_density(bits, 1.0f)));
    }
}

// Two halves of the sphere, each of which one of the two draws evenly, and what they bring there.
TEST(GuideShare, IsTheBestOfTwoThatShareNoDirection) {
    for (const auto& [plain, guided] : {std::pair{1.0f, 1.0f}, {1.0f, 4.0f}, {9.0f, 1.0f}}) {
        ShareMemory memory = share_unpack(uvec2(0u));
        EXPECT_EQ(share_of(memory, 0.3f), 0.3f);
        for (int frame = 0; frame < 400; ++frame) {
            // Estimates are what is there over the part of the rays that go there.
            const float a = share_of(memory, 0.5f), rays = 256.0f;
            const float x_plain = plain / ((1 - a) * (1 - a)), x_guided = guided / (a * a);
            memory = share_update(memory, 0.5f, rays, rays * (1 - a) * x_plain, rays * a * x_guided,
                                  0.5f);
            memory = share_unpack(share_pack(memory));
        }
        const float best = std::sqrt(guided) / (std::sqrt(guided) + std::sqrt(plain));
        const float trust = memory.rays / (memory.rays + SHARE_DOUBT);
        EXPECT_NEAR(memory.share, 0.5f + trust * (best - 0.5f), 0.5f / SHARE_STEPS + 0.01f)
            << plain << " " << guided;
    }
}

TEST(GuideShare, StaysBetweenItsBoundsAndFinite) {
    for (const float first : {0.0f, 1.0f})
        for (const float plain : {0.0f, 1e-30f, 1e37f, 3e38f})
            for (const float guided : {0.0f, 1e-30f, 1e37f, 3e38f}) {
                ShareMemory memory = share_unpack(uvec2(0u));
                for (int frame = 0; frame < 20; ++frame)
                    memory = share_unpack(
                        share_pack(share_update(memory, 0.98f, 1.0f, plain, guided, first)));
                EXPECT_GE(memory.share, 0.99f * SHARE_LEAST);
                EXPECT_LE(memory.share, 1.01f * SHARE_MOST);
                EXPECT_TRUE(std::isfinite(memory.plain) && std::isfinite(memory.guided));
            }
}

TEST(GuideShare, PartsOfALeafKeepItAndForgetItsSums) {
    ShareMemory memory;
    memory.plain = 1e6f;
    memory.guided = 1.0f;
    memory.rays = 1000.0f;
    memory.share = 0.5f;
    const ShareMemory part = share_of_part(memory);
    EXPECT_EQ(share_of(part, 0.9f), 0.5f);
    // Two frames in a dark place, where guided rays bring all.
    ShareMemory later = share_update(part, 0.5f, 256.0f, 0.0f, 1e-6f, 0.5f);
    later = share_update(later, 0.5f, 256.0f, 0.0f, 1e-6f, 0.5f);
    EXPECT_GT(later.share, 0.7f);
    EXPECT_EQ(share_of(share_of_part(share_unpack(uvec2(0u))), 0.3f), 0.3f) << "nothing is known";
}

TEST(Tail, IsTheMeanOfWhatRaysBring) {
    TailMemory memory = tail_unpack(uvec2(0u));
    EXPECT_EQ(memory.mean, 0.0f);
    memory = tail_update(memory, 100.0f, 4.0f);
    EXPECT_EQ(memory.mean, 4.0f) << "nothing was known";
    // A hundred rays beside a hundred of which a tenth is forgotten.
    memory = tail_unpack(tail_pack(tail_update(memory, 100.0f, 8.0f)));
    const float kept = TAIL_KEPT;
    EXPECT_NEAR(memory.mean, (kept * 4.0f + 8.0f) / (kept + 1.0f), 1e-5f);
    // More than is remembered: all of it is new.
    EXPECT_NEAR(tail_update(memory, 2.0f * TAIL_RAYS, 1.0f).mean, 1.0f, 1e-6f);
}

TEST(Tail, ForgetsWhereThereAreFewRays) {
    TailMemory memory = tail_update(tail_unpack(uvec2(0u)), 1e6f, 1.0f);
    int frames = 0;
    for (; memory.mean > 0.1f; ++frames)
        memory = tail_update(memory, 8.0f, 0.0f);
    EXPECT_LT(frames, 400) << "it takes as long to forget a million rays as TAIL_KEPT says";
    TailMemory part = tail_of_part(tail_update(tail_unpack(uvec2(0u)), 1e6f, 1.0f));
    EXPECT_EQ(part.mean, 1.0f);
    part = tail_update(part, 96.0f, 0.0f);
    EXPECT_LT(part.mean, 0.25f) << "a part of a leaf may be much darker";
}

TEST(Tail, StaysFinite) {
    for (const float bright : {0.0f, 1e-38f, 1e15f, 3e38f}) {
        TailMemory memory = tail_unpack(uvec2(0u));
        for (int frame = 0; frame < 1000; ++frame) {
            memory = tail_update(memory, 1.0f, bright);
            ASSERT_TRUE(memory.mean >= 0.0f && memory.mean <= EXPLORE_LARGEST_SUM) << bright;
        }
    }
}

} // namespace
} // namespace vigil::shader
