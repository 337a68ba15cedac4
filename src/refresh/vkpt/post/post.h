// SPDX-License-Identifier: GPL-2.0-or-later
// From a frame's radiance to the finished 8-bit picture: the running mean, the exposure, and tone
// mapping, in which debug views (pt_view) take the picture's place.
#pragma once

#include "refresh/vkpt/pathtrace/frame_buffers.h"

namespace vigil::vkpt {

class Post {
public:
    /// `buffers` outlive it.
    Post(gpu::PipelineCompiler& compiler, const FrameBuffers& buffers)
        : buffers_(buffers), accumulate_(Pass::Accumulate, compiler, buffers.layout()),
          exposure_(Pass::Exposure, compiler, buffers.layout()),
          tonemap_(Pass::Tonemap, compiler, buffers.layout()) {}

    /// Has the pipelines made that record() will need for these sides; `view` is pt_view.
    void prepare(std::span<const PictureSide> sides, int view);
    /// Records the passes. Mean and exposure are the whole picture's.
    void record(gpu::FrameCommands& commands, std::span<const PictureSide> sides, int view,
                uint32_t paths);

private:
    void choose(const PictureSide& side, int view);

    const FrameBuffers& buffers_;
    ComputePass accumulate_, exposure_, tonemap_;
};

} // namespace vigil::vkpt
