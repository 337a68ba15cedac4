// SPDX-License-Identifier: GPL-2.0-or-later
// A shader's first dispatch, over nothing. Mesa's llvmpipe makes machine code only then, on the one
// thread that works for its queue. Done before the frame, one shader after the other, the wait can
// be told of. Other drivers compile when a pipeline is made.
#pragma once

#include "refresh/vkpt/gpu/commands.h"
#include "refresh/vkpt/gpu/pipeline_compiler.h"

#include <chrono>

namespace vigil::gpu {

class FirstDispatch {
public:
    /// Submits it: the job's pipeline is made, and nothing else is recorded in `commands`.
    FirstDispatch(const Device& device, FrameCommands& commands, const PipelineJob& job);
    ~FirstDispatch(); // waits
    FirstDispatch(const FirstDispatch&) = delete;
    FirstDispatch& operator=(const FirstDispatch&) = delete;

    /// Waits at most so long. True if it is done.
    bool wait_for(std::chrono::milliseconds time);

private:
    const Device& device_;
    FrameCommands& commands_;
    // Something valid at each binding that the shader uses.
    Buffer buffer_;
    std::vector<DescriptorSet> sets_;
    bool done_ = false;
};

} // namespace vigil::gpu
