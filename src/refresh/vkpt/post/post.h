// SPDX-License-Identifier: GPL-2.0-or-later
// From a frame's radiance to the finished 8-bit picture: the running mean, the exposure, tone
// mapping, in which debug views (pt_view) take the picture's place, and scaling up.
#pragma once

#include "refresh/vkpt/pathtrace/frame_buffers.h"

namespace vigil::vkpt {

class Post {
public:
    /// `buffers` outlive it.
    Post(const gpu::Device& device, gpu::PipelineCompiler& compiler, const FrameBuffers& buffers);

    /// Follows buffers of another size. The GPU must be idle.
    void bind();

    /// Fills the exposure's part of a frame's parameters, behind the filter's.
    void describe(FrameDescription& params, float exposure_speed);
    /// Has the pipelines made that record() will need for these sides; `view` is pt_view.
    void prepare(std::span<const PictureSide> sides, int view);
    /// Records the passes. Mean and exposure are the whole picture's.
    void record(gpu::FrameCommands& commands, std::span<const PictureSide> sides, int view,
                uint32_t paths);

private:
    void choose(const PictureSide& side, int view);

    const FrameBuffers& buffers_;
    float last_time_s_ = 0.0f;
    gpu::Buffer unused_;
    gpu::DescriptorSet upscale_set_;
    gpu::PipelineLayout upscale_layout_;
    ComputePass accumulate_, exposure_, tonemap_, upscale_;
};

} // namespace vigil::vkpt
