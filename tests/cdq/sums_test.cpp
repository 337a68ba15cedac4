// SPDX-License-Identifier: GPL-2.0-or-later
// What a leaf remembers of its quadtree's rays: how sums are stored, how much of them stays, and
// how dense the BRDF's rays count.
#include "shared/guiding_types.h"

#include <gtest/gtest.h>

#include <cmath>

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

} // namespace
} // namespace vigil::shader
