// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/gpu/commands.h"

#include <algorithm>
#include <cstring>

namespace vigil::gpu {

namespace {

constexpr uint64_t staging_chunk_bytes = 4u << 20;

Handle<VkCommandPool> make_pool(const Device& device) {
    auto info = structure<VkCommandPoolCreateInfo>(VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO);
    info.flags = VK_COMMAND_POOL_CREATE_TRANSIENT_BIT;
    info.queueFamilyIndex = device.queue_family();
    return device.make(vkCreateCommandPool, vkDestroyCommandPool, info, "vkCreateCommandPool");
}

VkCommandBuffer allocate_commands(const Device& device, VkCommandPool pool) {
    auto info =
        structure<VkCommandBufferAllocateInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO);
    info.commandPool = pool;
    info.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
    info.commandBufferCount = 1;
    VkCommandBuffer commands = VK_NULL_HANDLE;
    check(vkAllocateCommandBuffers(device.handle(), &info, &commands), "vkAllocateCommandBuffers");
    return commands;
}

void begin_once(VkCommandBuffer commands) {
    auto begin = structure<VkCommandBufferBeginInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO);
    begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    check(vkBeginCommandBuffer(commands, &begin), "vkBeginCommandBuffer");
}

Handle<VkFence> make_fence(const Device& device) {
    auto info = structure<VkFenceCreateInfo>(VK_STRUCTURE_TYPE_FENCE_CREATE_INFO);
    return device.make(vkCreateFence, vkDestroyFence, info, "vkCreateFence");
}

} // namespace

void barrier(VkCommandBuffer commands, Access earlier, Access later) {
    auto memory = structure<VkMemoryBarrier>(VK_STRUCTURE_TYPE_MEMORY_BARRIER);
    memory.srcAccessMask = earlier.kinds;
    memory.dstAccessMask = later.kinds;
    vkCmdPipelineBarrier(commands, earlier.stages, later.stages, 0, 1, &memory, 0, nullptr, 0,
                         nullptr);
}

void run_now(const Device& device, const std::function<void(VkCommandBuffer)>& record) {
    const Handle<VkCommandPool> pool = make_pool(device);
    const VkCommandBuffer commands = allocate_commands(device, pool.get());
    begin_once(commands);
    full_barrier(commands);
    record(commands);
    barrier(commands, access_of_copies, access_of_host);
    check(vkEndCommandBuffer(commands), "vkEndCommandBuffer");
    const Handle<VkFence> fence = make_fence(device);
    auto submit = structure<VkSubmitInfo>(VK_STRUCTURE_TYPE_SUBMIT_INFO);
    submit.commandBufferCount = 1;
    submit.pCommandBuffers = &commands;
    check(vkQueueSubmit(device.queue(), 1, &submit, fence.get()), "vkQueueSubmit");
    const VkFence raw = fence.get();
    const VkResult waited = vkWaitForFences(device.handle(), 1, &raw, VK_TRUE, UINT64_MAX);
    // The device may still be at work, and what it works with is destroyed on the way out.
    if (waited != VK_SUCCESS) vkDeviceWaitIdle(device.handle());
    check(waited, "vkWaitForFences");
}

void upload_now(const Device& device, const Buffer& target, uint64_t offset,
                std::span<const std::byte> bytes) {
    constexpr uint64_t chunk = 64u << 20;
    if (bytes.empty()) return;
    device.usage().uploaded(target.name(), bytes.size());
    const Buffer staging(device, std::min<uint64_t>(chunk, bytes.size()), MemoryUse::Upload,
                         "staging");
    for (uint64_t done = 0; done < bytes.size(); done += chunk) {
        const uint64_t count = std::min<uint64_t>(chunk, bytes.size() - done);
        std::memcpy(staging.mapped(), bytes.data() + done, count);
        run_now(device, [&](VkCommandBuffer commands) {
            const VkBufferCopy region{0, offset + done, count};
            vkCmdCopyBuffer(commands, staging.handle(), target.handle(), 1, &region);
        });
    }
}

