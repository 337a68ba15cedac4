// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/light/shadow_statistics.h"

#include "shared/bindings.h"
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

ShadowStatistics::ShadowStatistics(const gpu::Device& device, gpu::PipelineCompiler& compiler)
    : device_(device), unused_(device, 16, gpu::MemoryUse::Device, "unused"),
      set_(device, std::array{gpu::BindingKind::Storage}, unused_, "shadow statistics set"),
      layout_(device, {&set_}), pass_(Pass::ShadowStatistics, compiler, layout_) {}

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
    pass_.choose();
    set_.bind(BINDING_SHADOW_STATISTICS, table_);
    empty_ = true;
    return true;
}

void ShadowStatistics::adapt(gpu::FrameCommands& commands) {
    if (empty_) {
        const PassScope scope(commands, Pass::ShadowStatistics);
        const VkCommandBuffer buffer = commands.commands();
        vkCmdFillBuffer(buffer, table_.handle(), 0, VK_WHOLE_SIZE, 0);
        gpu::barrier(buffer, gpu::access_of_copies, gpu::access_of_copies);
        commands.upload(table_, 0, gpu::bytes_of_value(slots_));
        empty_ = false;
        return;
    }
    const VkDescriptorSet set = set_.handle();
    pass_.record(commands, {std::span(&set, 1)}, {{(slots_ + 63) / 64, 1, 1}});
}

} // namespace vigil::vkpt
