// SPDX-License-Identifier: GPL-2.0-or-later
// GPU timestamps around passes. One timer per frame in flight; results are read after its fence,
// never by stalling. A pass that runs several times in a frame is summed. Devices without
// timestamps report no times.
#pragma once

#include "refresh/vkpt/gpu/device.h"

#include <vector>

namespace vigil::gpu {

class GpuTimer {
public:
    explicit GpuTimer(const Device& device);

    /// Resets the queries; call at the start of a frame's commands.
    void begin(VkCommandBuffer commands);
    /// Marks the start / end of pass `id` (any small index).
    void start(VkCommandBuffer commands, uint32_t id);
    void stop(VkCommandBuffer commands);

    /// Reads this slot's results; only after the frame's fence.
    void collect();
    /// Milliseconds per pass id of the frame that was collected last; 0 for ids that did not run.
    double milliseconds(uint32_t id) const;

private:
    void add_pool();
    void write(VkCommandBuffer commands, uint32_t end);

    const Device* device_;
    std::vector<Handle<VkQueryPool>>
        pools_;                 // as many as a frame has needed; none without timestamps
    std::vector<uint32_t> ids_; // of each start/stop pair, in order
    std::vector<double> milliseconds_;
    bool open_ = false;
};

} // namespace vigil::gpu
