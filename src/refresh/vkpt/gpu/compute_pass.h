// SPDX-License-Identifier: GPL-2.0-or-later
// A compute pass of the frame as an object: its row in the list of passes, its shader in the
// variants that were asked for, the layout of its descriptor sets, and how it is recorded. What it
// reads (sets and push constants) comes with each recording.
#pragma once

#include "refresh/vkpt/gpu/passes.h"
#include "refresh/vkpt/gpu/pipeline_compiler.h"

#include <deque>
#include <string>

namespace vigil::vkpt {

class ComputePass {
public:
    /// The shader is called as the pass; `layout` outlives it.
    ComputePass(Pass pass, gpu::PipelineCompiler& compiler, const gpu::PipelineLayout& layout)
        : pass_(pass), compiler_(compiler), layout_(layout) {}

    /// Chooses the variant that is recorded next. `suffix` is what the shader's name has behind the
    /// pass's (".vlc.cdq"). The compiler is set to work on a variant when it is chosen first.
    void choose(const std::string& suffix = "", std::vector<gpu::Specialization> constants = {},
                bool ray_queries = false);

    /// Records the chosen variant, behind the barrier that the pass states. Waits while it is being
    /// compiled; throws Error when that failed.
    void record(gpu::FrameCommands& commands, const gpu::Inputs& inputs,
                const gpu::WorkGroups& groups) const {
        const PassScope scope(commands, pass_);
        chosen_->pipeline.dispatch(commands.commands(), inputs, groups);
    }

private:
    struct Variant {
        std::string shader;
        std::vector<gpu::Specialization> constants;
        gpu::ComputePipeline pipeline;
    };
    Pass pass_;
    gpu::PipelineCompiler& compiler_;
    const gpu::PipelineLayout& layout_;
    std::deque<Variant> variants_;
    const Variant* chosen_ = nullptr;
};

} // namespace vigil::vkpt
