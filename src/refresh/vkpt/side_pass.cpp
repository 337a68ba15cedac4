// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/side_pass.h"

#include <array>
#include <utility>

namespace vigil::vkpt {

SidePass::SidePass(VkptRenderer& renderer, std::span<const uint32_t> code, std::string name,
                   const SceneFeatures& features)
    : renderer_(renderer), device_(renderer.device()), code_(code), name_(std::move(name)),
      features_(features), unused_(device_, 16, gpu::MemoryUse::Device, "unused") {}

void SidePass::add_buffer(std::span<const std::byte> bytes) {
    buffers_.push_back(gpu::make_buffer(device_, bytes, name_.c_str()));
}

void SidePass::add_buffer(size_t bytes) {
    add_buffer(std::vector<std::byte>(bytes));
}

void SidePass::make_pipeline() {
    const std::vector<gpu::BindingKind> own_kinds(buffers_.size(), gpu::BindingKind::Storage);
    set_ = gpu::DescriptorSet(device_, own_kinds, unused_, name_.c_str());
    const FrameBuffers& buffers = renderer_.buffers();
    layout_ = gpu::PipelineLayout(device_, {&buffers.scene_set(), &buffers.technique_set(),
                                            &renderer_.guiding().look_up(), &set_});
    pipeline_ = {
        device_,      layout_, nullptr, code_, specialization(features_, renderer_.guide()),
        name_.c_str()};
}

void SidePass::run(glm::uvec3 groups, glm::uvec2 push) {
    if (!pipeline_) make_pipeline();
    device_.wait_idle();
    for (uint32_t i = 0; i < buffers_.size(); ++i)
        set_.bind(i, buffers_[i]);
    gpu::run_now(device_, [&](VkCommandBuffer commands) {
        const std::array sets{renderer_.buffers().scene_set().handle(),
                              renderer_.buffers().technique_set().handle(),
                              renderer_.guiding().set(), set_.handle()};
        pipeline_.dispatch(commands, {sets, gpu::bytes_of_value(push)}, {groups});
    });
}

} // namespace vigil::vkpt
