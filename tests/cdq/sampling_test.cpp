// SPDX-License-Identifier: GPL-2.0-or-later
// Sampling and its density belong together (paper, section 5.2): the density integrates to 1, draws
// follow it (chi-square), weights are unbiased, and a drawn direction lies in the leaf that the
// density's look-up finds, whatever the random numbers.
#include "light/statistics.h"
#include "shared/random.h"
#include "sphere_cells.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace vigil::test {
namespace {

using namespace shader;

constexpr double pi = 3.14159265358979323846;

class Sampling : public testing::TestWithParam<uint32_t> {
protected:
    Dice dice_{GetParam() + 1};
    const std::vector<Quadtree> trees_ = various_trees(GetParam(), sanitized ? 0 : 3, dice_);
    Random random_ = random_begin(uvec2(GetParam(), 2), 3, 4);
};

/// cdq_pdf integrated over the quarters of every leaf, four to a leaf, in the leaves' order. The
/// errors of `cuts` and twice as many cancel to the fourth power of a triangle's size (Richardson).
std::vector<double> quarter_probabilities(const Quadtree& tree, double* solid_angle = nullptr) {
    const uvec4 field = tree.field();
    const auto density = [&](dvec3 direction) {
        return double(cdq_pdf(field, tree.bits(), vec3(direction)));
    };
    std::vector<double> probabilities;
    for (const Quadtree::Node* node : tree.nodes()) {
        if (node->is_inner()) continue;
        const double half = 0.5 * node->size;
        // Large squares bend more.
        const int cuts = node->depth <= 2 ? 8 : node->depth <= 4 ? 4 : 2;
        for (uint quarter = 0; quarter < 4; ++quarter) {
            const dvec2 corner = node->corner + half * dvec2(quarter & 1u, quarter >> 1);
            const SquareIntegral coarse = integrate_square(corner, half, cuts, density);
            const SquareIntegral fine = integrate_square(corner, half, 2 * cuts, density);
            probabilities.push_back((4.0 * fine.density - coarse.density) / 3.0);
            if (solid_angle) *solid_angle += fine.solid_angle;
        }
    }
    return probabilities;
}

TEST_P(Sampling, DensityIntegratesToOneOverTheSphereAndEvenlyOverLeaves) {
    // Evaluated in floats: a dozen roundings of 2^-24 make 7e-7 at most, most of which cancels in
    // sums; what Richardson leaves of the midpoint rule is of that size too, in the largest leaves.
    const double leaves = cdq_leaf_count(GetParam());
    double worst = 0.0;
    for (const Quadtree& tree : trees_) {
        double solid_angle = 0.0, sum = 0.0;
        const std::vector<double> quarters = quarter_probabilities(tree, &solid_angle);
        for (size_t i = 0; i < quarters.size(); i += 4) {
            const double leaf = quarters[i] + quarters[i + 1] + quarters[i + 2] + quarters[i + 3];
            worst = std::max(worst, std::abs(leaf * leaves - 1.0));
            sum += leaf;
        }
        EXPECT_NEAR(solid_angle / (4.0 * pi), 1.0, 1e-9); // the leaves tile the sphere
        EXPECT_NEAR(sum, 1.0, 1e-6);
    }
    EXPECT_LT(worst, 5e-6);
    RecordProperty("worst_leaf", fmt::format("{}", worst));
}

TEST_P(Sampling, DrawsFollowTheDensity) {
    const uint32_t draws = sanitized ? 20000 : 400000;
    for (size_t t = 0; t < trees_.size(); ++t) {
        const Quadtree& tree = trees_[t];
        const uvec4 field = tree.field();
        std::vector<size_t> order(tree.bits()); // of leaves, by node
        size_t leaves = 0;
        for (const Quadtree::Node* node : tree.nodes())
            if (!node->is_inner()) order[node->number] = leaves++;
        std::vector<uint64_t> counts(4 * leaves);
        for (uint32_t i = 0; i < draws; ++i) {
            const dvec2 uv =
                square_point(dvec3(cdq_sample(field, tree.bits(), random_next3(random_))));
            const Quadtree::Node& leaf = tree.find(min(uv, dvec2(std::nextafter(1.0, 0.0))));
            ++counts[4 * order[leaf.number] + quarter_of(leaf, uv)];
        }
        EXPECT_LT(std::abs(chi_square_z(counts, quarter_probabilities(tree))), z_limit)
            << "tree " << t;
    }
}

TEST_P(Sampling, WeightsAreUnbiased) {
    // What a path tracer does with it: the mean of f / pdf is the integral of f. 1 over the sphere,
    // and cosines above surfaces, whose integral is pi.
    const std::array<vec3, 4> normals{vec3(0, 0, 1), vec3(0, 0, -1), vec3(1, 0, 0),
                                      normalize(vec3(-1, 2, -0.5f))};
    for (size_t t = 0; t < trees_.size(); ++t) {
        const uvec4 field = trees_[t].field();
        Sample one;
        std::array<Sample, 4> cosines;
        for (int i = 0; i < (sanitized ? 10000 : 200000); ++i) {
            const vec3 direction = cdq_sample(field, GetParam(), random_next3(random_));
            const double weight = 1.0 / double(cdq_pdf(field, GetParam(), direction));
            one.add(weight);
            for (size_t k = 0; k < normals.size(); ++k)
                cosines[k].add(weight * std::max(double(dot(normals[k], direction)), 0.0));
        }
        EXPECT_LT(std::abs(one.z(4.0 * pi)), z_limit) << "tree " << t;
        for (const Sample& cosine : cosines)
            EXPECT_LT(std::abs(cosine.z(pi)), z_limit) << "tree " << t;
    }
}

/// The direction drawn with `u` is a unit vector in the leaf that u.x takes, as the density sees
/// it.
void expect_in_leaf(const Quadtree& tree, uvec4 field, uint leaf, vec3 u) {
    const vec3 direction = cdq_sample(field, tree.bits(), u);
    const uint node = cdq_leaf(field, tree.bits(), leaf);
    const CdqPlace place = cdq_find(field, octahedral_encode(direction));
    ASSERT_EQ(place.node, node) << fmt::format("u = {:.9g} {:.9g} {:.9g}, leaf {}", u.x, u.y, u.z,
                                               leaf);
    ASSERT_NEAR(length(direction), 1.0f, 1e-6f);
    ASSERT_EQ(cdq_pdf(field, tree.bits(), direction),
              cdq_leaf_pdf(tree.bits(), tree.nodes()[node]->depth, direction));
}

TEST_P(Sampling, ExtremeDrawsLieInTheirLeaf) {
    const float tiny = 1.0f / 16777216.0f;
    const std::array<float, 8> ends{0.0f, tiny,        0.25f,        0.5f - tiny,
                                    0.5f, 0.5f + tiny, 1.0f - 1e-4f, 1.0f - tiny};
    const uint leaves = cdq_leaf_count(GetParam());
    for (const Quadtree& tree : trees_) {
        const uvec4 field = tree.field();
        for (uint leaf = 0; leaf < leaves; ++leaf)
            for (const float y : ends)
                for (const float z : ends) {
                    const float x = (static_cast<float>(leaf) + 0.5f) / static_cast<float>(leaves);
                    ASSERT_NO_FATAL_FAILURE(expect_in_leaf(tree, field, leaf, vec3(x, y, z)));
                }
        expect_in_leaf(tree, field, 0, vec3(0.0f));
        expect_in_leaf(tree, field, leaves - 1, vec3(1.0f - tiny));
    }
}

TEST_P(Sampling, MillionsOfDrawsLieInTheirLeaf) {
    // 15 trees of each size, 3 million draws (sanitized: 9 trees, 90,000 draws), most of them in
    // small leaves.
    const uint leaves = cdq_leaf_count(GetParam());
    for (const Quadtree& tree : trees_) {
        const uvec4 field = tree.field();
        for (int i = 0; i < (sanitized ? 10000 : 200000); ++i) {
            const vec3 u = random_next3(random_);
            // As rounded there: just below a border it may be the next leaf.
            const uint leaf = std::min(static_cast<uint>(u.x * float(leaves)), leaves - 1);
            ASSERT_NO_FATAL_FAILURE(expect_in_leaf(tree, field, leaf, u));
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Sizes, Sampling, testing::ValuesIn(cdq_sizes));

} // namespace
} // namespace vigil::test
