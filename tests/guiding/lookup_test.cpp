// SPDX-License-Identifier: GPL-2.0-or-later
// The octree as the path tracer uses it (guiding/octree.glsl): surfaces find the leaf in which they
// were a frame ago and the leaf in which they are, and their samples are stored there, in the
// leaf's room and nowhere else.
#include "guiding_fixture.h"
#include "lookup_query.h"
#include "refresh/vkpt/gpu/commands.h"
#include "shared/bindings.h"
#include "shared/scene_types.h"

#include <algorithm>
#include <array>

namespace vigil::test {
namespace {

#include "lookup.comp.h" // uint32_t lookup_comp[]

using namespace shader;

/// Something that moved from one place to another.
Instance moved(vec3 from, vec3 to) {
    Instance instance{};
    instance.world_from_object = mat4x3(1.0f);
    instance.world_from_object[3] = to;
    instance.object_from_world = mat4x3(1.0f);
    instance.object_from_world[3] = -to;
    instance.previous_world_from_object = mat4x3(1.0f);
    instance.previous_world_from_object[3] = from;
    return instance;
}

/// Positions and shifts in eighths of a map unit: sums are exact, on every device.
vec3 random_place(Dice& dice, float reach) {
    return glm::round(8.0f * vec3(dice.between(-reach, reach), dice.between(-reach, reach),
                                  dice.between(-reach, reach))) /
           8.0f;
}

class GuidingLookup : public GuidingTest {
protected:
    /// Pairs of leaves: of the cache, of the sample.
    std::vector<uvec2> ask(const std::vector<LookupQuery>& queries,
                           const std::vector<Instance>& instances) {
        const gpu::Buffer query_buffer =
            gpu::make_buffer(device(), gpu::bytes_of(queries), "queries");
        const gpu::Buffer instance_buffer =
            gpu::make_buffer(device(), gpu::bytes_of(instances), "instances");
        const gpu::Buffer answers(device(), queries.size() * sizeof(uvec2), gpu::MemoryUse::Device,
                                  "answers");
        std::vector<gpu::BindingKind> types(BINDING_INSTANCES + 1, gpu::BindingKind::Storage);
        types[BINDING_INSTANCES] = gpu::BindingKind::Records;
        gpu::DescriptorSet scene(device(), types, answers, "scene");
        scene.bind(BINDING_INSTANCES, instance_buffer);
        gpu::DescriptorSet own(device(), std::span(types).first(2), answers, "lookup");
        own.bind(0, query_buffer);
        own.bind(1, answers);
        const gpu::PipelineLayout layout(device(), {&scene, &own, &guiding().look_up()});
        const gpu::ComputePipeline pipeline(device(), layout, nullptr, lookup_comp, {}, "lookup");
        const auto count = static_cast<uint32_t>(queries.size());
        const std::array<uint32_t, 2> push{0, count}; // path_index, path_count
        gpu::run_now(device(), [&](VkCommandBuffer commands) {
            const std::array sets{scene.handle(), own.handle(), guiding().set()};
            pipeline.dispatch(commands, {sets, gpu::bytes_of(push)}, {{(count + 63) / 64, 1, 1}});
        });
        return gpu::download_now_as<uvec2>(device(), answers, 0, queries.size());
    }

    /// Random surfaces around the origin, asked and stored; compares answers, counts and stored
    /// samples with the oracle and makes the samples state_'s.
    void render(Dice& dice, uint32_t count, float reach) {
        std::vector<Instance> instances{moved({}, {})};
        for (int i = 0; i < 20; ++i) {
            const vec3 to = random_place(dice, 100.0f);
            const vec3 step = random_place(dice, dice.chance(0.5) ? 8.0f : 2000.0f);
            instances.push_back(moved(dice.chance(0.2) ? to : to - step, to));
        }
        std::vector<LookupQuery> queries;
        for (uint32_t i = 0; i < count; ++i)
            queries.push_back(
                {random_place(dice, reach),
                 dice.chance(0.5) ? 0 : dice.below(static_cast<uint32_t>(instances.size())), i,
                 dice.below(2)});
        for (auto& [path, leaf] : state_.leaves)
            leaf.count = 0;
        upload();
        const std::vector<uvec2> answers = ask(queries, instances);

        // Which leaves, and which samples for each.
        const Numbering numbers(state_.inner);
        const auto leaf_at = [&](vec3 position) {
            return leaf_with(state_.inner, ivec3(cell_of(position))).value();
        };
        ByPath<std::vector<uint32_t>> stored;
        for (uint32_t i = 0; i < count; ++i) {
            const Instance& instance = instances[queries[i].instance];
            const vec3 before = queries[i].position + instance.object_from_world[3] +
                                instance.previous_world_from_object[3];
            const Path now = leaf_at(queries[i].position);
            ASSERT_EQ(answers[i], uvec2(numbers.leaf(leaf_at(before)), numbers.leaf(now)))
                << "surface " << i << " in '" << now << "'";
            stored[now].push_back(i | (queries[i].visible == 1 ? LIGHT_SAMPLE_VISIBLE : 0u));
        }

        // Counted all, stored what there is room for, touched nothing else.
        const std::vector<uint32_t> before = state_.samples;
        state_.samples =
            gpu::download_now_as<uint32_t>(device(), guiding().samples(), 0, before.size());
        const std::vector<uint32_t> leaves = gpu::download_now_as<uint32_t>(
            device(), guiding().tree().leaves, 0,
            uint64_t{8} * LEAF_WORDS * guiding().header().node_capacity);
        std::vector<uint32_t> untouched = state_.samples;
        for (auto& [path, leaf] : state_.leaves) {
            leaf.count = TreeWords{{}, {}, leaves}.at(LEAF_COUNT, numbers.leaf(path));
            std::vector<uint32_t>& expected = stored[path];
            ASSERT_EQ(leaf.count, expected.size()) << "leaf " << path;
            const auto first = state_.samples.begin() + leaf.first_sample;
            std::vector<uint32_t> seen(first, first + leaf.kept());
            std::sort(seen.begin(), seen.end());
            std::sort(expected.begin(), expected.end());
            ASSERT_TRUE(std::includes(expected.begin(), expected.end(), seen.begin(), seen.end()))
                << "leaf " << path;
            std::copy_n(before.begin() + leaf.first_sample, leaf.kept(),
                        untouched.begin() + leaf.first_sample);
        }
        ASSERT_EQ(untouched, before);
    }
};

TEST_F(GuidingLookup, SurfacesFindTheirLeavesAndStoreTheirSamples) {
    start(settings_with(32), 128);
    Dice dice(31);
    uint32_t dropped = 0;
    for (int i = 0; i < 8; ++i) {
        render(dice, 6000, 300.0f);
        if (HasFatalFailure()) return;
        frame();
        if (HasFatalFailure()) return;
        dropped += statistics_.dropped;
    }
    EXPECT_GT(state_.inner.size(), 100u);
    EXPECT_EQ(statistics_.samples, 6000u);
    EXPECT_GT(dropped, 0u); // the first trees have no room where all samples are
}

TEST_F(GuidingLookup, ATreeOfAllDepths) {
    start(settings_with(32), 128);
    Dice dice(32);
    state_ = random_samples(dice, random_tree(dice, 800, 0.7), {}, settings_, guiding().header());
    render(dice, 5000, 5000.0f);
    if (HasFatalFailure()) return;
    frame();
}

} // namespace
} // namespace vigil::test
