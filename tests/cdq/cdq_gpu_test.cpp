// SPDX-License-Identifier: GPL-2.0-or-later
// The bit field's text on the device, under validation: what is integer or exact equals the host's
// to the bit, drawn directions do within rounding, and the device's own look-up finds every drawn
// direction in the leaf it was drawn from.
#include "gpu/validated.h"
#include "quadtree.h"
#include "query.h"
#include "refresh/vkpt/gpu/commands.h"
#include "refresh/vkpt/gpu/pipeline.h"
#include "shared/random.h"

#include <gtest/gtest.h>

namespace vigil::test {
namespace {

#include "query.comp.h" // uint32_t cdq_query_comp[]

using namespace shader;

/// Trees on their way between all shapes, each with some questions about it.
std::vector<CdqQuery> make_queries(uint32_t bits) {
    Dice dice(bits);
    Random random = random_begin(uvec2(bits, 0), 0, 1);
    const std::array<float, 4> ends{0.0f, 1.0f / 16777216.0f, 0.5f, OCTAHEDRAL_MAX};
    std::vector<CdqQuery> queries;
    std::vector<Quadtree> trees = various_trees(bits, 3, dice);
    for (Quadtree& tree : trees)
        for (int i = 0; i < 4000; ++i) {
            const auto habit = static_cast<Habit>(dice.below(habit_count));
            const Migration chosen = choose_migration(tree, habit, dice);
            CdqQuery query;
            query.tree = tree.field();
            query.bits = bits;
            query.node = 4 + dice.below(bits - 4);
            query.inner = chosen.inner;
            query.order = dice.below(cdq_leaf_count(bits));
            query.uv = random_next2(random);
            query.u = random_next3(random);
            for (int axis = 0; axis < 2; ++axis)
                if (dice.chance(0.2)) query.u[axis + 1] = ends[dice.below(4)];
            if (dice.chance(0.1)) query.uv = vec2(ends[dice.below(4)], ends[dice.below(4)]);
            queries.push_back(query);
            // Every shape of the start is asked about often enough before it is left.
            if (i >= 2000) tree.migrate(chosen.inner, chosen.leaf);
        }
    return queries;
}

std::vector<CdqAnswer> ask(const gpu::Device& device, const std::vector<CdqQuery>& queries) {
    const gpu::Buffer questions = gpu::make_buffer(device, gpu::bytes_of(queries), "queries");
    const gpu::Buffer answers(device, queries.size() * sizeof(CdqAnswer), gpu::MemoryUse::Device,
                              "answers");
    const std::vector<gpu::BindingKind> types(2, gpu::BindingKind::Storage);
    gpu::DescriptorSet set(device, types, answers, "cdq");
    set.bind(0, questions);
    set.bind(1, answers);
    const gpu::PipelineLayout layout(device, {&set});
    const gpu::ComputePipeline pipeline(device, layout, nullptr, cdq_query_comp, {}, "cdq");
    gpu::run_now(device, [&](VkCommandBuffer commands) {
        const VkDescriptorSet handle = set.handle();
        pipeline.dispatch(commands, {std::span(&handle, 1)},
                          {{(static_cast<uint32_t>(queries.size()) + 63) / 64, 1, 1}});
    });
    return gpu::download_now_as<CdqAnswer>(device, answers, 0, queries.size());
}

class CdqGpuTest : public testing::TestWithParam<uint32_t> {
protected:
    CdqGpuTest() : device_(test::validated(), nullptr) {}
    ~CdqGpuTest() override { EXPECT_EQ(device_.validation_messages(), 0); }
    gpu::Device device_;
    const std::vector<CdqQuery> queries_ = make_queries(GetParam());
    const std::vector<CdqAnswer> answers_ = ask(device_, queries_);
};

TEST_P(CdqGpuTest, BitsAndSquaresEqualTheHosts) {
    for (size_t i = 0; i < queries_.size(); ++i) {
        const CdqAnswer host = cdq_answer(queries_[i]);
        const CdqAnswer& got = answers_[i];
        ASSERT_EQ(got.even, host.even) << i;
        ASSERT_EQ(got.rank, host.rank) << i;
        ASSERT_EQ(got.child, host.child) << i;
        ASSERT_EQ(got.parent, host.parent) << i;
        ASSERT_EQ(got.leaf, host.leaf) << i;
        ASSERT_EQ(got.found, host.found) << i;
        ASSERT_EQ(got.found_depth, host.found_depth) << i;
        ASSERT_EQ(got.corner, host.corner) << i;
        ASSERT_EQ(got.size, host.size) << i;
        ASSERT_EQ(got.depth, host.depth) << i;
        ASSERT_EQ(got.drawn, host.drawn) << i;
    }
}

TEST_P(CdqGpuTest, DrawnDirectionsLieInTheirLeafOnTheDeviceToo) {
    for (size_t i = 0; i < queries_.size(); ++i) {
        const CdqAnswer host = cdq_answer(queries_[i]);
        const CdqAnswer& got = answers_[i];
        ASSERT_EQ(got.seen, got.drawn) << i;
        // Near a border one side only may draw the direction back towards the leaf's centre, by
        // 0.005 * size along both axes. The map spreads lengths at most six times: twice from the
        // square to [-1, 1]^2, sqrt(3) each by the slope and the nearness of a face's centre. The
        // density is a cube. Besides that, a few roundings.
        const float shift =
            6.0f * std::sqrt(2.0f) * 0.005f * cdq_cell(queries_[i].tree, got.drawn).size;
        ASSERT_LE(length(got.direction - host.direction), shift + 1e-6f) << i;
        ASSERT_NEAR(got.pdf / host.pdf, 1.0f, 3.0f * shift + 5e-6f) << i;
    }
}

INSTANTIATE_TEST_SUITE_P(Sizes, CdqGpuTest, testing::ValuesIn(cdq_sizes));

} // namespace
} // namespace vigil::test
