// SPDX-License-Identifier: GPL-2.0-or-later
// Pipelines that are made on threads: they work, they tell how far they are, a fault among them is
// told where it matters, and what nobody wants any more is not waited for. First dispatches compute
// nothing.
#include "refresh/vkpt/gpu/pipeline_compiler.h"

#include "common/error.h"
#include "common/scratch_folder.h"
#include "counted.comp.h"
#include "gpu/validated.h"
#include "refresh/vkpt/gpu/commands.h"
#include "refresh/vkpt/gpu/first_dispatch.h"

#include <gtest/gtest.h>

namespace vigil::gpu {
namespace {

using namespace std::chrono_literals;

class PipelineCompilerTest : public testing::Test {
protected:
    PipelineCompilerTest()
        : device_(test::validated(), nullptr), buffer_(make()),
          set_(device_, types, buffer_, "set"), layout_(device_, {&set_}) {}
    ~PipelineCompilerTest() override { EXPECT_EQ(device_.validation_messages(), 0); }

    Buffer make() const { return make_buffer(device_, bytes_of(std::array{0u}), "counter"); }
    PipelineSource source(uint32_t step) const {
        return {counted_comp, {{3, step}}, "counted." + std::to_string(step)};
    }
    uint32_t count_with(const ComputePipeline& pipeline) const {
        run_now(device_, [&](VkCommandBuffer commands) {
            const VkDescriptorSet set = set_.handle();
            pipeline.dispatch(commands, {std::span(&set, 1)}, {});
        });
        return download_now_as<uint32_t>(device_, buffer_, 0, 1)[0];
    }

    static constexpr std::array types{BindingKind::Storage};
    test::ScratchFolder folder_;
    Device device_;
    Buffer buffer_;
    DescriptorSet set_;
    PipelineLayout layout_;
};

TEST_F(PipelineCompilerTest, MakesWhatWorksAndTellsHowFarItIs) {
    PipelineCompiler compiler(device_, folder_.path() / "pipelines.bin");
    EXPECT_TRUE(compiler.idle());
    std::vector<ComputePipeline> pipelines;
    for (uint32_t step = 1; step <= 9; ++step)
        pipelines.emplace_back(compiler, layout_, source(step));
    const refresh::Compilation before = compiler.state();
    EXPECT_EQ(before.total, 9);
    EXPECT_LE(before.done, 9);
    ASSERT_TRUE(compiler.wait_for(100s));
    EXPECT_TRUE(compiler.idle());
    while (const auto job = compiler.begin_first_dispatch())
        compiler.finish_first_dispatch(job);
    const refresh::Compilation after = compiler.state();
    EXPECT_EQ(after.done, 9);
    EXPECT_EQ(after.total, 9);
    EXPECT_EQ(after.share, 1.0f);
    EXPECT_TRUE(after.passes.empty());
    uint32_t sum = 0;
    for (uint32_t step = 1; step <= 9; ++step) {
        sum += 8 * step;
        EXPECT_EQ(count_with(pipelines[step - 1]), sum) << step;
    }
    // The next wait counts anew; who binds before it is made waits.
    const ComputePipeline late(compiler, layout_, source(10));
    EXPECT_EQ(count_with(late), sum + 80);
    EXPECT_EQ(compiler.state().total, 1);
}

TEST_F(PipelineCompilerTest, TellsWhatItMadeAndHowLongThatTook) {
    PipelineCompiler compiler(device_, "");
    const ComputePipeline pipeline(compiler, layout_, source(3));
    ASSERT_TRUE(compiler.wait_for(100s));
    double least = 0.0;
    if (const auto job = compiler.begin_first_dispatch()) {
        EXPECT_TRUE(compiler.take_compiled().empty()) << "its first dispatch compiles";
        FrameCommands commands(device_);
        const Stopwatch watch;
        FirstDispatch dispatch(device_, commands, *job);
        EXPECT_TRUE(dispatch.wait_for(100s));
        least = watch.seconds();
        compiler.finish_first_dispatch(job);
    }
    const std::vector<CompiledPipeline> made = compiler.take_compiled();
    ASSERT_EQ(made.size(), 1u);
    EXPECT_EQ(made[0].source.name, "counted.3");
    EXPECT_EQ(made[0].source.constants, source(3).constants);
    EXPECT_GT(made[0].seconds, least);
    EXPECT_TRUE(compiler.take_compiled().empty());
}

TEST_F(PipelineCompilerTest, WhatNobodyWantsIsDropped) {
    PipelineCompiler compiler(device_, folder_.path() / "pipelines.bin");
    for (int i = 0; i < 20; ++i) {
        ComputePipeline pipeline(compiler, layout_, source(1));
        pipeline = {compiler, layout_, source(2)};
        const ComputePipeline moved = std::move(pipeline);
        EXPECT_TRUE(moved);
    }
    EXPECT_TRUE(compiler.wait_for(100s));
}

TEST_F(PipelineCompilerTest, FirstDispatchesComeFromTheSmallestAndDoNothing) {
    PipelineCompiler compiler(device_, folder_.path() / "pipelines.bin");
    const ComputePipeline pipeline(compiler, layout_, source(1)),
        other(compiler, layout_, source(2));
    ASSERT_TRUE(compiler.wait_for(100s));
    const bool late = device_.features().llvmpipe_mesa > 0;
    EXPECT_EQ(compiler.state().done, late ? 0 : 2);
    FrameCommands commands(device_);
    int dispatched = 0;
    while (const auto job = compiler.begin_first_dispatch()) {
        EXPECT_EQ(compiler.state().passes, std::vector{job->source.name});
        FirstDispatch dispatch(device_, commands, *job);
        EXPECT_TRUE(dispatch.wait_for(100s));
        compiler.finish_first_dispatch(job);
        ++dispatched;
    }
    EXPECT_EQ(dispatched, late ? 2 : 0);
    EXPECT_EQ(compiler.state().done, 2);
    EXPECT_EQ(compiler.state().total, 2);
    EXPECT_EQ(count_with(pipeline), 8u); // nothing was counted before
}

TEST_F(PipelineCompilerTest, WhatIsDroppedIsNotDispatched) {
    PipelineCompiler compiler(device_, folder_.path() / "pipelines.bin");
    {
        const ComputePipeline pipeline(compiler, layout_, source(1));
        ASSERT_TRUE(compiler.wait_for(100s));
    }
    EXPECT_EQ(compiler.begin_first_dispatch(), nullptr);
}

} // namespace
} // namespace vigil::gpu
