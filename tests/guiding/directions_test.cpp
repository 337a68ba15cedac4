// SPDX-License-Identifier: GPL-2.0-or-later
// The pass `guide_adapt` of `cdq` against a plain implementation: from random quadtrees and random
// rays in the leaves of an octree it makes the quadtrees that the oracle makes. Each test also
// demands that the case it is named after occurred.
#include "guiding_fixture.h"
#include "numerics/record.h"
#include "random_rays.h"

#include <cmath>

namespace vigil::test {
namespace {

class Directions : public GuidingTest {
protected:
    /// Random quadtrees and rays on a random octree, then a frame; counts what occurred.
    void random_rays_frame(Dice& dice, uint32_t nodes, const RandomRays& rays, uint32_t bits) {
        state_ =
            random_samples(dice, random_tree(dice, nodes, 0.3), {}, settings_, guiding().header());
        add_random_rays(dice, rays, bits, guiding().header().ray_capacity, state_);
        rays_frame();
    }

    void rays_frame() {
        const TreeState before = state_;
        frame();
        if (HasFatalFailure()) return;
        for (const auto& [path, node] : before.nodes) {
            dropped_ += node.rays > node.room ? 1u : 0u;
            const AdaptedQuadtrees& adapted = quadtrees_.at(path);
            const size_t rays = before.lessons_of(node).rays();
            if (rays == 0) {
                ++unlit_;
                continue;
            }
            single_ += rays == 1 ? 1u : 0u;
            many_ += rays > 1000 ? 1u : 0u;
            exact_ += adapted.exact ? 1u : 0u;
            tied_ += adapted.exact && adapted.tied ? 1u : 0u;
            ambiguous_ += adapted.allowed.size() > 1 ? 1u : 0u;
            const AdaptedQuadtree& first = adapted.allowed.begin()->first;
            moved_ += first.migrations > 0 ? 1u : 0u;
            stayed_ += first.migrations < settings_.migrations ? 1u : 0u;
            deepest_ = std::max(deepest_, nodes_of(first.inner).back().size());
        }
    }

    /// As many samples in each leaf as are between the thresholds: the octree stays as it is.
    void rest() {
        for (auto& [path, leaf] : state_.leaves)
            leaf.count = 30;
    }

    static shader::GuidingSettings settings_for(uint32_t migrations, float margin) {
        shader::GuidingSettings settings = settings_with(16);
        settings.migrations = migrations;
        settings.margin = margin;
        return settings;
    }

