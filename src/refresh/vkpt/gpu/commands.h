// SPDX-License-Identifier: GPL-2.0-or-later
// Recording and submitting: one-off commands that wait, and a ring of frames in flight, each with
// its command buffer, fence, staging memory and timestamps. A frame's data is copied from its
// staging memory inside its own command buffer, so that device buffers exist once and never race
// with the frame before.
#pragma once

#include "refresh/vkpt/gpu/buffer.h"
#include "refresh/vkpt/gpu/gpu_timer.h"

#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <vector>

namespace vigil::gpu {

/// Ways to use memory, for barriers.
struct Access {
    VkPipelineStageFlags stages;
    VkAccessFlags kinds;
    constexpr Access operator|(Access other) const {
        return {stages | other.stages, kinds | other.kinds};
    }
};
inline constexpr Access access_of_shaders{VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT,
                                          VK_ACCESS_UNIFORM_READ_BIT | VK_ACCESS_SHADER_READ_BIT |
                                              VK_ACCESS_SHADER_WRITE_BIT};
inline constexpr Access access_of_copies{
    VK_PIPELINE_STAGE_TRANSFER_BIT, VK_ACCESS_TRANSFER_READ_BIT | VK_ACCESS_TRANSFER_WRITE_BIT};
inline constexpr Access access_of_indirect_dispatches{VK_PIPELINE_STAGE_DRAW_INDIRECT_BIT,
                                                      VK_ACCESS_INDIRECT_COMMAND_READ_BIT};
inline constexpr Access access_of_host{VK_PIPELINE_STAGE_HOST_BIT, VK_ACCESS_HOST_READ_BIT};
inline constexpr Access any_access{VK_PIPELINE_STAGE_ALL_COMMANDS_BIT,
                                   VK_ACCESS_MEMORY_READ_BIT | VK_ACCESS_MEMORY_WRITE_BIT};

/// Commands behind it that use memory as in `later` wait for those before it that used memory as in
/// `earlier`, and see what they wrote.
void barrier(VkCommandBuffer commands, Access earlier, Access later);
/// A barrier for whatever is done before and behind it.
inline void full_barrier(VkCommandBuffer commands) {
    barrier(commands, any_access, any_access);
}

/// Records `record`, submits, waits until the GPU is done; the host may read what was copied.
void run_now(const Device& device, const std::function<void(VkCommandBuffer)>& record);

/// Copies `bytes` into `target` at `offset` through staging memory, and waits.
void upload_now(const Device& device, const Buffer& target, uint64_t offset,
                std::span<const std::byte> bytes);

/// Makes a device buffer that holds `bytes`.
Buffer make_buffer(const Device& device, std::span<const std::byte> bytes, const char* name,
                   VkBufferUsageFlags extra_usage = 0);

/// Reads `bytes` bytes of `source` from `offset`, and waits.
std::vector<std::byte> download_now(const Device& device, const Buffer& source, uint64_t offset,
                                    uint64_t bytes);

template <typename T>
std::vector<T> download_now_as(const Device& device, const Buffer& source, uint64_t first,
                               uint64_t count) {
    const std::vector<std::byte> raw =
        download_now(device, source, first * sizeof(T), count * sizeof(T));
    std::vector<T> values(static_cast<size_t>(count));
    std::copy(raw.begin(), raw.end(), reinterpret_cast<std::byte*>(values.data()));
    return values;
}

/// One frame in flight.
class FrameCommands {
public:
    explicit FrameCommands(const Device& device);

    VkCommandBuffer commands() const { return commands_; }
    VkFence fence() const { return fence_.get(); }
    const Device& device() const { return *device_; }
    GpuTimer& timer() { return timer_; }

    /// Waits until the GPU has finished this slot's last frame, unless that was done before, and
    /// reads its times. Returns whether there was such a frame.
    bool finish();
    /// Finishes this slot's last frame, then starts recording.
    void begin();
    /// Ends recording and submits; `wait`/`signal` may be null.
    void submit(VkSemaphore wait, VkPipelineStageFlags wait_stage, VkSemaphore signal);

    /// Records a copy of `bytes` into `target` at `offset`. Barriers are the caller's: the next
    /// pass that reads it waits for copies.
    void upload(const Buffer& target, uint64_t offset, std::span<const std::byte> bytes);

    /// Keeps a resource until the GPU has finished this frame, and with it all frames before.
    template <typename Resource> void keep(Resource&& resource) {
        kept_.push_back(std::make_shared<std::decay_t<Resource>>(std::forward<Resource>(resource)));
    }

private:
    const Device* device_;
    Handle<VkCommandPool> pool_;
    VkCommandBuffer commands_ = VK_NULL_HANDLE;
    Handle<VkFence> fence_;
    std::vector<Buffer> staging_; // chunks; kept and reused
    size_t staging_chunk_ = 0;
    uint64_t staging_used_ = 0;
    std::vector<std::shared_ptr<void>> kept_;
    GpuTimer timer_;
    bool submitted_ = false;
};

} // namespace vigil::gpu
