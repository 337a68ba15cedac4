// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/light/shadow_statistics.h"

#include "refresh/vkpt/gpu/passes.h"
#include "refresh/vkpt/gpu/shader_library.h"
#include "shared/shadow_statistics.h"

#include <algorithm>
#include <array>
#include <bit>

namespace vigil::vkpt {

namespace {

/// Of the six directions of a light's surfaces in a cluster, those that face away from it are never
/// counted; the rest leave half of the slots free.
constexpr uint64_t slots_per_pair = 8;
constexpr uint64_t least_slots = 1 << 12, most_slots = 1 << 21;

} // namespace

ShadowStatistics::ShadowStatistics(const gpu::Device& device)
    : device_(device), unused_(device, 16, gpu::MemoryUse::Device, "unused") {}

uint32_t ShadowStatistics::slots_for(uint64_t pairs) {
    return std::bit_ceil(static_cast<uint32_t>(
        std::clamp(slots_per_pair * std::min(pairs, most_slots), least_slots, most_slots)));
}

bool ShadowStatistics::reserve(uint64_t pairs) {
    const uint32_t slots = slots_for(pairs);
    if (slots <= slots_) return false;
    device_.wait_idle();
    table_ =
        gpu::Buffer(device_, sizeof(uint32_t) * (1 + uint64_t{shader::SHADOW_SLOT_WORDS} * slots),
                    gpu::MemoryUse::Device, "shadow statistics");
    slots_ = slots;
    if (!pass_) {
        const std::array types{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER};
        set_ = gpu::DescriptorSet(device_, types, unused_, "shadow statistics set");
        layout_ = gpu::make_pipeline_layout(device_, std::array{set_.layout()});
        pass_ = {device_, layout_.get(),      nullptr, shader_code("shadow_statistics"),
                 {},      "shadow_statistics"};
    }
    set_.bind(0, table_);
    empty_ = true;
    return true;
}

void ShadowStatistics::adapt(gpu::FrameCommands& commands) {
    const PassScope scope(device_, commands, Pass::ShadowStatistics);
    const VkCommandBuffer buffer = commands.commands();
    if (empty_) {
        vkCmdFillBuffer(buffer, table_.handle(), 0, VK_WHOLE_SIZE, 0);
        gpu::full_barrier(buffer);
        commands.upload(table_, 0, gpu::bytes_of_value(slots_));
        empty_ = false;
        return;
    }
    const VkDescriptorSet set = set_.handle();
    vkCmdBindDescriptorSets(buffer, VK_PIPELINE_BIND_POINT_COMPUTE, layout_.get(), 0, 1, &set, 0,
                            nullptr);
    pass_.bind(buffer);
    vkCmdDispatch(buffer, (slots_ + 63) / 64, 1, 1);
}

} // namespace vigil::vkpt
