// SPDX-License-Identifier: GPL-2.0-or-later
#include "test_pass.h"

#include "shaders/vkpt_test_shaders_includes.inc"

#include <array>

namespace vigil::test {

namespace {

struct Row {
    std::string_view name;
    std::span<const uint32_t> code;
};

const Row rows[] = {
#include "shaders/vkpt_test_shaders_rows.inc"
};

} // namespace

std::span<const uint32_t> test_shader_code(std::string_view name) {
    for (const Row& row : rows)
        if (row.name == name) return row.code;
    return {};
}

TestPass::TestPass(vkpt::VkptRenderer& renderer, const std::string& name)
    : TestPass(renderer, name, renderer.scene()->features()) {}

TestPass::TestPass(vkpt::VkptRenderer& renderer, const std::string& name,
                   const vkpt::SceneFeatures& features)
    : renderer_(renderer), device_(renderer.device()), name_(name), features_(features),
      unused_(device_, 16, gpu::MemoryUse::Device, "unused") {}

void TestPass::add_buffer(std::span<const std::byte> bytes) {
    buffers_.push_back(gpu::make_buffer(device_, bytes, "test"));
}

void TestPass::add_buffer(size_t bytes) {
    add_buffer(std::vector<std::byte>(bytes));
}

void TestPass::make_pipeline() {
    const std::vector<VkDescriptorType> own_types(buffers_.size(),
                                                  VK_DESCRIPTOR_TYPE_STORAGE_BUFFER);
    set_ = gpu::DescriptorSet(device_, own_types, unused_, "test");
    const auto [scene_layout, technique_layout, guiding_layout] =
        renderer_.path_tracer().set_layouts();
    layout_ = gpu::make_pipeline_layout(
        device_, std::array{scene_layout, technique_layout, guiding_layout, set_.layout()});
    const std::array<gpu::Specialization, 8> constants{{{0, features_.instances},
                                                        {1, features_.translucent},
                                                        {8, features_.sky},
                                                        {9, features_.sun},
                                                        {10, features_.gloss},
                                                        {11, features_.liquid},
                                                        {12, features_.animation},
                                                        {13, features_.lights}}};
    pipeline_ = {device_,   layout_.get(), nullptr, test_shader_code(name_),
                 constants, name_.c_str()};
}

void TestPass::run(glm::uvec3 groups, glm::uvec2 push) {
    if (!pipeline_) make_pipeline();
    device_.wait_idle();
    for (uint32_t i = 0; i < buffers_.size(); ++i)
        set_.bind(i, buffers_[i]);
    gpu::run_now(device_, [&](VkCommandBuffer commands) {
        const std::array sets{renderer_.path_tracer().scene_set(),
                              renderer_.path_tracer().technique_set(), renderer_.guiding().set(),
                              set_.handle()};
        vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, layout_.get(), 0,
                                static_cast<uint32_t>(sets.size()), sets.data(), 0, nullptr);
        pipeline_.bind(commands);
        vkCmdPushConstants(commands, layout_.get(), VK_SHADER_STAGE_COMPUTE_BIT, 0, sizeof(push),
                           &push);
        vkCmdDispatch(commands, groups.x, groups.y, groups.z);
        gpu::full_barrier(commands);
    });
}

} // namespace vigil::test
