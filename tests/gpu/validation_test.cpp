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

constexpr uint32_t bound_words = 4;

class Validation : public testing::Test {
protected:
    void open(int validation) {
        DeviceOptions options;
        options.validation = validation;
        device_.emplace(options, nullptr);
        values_ = Buffer(*device_, 64 * sizeof(uint32_t), MemoryUse::Device, "values");
        answer_ = Buffer(*device_, sizeof(uint32_t), MemoryUse::Device, "answer");
    }
    int messages() const { return device_->validation_messages(); }

    /// Reads word `at` of a binding of bound_words; the buffer itself is longer, so that nothing
    /// bad comes of it.
    void read(uint32_t at) {
        const std::vector<VkDescriptorType> types(2, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER);
        DescriptorSet set(*device_, types, answer_, "values");
        VkDescriptorBufferInfo range{values_.handle(), 0, bound_words * sizeof(uint32_t)};
        VkWriteDescriptorSet write{};
        write.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
        write.dstSet = set.handle();
        write.descriptorCount = 1;
        write.descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
        write.pBufferInfo = &range;
        vkUpdateDescriptorSets(device_->handle(), 1, &write, 0, nullptr);
        set.bind(1, answer_);
        const Handle<VkPipelineLayout> layout =
            make_pipeline_layout(*device_, std::vector{set.layout()});
        const ComputePipeline pipeline(*device_, layout.get(), nullptr, out_of_bounds_comp, {},
                                       "out_of_bounds");
        run_now(*device_, [&](VkCommandBuffer commands) {
            pipeline.bind(commands);
            const VkDescriptorSet handle = set.handle();
            vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, layout.get(), 0, 1,
                                    &handle, 0, nullptr);
            vkCmdPushConstants(commands, layout.get(), VK_SHADER_STAGE_COMPUTE_BIT, 0, sizeof at,
                               &at);
            vkCmdDispatch(commands, 1, 1, 1);
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
    read(bound_words - 1);
    EXPECT_EQ(messages(), 0);
    read(bound_words + 8);
    if (messages() == 0) GTEST_SKIP() << "this validation layer misses reads past a binding's end";
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