    // Nodes that ...
    uint32_t dropped_ = 0;   // had more rays than they stored
    uint32_t unlit_ = 0;     // were not looked at
    uint32_t single_ = 0;    // had one ray,
    uint32_t many_ = 0;      // thousands
    uint32_t exact_ = 0;     // had sums that floats hold
    uint32_t tied_ = 0;      // of them: equal ones decided
    uint32_t ambiguous_ = 0; // had several trees that rounding may lead to
    uint32_t moved_ = 0;     // had migrations,
    uint32_t stayed_ = 0;    // and came to an end before the limit
    size_t deepest_ = 0;     // level of a quadtree's leaf
};

class DirectionsOfSize : public Directions, public testing::WithParamInterface<uint32_t> {};

TEST_P(DirectionsOfSize, RandomRays) {
    const uint32_t bits = GetParam();
    for (const uint32_t migrations : {1u, 4u})
        for (const float margin : {0.0f, 0.1f, 0.5f, 1.0f})
            for (const Brought brought : {Brought::Anything, Brought::Powers}) {
                SCOPED_TRACE(testing::Message() << migrations << " migrations, margin " << margin
                                                << (brought == Brought::Powers ? ", powers" : ""));
                start(settings_for(migrations, margin), 96, bits);
                Dice dice(bits + migrations + static_cast<uint32_t>(100 * margin));
                random_rays_frame(dice, 80, {brought, 160, 2 * bits}, bits);
                if (HasFatalFailure()) return;
            }
    for (const uint32_t leaves : {unlit_, single_, dropped_, exact_, tied_, moved_, stayed_})
        EXPECT_GT(leaves, 100u);
    EXPECT_LT(ambiguous_, (unlit_ + moved_) / 50);
    EXPECT_GE(deepest_, bits > 32 ? 12u : 8u);
}

TEST_P(DirectionsOfSize, BesideRaysOfTheBrdf) {
    const uint32_t bits = GetParam();
    shader::GuidingSettings settings = settings_for(4, 0.25f);
    settings.first_share = 0.5f;
    EXPECT_EQ(shader::cdq_even_density(bits, 0.5f), 1.5f * static_cast<float>(bits) + 2.0f);
    start(settings, 96, bits);
    Dice dice(bits + 5);
    random_rays_frame(dice, 80, {Brought::Anything, 160, 2 * bits}, bits);
    EXPECT_GT(moved_, 20u);
}

TEST_P(DirectionsOfSize, ThousandsOfRays) {
    const uint32_t bits = GetParam();
    for (const Brought brought : {Brought::Anything, Brought::Powers}) {
        shader::GuidingSettings settings = settings_for(4, 0.25f);
        settings.split = 4000;
        settings.collapse = 2000;
        start(settings, 256, bits);
        Dice dice(bits + 7);
        random_rays_frame(dice, 30, {brought, 8000, bits}, bits);
        if (HasFatalFailure()) return;
    }
    EXPECT_GE(many_, 8u);
    EXPECT_GE(exact_, 4u);
}

TEST_P(DirectionsOfSize, AsManyMigrationsAsThereCanBe) {
    const uint32_t bits = GetParam();
    start(settings_for(16, 1.0f), 96, bits);
    Dice dice(bits + 8);
    random_rays_frame(dice, 60, {Brought::Powers, 160, 4 * bits}, bits);
    if (HasFatalFailure()) return;
    EXPECT_GT(statistics_.cdq_migrations, 200u);
}

TEST_P(DirectionsOfSize, WithMemory) {
    const uint32_t bits = GetParam();
    // Enough rays in most nodes, in some, in none.
    for (const uint32_t memory : {20u, 150u, 2000u})
        for (const uint32_t migrations : {1u, 4u}) {
            SCOPED_TRACE(testing::Message() << memory << " rays, " << migrations << " migrations");
            shader::GuidingSettings settings = settings_for(migrations, 0.25f);
            settings.first_share = 0.5f;
            settings.memory_rays = memory;
            start(settings, 96, bits);
            Dice dice(bits + memory + migrations);
            random_rays_frame(dice, 80, {Brought::Anything, 160, 2 * bits, true}, bits);
            if (HasFatalFailure()) return;
        }
    EXPECT_GT(moved_, 100u);
    EXPECT_LT(ambiguous_, moved_ / 20);
}

TEST_P(DirectionsOfSize, RememberFromFrameToFrame) {
    const uint32_t bits = GetParam();
    shader::GuidingSettings settings = settings_for(1, 0.25f);
    settings.memory_rays = 500;
    start(settings, 96, bits);
    Dice dice(bits + 9);
    for (int i = 0; i < 40; ++i) {
        rest();
        for (auto& [path, node] : state_.nodes) {
            node.rays = std::min(node.room, 160u);
            for (uint32_t ray = 0; ray < node.rays; ++ray)
                state_.ray(node, ray)[0] = shader::ray_sample_pack(random_cell(dice, {0.3f, 0.6f}),
                                                                   dice.between(0.5f, 2.0f));
        }
        rays_frame();
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(moved_, 8u);
}

TEST_P(DirectionsOfSize, AllEnergyInOneRayAndNoneAtAll) {
    // One ray brings more than can be stored, beside rays that bring next to nothing; then all
    // bring nearly that, a power of two, so that equal sums are equal in whatever order they were
    // added up; then none brings anything. With and without memory.
    const uint32_t bits = GetParam();
    for (const uint32_t memory : {0u, 500u}) {
        SCOPED_TRACE(testing::Message() << memory << " rays remembered");
        shader::GuidingSettings settings = settings_for(4, 0.25f);
        settings.memory_rays = memory;
        start(settings, 96, bits);
        deepest_ = 0;
        for (int i = 0; i < 18; ++i) {
            rest();
            for (auto& [path, node] : state_.nodes) {
                node.rays = i < 12 ? std::min(node.room, 20u) : 0u;
                for (uint32_t ray = 0; ray < node.rays; ++ray) {
                    const glm::uvec2 cell =
                        ray == 0 ? glm::uvec2(1000, 3000) : glm::uvec2(200 * ray, 4095 - 100 * ray);
                    const float most = i >= 8 ? std::exp2(31.0f) : 3e38f;
                    const float brought = ray == 0 || i >= 8 ? most : 0.0f;
                    state_.ray(node, ray)[0] = shader::ray_sample_pack(cell, brought);
                }
            }
            rays_frame();
            if (HasFatalFailure()) return;
        }
        if (memory == 0) { // a memory is shared out evenly when its leaf is split, and fades first
            EXPECT_EQ(deepest_, std::min(12u, bits / 4));
        }
    }
    record(
        "directional quadtree",
        fmt::format("{} bits: all energy in one ray, all rays at the format's top, no rays", bits),
        "the quadtrees of the plain implementation; a chain to the one ray");
}

TEST_P(DirectionsOfSize, SharesFollowWhatRaysEstimated) {
    const uint32_t bits = GetParam();
    double least = 1.0, most = 0.0;
    for (const float first : {0.0f, 0.5f, 1.0f}) {
        SCOPED_TRACE(testing::Message() << "first share " << first);
        shader::GuidingSettings settings = settings_for(4, 0.25f);
        settings.first_share = first;
        settings.adapt_share = 1;
        settings.memory_rays = 500;
        start(settings, 96, bits);
        Dice dice(bits + 10);
        for (int i = 0; i < 6; ++i) {
            for (auto& [path, leaf] : state_.leaves)
                leaf.count = 60; // it is split in the next frame
            if (i < 2) {
                rays_frame();
            } else {
                // Of new places: what the nodes know is kept.
                const ByPath<NodeState> nodes = state_.nodes;
                add_random_rays(dice, {Brought::Anything, 160, 2 * bits, true}, bits,
                                guiding().header().ray_capacity, state_);
                for (const auto& [path, node] : nodes)
                    state_.nodes.at(path).shared = node.shared;
                rays_frame();
            }
            if (HasFatalFailure()) return;
            for (const auto& [path, shared] : shares_) {
                least = std::min(least, shared.share);
                most = std::max(most, shared.share);
            }
        }
    }
    EXPECT_LT(least, 0.2);
    EXPECT_GT(most, 0.7);
}

INSTANTIATE_TEST_SUITE_P(Sizes, DirectionsOfSize, testing::Values(32u, 64u, 96u, 128u));

TEST_F(Directions, TheLowestNumberDecidesBetweenEqualOnes) {
    start(settings_for(1, 0.5f), 96, 64);
    Dice dice(31);
    for (int round = 0; round < 20; ++round) {
        random_rays_frame(dice, 80, {Brought::Same, 80, 16}, 64);
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(tied_, 100u);
    EXPECT_EQ(ambiguous_, 0u);
}

TEST_F(Directions, WhatNobodyKeptIsNotRemembered) {
    shader::GuidingSettings settings = settings_for(4, 0.25f);
    settings.memory_rays = 0;
    start(settings, 96, 128);
    Dice dice(7);
    random_rays_frame(dice, 80, {Brought::Anything, 160, 256}, 128);
    if (HasFatalFailure()) return;
    ASSERT_GT(state_.inner.size(), 1u);
    settings.memory_rays = 512;
    start_anew(settings);
}

TEST_F(Directions, OneHugeNodeAmongEmptyOnes) {
    // More than any node has once the octree has followed the surfaces: its first frames. Every ray
    // takes as long as it can to find its leaf.
    const glm::vec2 target(0.37f, 0.91f);
    for (const uint32_t rays : {4095u, 4096u, 4097u, 8191u, 8192u, 20000u, 100000u}) {
        SCOPED_TRACE(testing::Message() << rays << " rays");
        start(settings_for(16, 0.1f), 512, 128);
        Dice dice(rays);
        state_ = random_samples(dice, random_tree(dice, 3, 0.5), {}, settings_, guiding().header());
        for (auto& [path, leaf] : state_.leaves)
            leaf.count = leaf.room = 0;
        add_random_rays(dice, {Brought::Anything, 0, 0}, 128, guiding().header().ray_capacity,
                        state_);
        for (auto& [path, node] : state_.nodes)
            node.rays = node.blank = 0;
        NodeState& huge = std::next(state_.nodes.begin(), dice.below(3))->second;
        huge.quadtree = quadtree_towards(128, target);
        huge.first_ray = 123;
        huge.room = rays;
        huge.rays = rays + dice.below(100);
        const glm::uvec2 deepest(target * 4096.0f);
        for (uint32_t i = 0; i < rays; ++i)
            state_.ray(huge, i)[0] = shader::ray_sample_pack(
                dice.chance(0.2) ? random_cell(dice, target)
                                 : deepest + glm::uvec2(dice.below(4), dice.below(4)),
                dice.chance(0.9) ? 1.0f : 2.0f);
        rays_frame();
        if (HasFatalFailure()) return;
    }
    EXPECT_EQ(many_, 7u);
    record("octree", "100,000 rays in one node, none elsewhere",
           "the quadtrees of the plain implementation");
}

TEST_F(Directions, QuadtreesFollowTheRays) {
    // All rays bring the same, so the squares end where most rays go: to the target of each leaf.
    for (const uint32_t bits : {32u, 128u}) {
        start(settings_for(1, 0.1f), 96, bits);
        Dice dice(bits);
        for (int i = 0; i < 30; ++i) {
            rest();
            for (auto& [path, node] : state_.nodes) {
                node.rays = std::min(node.room, 320u);
                for (uint32_t ray = 0; ray < node.rays; ++ray)
                    state_.ray(node, ray)[0] =
                        shader::ray_sample_pack({1000 + dice.below(3), 3000 + dice.below(3)}, 1.0f);
            }
            rays_frame();
            if (HasFatalFailure()) return;
        }
        // Three chains at most hold all rays, and the rest of the tree is given up.
        EXPECT_EQ(deepest_, std::min(12u, bits / 4)) << bits;
        EXPECT_EQ(statistics_.cdq_migrations, 0u);
    }
}

} // namespace
} // namespace vigil::test
