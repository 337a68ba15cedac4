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
#include <vector>

namespace vigil::gpu {

/// Makes all earlier writes of this queue visible to all later commands.
void full_barrier(VkCommandBuffer commands);

/// Lets the host read what was copied, once a fence tells that the commands are done.
void host_read_barrier(VkCommandBuffer commands);

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
    GpuTimer& timer() { return timer_; }

    /// Waits until the GPU has finished this slot's last frame, unless that was done before, and
    /// reads its times. Returns whether there was such a frame.
    bool finish();
    /// Finishes this slot's last frame, then starts recording.
    void begin();
    /// Ends recording and submits; `wait`/`signal` may be null.
    void submit(VkSemaphore wait, VkPipelineStageFlags wait_stage, VkSemaphore signal);

    /// Records a copy of `bytes` into `target` at `offset`. Barriers are the caller's: a
    /// full_barrier after the last upload of a frame.
    void upload(const Buffer& target, uint64_t offset, std::span<const std::byte> bytes);

private:
    const Device* device_;
    Handle<VkCommandPool> pool_;
    VkCommandBuffer commands_ = VK_NULL_HANDLE;
    Handle<VkFence> fence_;
    std::vector<Buffer> staging_; // chunks; kept and reused
    size_t staging_chunk_ = 0;
    uint64_t staging_used_ = 0;
    GpuTimer timer_;
    bool submitted_ = false;
};

} // namespace vigil::gpu
