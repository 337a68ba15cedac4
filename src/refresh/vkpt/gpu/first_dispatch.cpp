// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/gpu/first_dispatch.h"

#include <array>

namespace vigil::gpu {

FirstDispatch::FirstDispatch(const Device& device, FrameCommands& commands, const PipelineJob& job)
    : device_(device), commands_(commands),
      buffer_(device, 16, MemoryUse::Device, "unused", VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT) {
    std::vector<VkDescriptorSet> handles;
    for (const std::vector<BindingKind>& kinds : job.layout->sets()) {
        DescriptorSet& set = sets_.emplace_back(device, kinds, buffer_, "unused");
        for (uint32_t i = 0; i < kinds.size(); ++i)
            if (kinds[i] == BindingKind::Uniform) set.bind(i, buffer_);
        handles.push_back(set.handle());
    }

    commands_.begin();
    const VkCommandBuffer buffer = commands_.commands();
    vkCmdBindDescriptorSets(buffer, VK_PIPELINE_BIND_POINT_COMPUTE, job.layout->handle(), 0,
                            static_cast<uint32_t>(handles.size()), handles.data(), 0, nullptr);
    const std::array<uint32_t, 32> constants{};
    vkCmdPushConstants(buffer, job.layout->handle(), VK_SHADER_STAGE_COMPUTE_BIT, 0,
                       sizeof(constants), constants.data());
    vkCmdBindPipeline(buffer, VK_PIPELINE_BIND_POINT_COMPUTE, job.pipeline.get());
    vkCmdDispatch(buffer, 0, 1, 1);
    commands_.submit(VK_NULL_HANDLE, 0, VK_NULL_HANDLE);
}

FirstDispatch::~FirstDispatch() {
    if (done_) return;
    const VkFence fence = commands_.fence();
    vkWaitForFences(device_.handle(), 1, &fence, VK_TRUE, UINT64_MAX);
}

bool FirstDispatch::wait_for(std::chrono::milliseconds time) {
    const VkFence fence = commands_.fence();
    const auto nanoseconds = std::chrono::duration_cast<std::chrono::nanoseconds>(time);
    const VkResult result = vkWaitForFences(device_.handle(), 1, &fence, VK_TRUE,
                                            static_cast<uint64_t>(nanoseconds.count()));
    if (result == VK_TIMEOUT) return false;
    check(result, "vkWaitForFences");
    return done_ = true;
}

} // namespace vigil::gpu
