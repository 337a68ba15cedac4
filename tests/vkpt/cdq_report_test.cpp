// SPDX-License-Identifier: GPL-2.0-or-later
// Reports of directional quadtrees: what they say of the even tree, and of one whose leaves have
// migrated, against draws from it. Without a GPU.
#include "refresh/vkpt/guiding/cdq_report.h"

#include "cdq/quadtree.h"
#include "shared/cdq.h"
#include "shared/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace vigil::vkpt {
namespace {

/// The even tree after leaves moved, `steps` times, to where one direction is.
glm::uvec4 tree_towards(glm::vec3 direction, uint32_t bits, int steps) {
    test::Quadtree tree(bits);
    for (int step = 0; step < steps; ++step) {
        const test::Quadtree::Node& leaf = tree.find(shader::octahedral_encode(direction));
        const auto inner = std::ranges::find_if(tree.nodes(), [&](const auto* node) {
            return node->is_collapsible() && leaf.parent != node;
        });
        if (inner != tree.nodes().end()) tree.migrate((*inner)->number, leaf.number);
    }
    return tree.field();
}

TEST(CdqReport, EvenTree) {
    for (const uint32_t bits : {32u, 64u, 96u, 128u}) {
        const refresh::QuadtreeReport report =
            report_cdq(shader::cdq_even_tree(bits), bits, {0, 0, 1});
        EXPECT_EQ(report.cells.size(), shader::cdq_leaf_count(bits));
        EXPECT_EQ(report.deepest, bits <= 64 ? 3u : 4u);
        // All directions alike would have 0.08.
        EXPECT_GT(report.cells.back().density, 0.01f);
        EXPECT_LT(report.cells.front().density, 1.0f);
    }
}

TEST(CdqReport, DensestCellLooksWhereLeavesWent) {
    const glm::vec3 direction = glm::normalize(glm::vec3(0.3f, -0.8f, -0.4f));
    const glm::uvec4 tree = tree_towards(direction, 128, 6);
    const refresh::QuadtreeReport report = report_cdq(tree, 128, {0, 0, 1});
    EXPECT_GT(report.deepest, 6u);
    EXPECT_EQ(report.cells.front().depth, report.deepest);
    EXPECT_GT(glm::dot(report.cells.front().direction, direction), 0.99f);
    EXPECT_TRUE(std::ranges::is_sorted(report.cells, std::greater{},
                                       &refresh::QuadtreeReport::Cell::density));
    for (const refresh::QuadtreeReport::Cell& cell : report.cells)
        EXPECT_NEAR(cell.density, shader::cdq_pdf(tree, 128, cell.direction), 1e-4f * cell.density);
}

TEST(CdqReport, ShareBelowTheHorizonIsThatOfDraws) {
    constexpr int draws = 200000;
    for (const glm::vec3 axis : {glm::vec3(0, 0, 1), glm::vec3(-1, 0, 0), glm::vec3(1, 2, -3)}) {
        const glm::vec3 normal = glm::normalize(axis);
        const glm::uvec4 tree = tree_towards(glm::normalize(glm::vec3(1, 1, 1)), 128, 5);
        int below = 0;
        for (int i = 0; i < draws; ++i) {
            shader::Random random = shader::random_begin({static_cast<uint32_t>(i), 0}, 0, 0);
            const glm::vec3 u = shader::random_next3(random);
            below += glm::dot(shader::cdq_sample(tree, 128, u), normal) > 0.0f ? 0 : 1;
        }
        const double share = static_cast<double>(below) / draws;
        const double error = std::sqrt(share * (1.0 - share) / draws);
        // A cell's share is known to one part in 16 at its edge.
        EXPECT_NEAR(report_cdq(tree, 128, normal).below_horizon, share, 4.0 * error + 0.005);
    }
}

} // namespace
} // namespace vigil::vkpt
