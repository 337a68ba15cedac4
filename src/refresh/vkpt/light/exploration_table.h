// SPDX-License-Identifier: GPL-2.0-or-later
// The table of all lights that techniques look for lights with (paper, section 4.3), as
// shaders/light/alias.glsl reads it: weighted by power, change and nearness to the camera as the
// variables pt_explore_* say, and made anew in every frame in which one of them differs.
#pragma once

#include "refresh/vkpt/gpu/growing_buffer.h"
#include "refresh/vkpt/light/exploration.h"
#include "refresh/vkpt/light/technique.h"

namespace vigil::vkpt {

class ExplorationTable {
public:
    explicit ExplorationTable(const gpu::Device& device) : table_(device, "alias table") {}

    /// Brings the table to this frame; once per frame. Returns true if the buffer was made anew.
    bool prepare(const LightFrame& frame);
    void upload(gpu::FrameCommands& commands) { table_.upload(commands); }
    const gpu::Buffer& buffer() const { return table_.buffer(); }

private:
    gpu::GrowingBuffer table_;
    Exploration exploration_;
    ExplorationMix mix_;
    uint64_t revision_ = 0;
    glm::vec3 eye_{0.0f};
};

} // namespace vigil::vkpt
