// SPDX-License-Identifier: GPL-2.0-or-later
// An alias table over all lights on the GPU, as shaders/light/alias.glsl reads it.
#pragma once

#include "refresh/vkpt/gpu/growing_buffer.h"

#include <span>

namespace vigil::vkpt {

class AliasBuffer {
public:
    explicit AliasBuffer(const gpu::Device& device) : table_(device, "alias table") {}

    /// Makes the table of these weights (build_alias_table). Returns true if the buffer was made
    /// anew.
    bool set(std::span<const float> weights);
    void upload(gpu::FrameCommands& commands) { table_.upload(commands); }
    const gpu::Buffer& buffer() const { return table_.buffer(); }

private:
    gpu::GrowingBuffer table_;
};

} // namespace vigil::vkpt
