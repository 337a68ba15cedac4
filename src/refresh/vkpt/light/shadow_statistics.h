// SPDX-License-Identifier: GPL-2.0-or-later
// The table of shadow statistics: how often lights were hidden, by cluster, light and direction of
// the surface (shaders/shared/shadow_statistics.h), and the pass that makes it ready for a frame.
#pragma once

#include "refresh/vkpt/gpu/compute_pass.h"

namespace vigil::vkpt {

class ShadowStatistics {
public:
    ShadowStatistics(const gpu::Device& device, gpu::PipelineCompiler& compiler);

    /// Makes room for lists of so many lights together. Returns true if the buffer was made anew:
    /// it has forgotten everything then, and the GPU is idle.
    bool reserve(uint64_t pairs);
    /// Slots of a table for so many pairs of a cluster and a light: some for each direction that a
    /// light is seen from, a power of two, and no more than can be gone through in every frame.
    static uint32_t slots_for(uint64_t pairs);

    /// The next adapt() starts with an empty table.
    void forget() { empty_ = true; }
    /// Records the pass that turns counts into what the frame reads. After reserve().
    void adapt(gpu::FrameCommands& commands);

    /// As shaders/light/shadow_statistics.glsl declares it; null before reserve().
    const gpu::Buffer* buffer() const { return table_ ? &table_ : nullptr; }

private:
    const gpu::Device& device_;
    gpu::Buffer unused_;
    gpu::DescriptorSet set_;
    gpu::PipelineLayout layout_;
    ComputePass pass_;
    gpu::Buffer table_;
    uint32_t slots_ = 0;
    bool empty_ = true;
};

} // namespace vigil::vkpt
