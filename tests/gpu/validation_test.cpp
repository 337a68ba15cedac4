// SPDX-License-Identifier: GPL-2.0-or-later
// That each kind of validation notices what it is for. Without this, silence of the layer would
// mean nothing.
#include "common/scratch_folder.h"
#include "out_of_bounds.comp.h"
#include "refresh/vkpt/gpu/commands.h"
#include "refresh/vkpt/gpu/pipeline.h"

#include <array>

namespace vigil::gpu {
namespace {

constexpr uint32_t value_count = 64;

class Validation : public testing::Test {
protected:
    void open(int validation) {
        DeviceOptions options;
        options.validation = validation;
        device_.emplace(options, nullptr);
        values_ = Buffer(*device_, value_count * sizeof(uint32_t), MemoryUse::Device, "values");
        answer_ = Buffer(*device_, sizeof(uint32_t), MemoryUse::Device, "answer");
    }
    int messages() const { return device_->validation_messages(); }

    /// Reads values_[at]. Where the layer notices that this is past the buffer's end, it reads
    /// nothing.
    void read(uint32_t at) {
        const std::vector<BindingKind> types(2, BindingKind::Storage);
        DescriptorSet set(*device_, types, answer_, "values");
        set.bind(0, values_);
        set.bind(1, answer_);
        const PipelineLayout layout(*device_, {&set});
        const ComputePipeline pipeline(*device_, layout, nullptr, out_of_bounds_comp, {},
                                       "out_of_bounds");
        run_now(*device_, [&](VkCommandBuffer commands) {
            const VkDescriptorSet handle = set.handle();
            pipeline.dispatch(commands, {std::span(&handle, 1), bytes_of_value(at)}, {});
        });
    }

    /// Two copies into the same words, with or without a barrier between.
    void copy_twice(bool with_barrier) {
        run_now(*device_, [&](VkCommandBuffer commands) {
            vkCmdFillBuffer(commands, values_.handle(), 0, 16, 1);
            if (with_barrier) full_barrier(commands);
            vkCmdFillBuffer(commands, values_.handle(), 0, 16, 2);
        });
    }

    const test::LogCapture log_; // what is meant to be noticed need not be printed
    std::optional<Device> device_;
    Buffer values_, answer_;

    void TearDown() override { values_ = {}, answer_ = {}; }
};

TEST_F(Validation, OfSynchronisationNoticesAMissingBarrier) {
    open(2);
    copy_twice(true);
    EXPECT_EQ(messages(), 0);
    copy_twice(false);
    EXPECT_GT(messages(), 0);
}

TEST_F(Validation, OnTheGpuNoticesAReadOutOfBounds) {
    open(3);
    read(value_count - 1);
    EXPECT_EQ(messages(), 0);
    read(value_count + 8);
    EXPECT_GT(messages(), 0);
}

TEST_F(Validation, OfTheCoreNoticesAWrongCall) {
    open(1);
    EXPECT_EQ(messages(), 0);
    run_now(*device_, [&](VkCommandBuffer commands) {
        vkCmdFillBuffer(commands, values_.handle(), 2, 16, 1); // offsets are multiples of four
    });
    EXPECT_GT(messages(), 0);
}

} // namespace
} // namespace vigil::gpu
