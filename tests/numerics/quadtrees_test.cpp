// SPDX-License-Identifier: GPL-2.0-or-later
// Directional quadtrees at their deepest, and a sun smaller than their smallest leaf; one-sample
// mixtures with shares of exactly 0 and 1.
#include "cdq/quadtree.h"
#include "record.h"
#include "shared/brdf.h"
#include "shared/cdq.h"
#include "shared/firewall.h"
#include "shared/guiding_types.h"
#include "shared/random.h"

namespace vigil::test {
namespace {

using namespace shader;

constexpr float below_one = 1.0f - 1.0f / 16777216.0f;

/// Places where the map has its edges and corners, and one like any other.
const dvec2 targets[] = {{0.5, 0.5},   {0.0, 0.0},     {0.999999, 0.0}, {0.5, 0.0},
                         {0.25, 0.25}, {0.75, 0.7501}, {0.3, 0.61},     {0.0, 0.5}};

TEST(Quadtrees, DeepestChainsOfEverySize) {
    Random random = random_begin(uvec2(0, 0), 0, 1);
    for (const uint bits : cdq_sizes) {
        Worst density, weight;
        uint deepest = 0;
        for (const dvec2& target : targets) {
            const Quadtree tree = tree_towards(bits, target);
            const uvec4 field = tree.field();
            Sample sphere;
            for (int i = 0; i < 100000 / slowdown; ++i) {
                vec3 u = random_next3(random);
                if (i < 8)
                    u = vec3(i & 1 ? below_one : 0, i & 2 ? below_one : 0, i & 4 ? below_one : 0);
                const vec3 direction = cdq_sample(field, bits, u);
                const float pdf = cdq_pdf(field, bits, direction);
                ASSERT_TRUE(is_finite_nonnegative(pdf) && pdf > 0.0f);
                const Quadtree::Node& leaf = tree.find(dvec2(octahedral_encode(direction)));
                deepest = std::max(deepest, leaf.depth);
                // The density from the square's size and the exact Jacobian.
                const dvec3 size = glm::abs(dvec3(direction));
                const double sum = size.x + size.y + size.z;
                const double exact = 0.25 / (sum * sum * sum) /
                                     (leaf.size * leaf.size * double(cdq_leaf_count(bits)));
                density.add(relative_error(double(pdf), exact));
                sphere.add(1.0 / double(pdf));
            }
            weight.add(std::abs(sphere.z(4.0 * 3.14159265358979)));
        }
        EXPECT_EQ(deepest, std::min(CDQ_MAX_DEPTH, cdq_inner_count(bits) + 1u));
        EXPECT_LT(density.value(), 12.0);
        EXPECT_LT(weight.value(), z_limit);
        record("directional quadtree",
               fmt::format("{} bits, deepest chains, level {}", bits, deepest),
               "density within 12 * 2^-24, mean of 1 / pdf the whole sphere (z < 4.5)",
               fmt::format("{} * 2^-24, z {}", density.text(), weight.text()));
    }
}

TEST(Quadtrees, ASunSmallerThanTheSmallestLeaf) {
    // A disc of a tenth of the smallest leaf, in the leaf and where four of them meet: the mean of
    // what it shines, from draws of the quadtree alone, of half a mixture with the cosine, and of
    // the ends.
    Random random = random_begin(uvec2(0, 0), 0, 2);
    const uint bits = 128;
    Worst score;
    uint64_t hits = 0;
    for (const dvec2& target : {dvec2(0.3, 0.4001), dvec2(0.1, 0.12), dvec2(0.5001, 0.4999)}) {
        const Quadtree tree = tree_towards(bits, target);
        const uvec4 field = tree.field();
        const Quadtree::Node& leaf = tree.find(target);
        ASSERT_EQ(leaf.depth, CDQ_MAX_DEPTH);
        // Where the smallest leaves meet, or within one.
        const dvec2 middle = target.x < 0.2 ? leaf.corner + 0.5 * leaf.size
                                            : leaf.parent->corner + 0.5 * leaf.parent->size;
        const vec3 sun = octahedral_decode(vec2(middle));
        const float size = 2e-8f; // 1 - cos: 1.3e-7 steradian
        const double solid_angle = 2.0 * 3.14159265358979 * double(size);
        for (const float brdf_part : {0.0f, 0.5f}) {
            Sample mean;
            for (int i = 0; i < 4000000 / slowdown; ++i) {
                const vec3 u = random_next3(random);
                const vec3 direction = random_next(random) < brdf_part
                                           ? sample_cosine_hemisphere(vec2(u.x, u.y))
                                           : cdq_sample(field, bits, u);
                const bool hit = in_cone(direction, sun, size);
                if (!hit) {
                    mean.add(0.0);
                    continue;
                }
                ++hits;
                const float pdf = guide_mixture_pdf(cdq_pdf(field, bits, direction),
                                                    cosine_hemisphere_pdf(direction.z), brdf_part);
                ASSERT_TRUE(is_finite_nonnegative(pdf) && pdf > 0.0f);
                mean.add(1.0 / double(pdf));
            }
            // A cone so small is some units in the last place wide: its size counts to a percent.
            const double error =
                std::max(std::abs(mean.mean() - solid_angle) - 0.01 * solid_angle, 0.0);
            score.add(error / mean.standard_error());
        }
    }
    if (slowdown == 1) {
        EXPECT_GT(hits, 1000u);
        EXPECT_LT(score.value(), z_limit);
    }
    record("directional quadtree", "a sun of 1.3e-7 steradian, a tenth of the smallest leaf",
           "its solid angle as mean, by the quadtree alone and in a mixture (z < 4.5)",
           "z " + score.text());
}

TEST(Quadtrees, SharesOfZeroAndOne) {
    for (const uint bits : cdq_sizes)
        for (const float brdf_part : {0.0f, 1e-7f, 0.5f, below_one, 1.0f}) {
            const float even = cdq_even_density(bits, brdf_part);
            ASSERT_TRUE(is_finite_nonnegative(even));
        }
    EXPECT_EQ(cdq_even_density(128, 0.0f), 0.0f);
    // A mixture with a share of exactly 0 or 1 is one of its parts, to the last bit.
    Random random = random_begin(uvec2(0, 0), 0, 3);
    Worst error;
    for (const uint bits : cdq_sizes) {
        const uvec4 field = tree_towards(bits, dvec2(0.3, 0.61)).field();
        for (int i = 0; i < 1000; ++i) {
            const vec3 direction = cdq_sample(field, bits, random_next3(random));
            const float pdf = cdq_pdf(field, bits, direction);
            for (const float other : {0.0f, 1.1e-7f, 0.318f, 3.7e30f}) {
                ASSERT_EQ(guide_mixture_pdf(pdf, other, 0.0f), pdf);
                ASSERT_EQ(guide_mixture_pdf(pdf, other, 1.0f), other);
                error.add(relative_error(double(guide_mixture_pdf(pdf, other, 0.25f)),
                                         0.75 * double(pdf) + 0.25 * double(other)));
            }
        }
    }
    EXPECT_LT(error.value(), 4.0);
    record("shares", "mixtures with a share of exactly 0 or 1", "the density of the one part", "");
}

} // namespace
} // namespace vigil::test