Buffer make_buffer(const Device& device, std::span<const std::byte> bytes, const char* name,
                   VkBufferUsageFlags extra_usage) {
    Buffer buffer(device, bytes.size(), MemoryUse::Device, name, extra_usage);
    upload_now(device, buffer, 0, bytes);
    return buffer;
}

std::vector<std::byte> download_now(const Device& device, const Buffer& source, uint64_t offset,
                                    uint64_t bytes) {
    if (bytes == 0) return {};
    const Buffer staging(device, bytes, MemoryUse::Readback, "readback");
    run_now(device, [&](VkCommandBuffer commands) {
        const VkBufferCopy region{offset, 0, bytes};
        vkCmdCopyBuffer(commands, source.handle(), staging.handle(), 1, &region);
    });
    return {staging.mapped(), staging.mapped() + bytes};
}

FrameCommands::FrameCommands(const Device& device)
    : device_(&device), pool_(make_pool(device)), commands_(allocate_commands(device, pool_.get())),
      fence_(make_fence(device)), timer_(device) {}

bool FrameCommands::finish() {
    if (!submitted_) return false;
    const VkFence fence = fence_.get();
    check(vkWaitForFences(device_->handle(), 1, &fence, VK_TRUE, UINT64_MAX), "vkWaitForFences");
    timer_.collect();
    kept_.clear();
    submitted_ = false;
    return true;
}

void FrameCommands::begin() {
    finish();
    const VkFence fence = fence_.get();
    check(vkResetFences(device_->handle(), 1, &fence), "vkResetFences");
    check(vkResetCommandPool(device_->handle(), pool_.get(), 0), "vkResetCommandPool");
    begin_once(commands_);
    full_barrier(commands_);
    staging_chunk_ = 0;
    staging_used_ = 0;
    timer_.begin(commands_);
}

void FrameCommands::submit(VkSemaphore wait, VkPipelineStageFlags wait_stage, VkSemaphore signal) {
    check(vkEndCommandBuffer(commands_), "vkEndCommandBuffer");
    auto info = structure<VkSubmitInfo>(VK_STRUCTURE_TYPE_SUBMIT_INFO);
    info.waitSemaphoreCount = wait ? 1u : 0u;
    info.pWaitSemaphores = &wait;
    info.pWaitDstStageMask = &wait_stage;
    info.commandBufferCount = 1;
    info.pCommandBuffers = &commands_;
    info.signalSemaphoreCount = signal ? 1u : 0u;
    info.pSignalSemaphores = &signal;
    check(vkQueueSubmit(device_->queue(), 1, &info, fence_.get()), "vkQueueSubmit");
    submitted_ = true;
}

void FrameCommands::upload(const Buffer& target, uint64_t offset,
                           std::span<const std::byte> bytes) {
    device_->usage().uploaded(target.name(), bytes.size());
    for (uint64_t done = 0; done < bytes.size();) {
        if (staging_chunk_ < staging_.size() && staging_used_ == staging_[staging_chunk_].bytes()) {
            ++staging_chunk_;
            staging_used_ = 0;
        }
        if (staging_chunk_ == staging_.size())
            staging_.emplace_back(*device_, staging_chunk_bytes, MemoryUse::Upload,
                                  "frame staging");
        const Buffer& chunk = staging_[staging_chunk_];
        const uint64_t count =
            std::min<uint64_t>(chunk.bytes() - staging_used_, bytes.size() - done);
        std::memcpy(chunk.mapped() + staging_used_, bytes.data() + done, count);
        const VkBufferCopy region{staging_used_, offset + done, count};
        vkCmdCopyBuffer(commands_, chunk.handle(), target.handle(), 1, &region);
        // Copies start at multiples of four bytes.
        staging_used_ =
            std::min<uint64_t>(chunk.bytes(), (staging_used_ + count + 15u) & ~uint64_t{15});
        done += count;
    }
}

} // namespace vigil::gpu
