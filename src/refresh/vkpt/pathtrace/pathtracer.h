// SPDX-License-Identifier: GPL-2.0-or-later
// The estimator of one path per pixel, in three passes: camera rays, next event estimation where
// they land, and indirect rays (docs/internals/frame.md, "The path").
#pragma once

#include "refresh/vkpt/pathtrace/frame_buffers.h"

namespace vigil::vkpt {

class PathTracer {
public:
    /// `buffers` outlive it.
    PathTracer(gpu::PipelineCompiler& compiler, const FrameBuffers& buffers)
        : buffers_(buffers), primary_(Pass::Primary, compiler, buffers.layout()),
          direct_(Pass::Direct, compiler, buffers.layout()),
          indirect_(Pass::Indirect, compiler, buffers.layout()) {}

    /// Has the pipelines made that record() will need for these sides.
    void prepare(std::span<const PictureSide> sides);
    /// Records `paths` paths per pixel. Camera rays are the whole picture's; the features of all
    /// sides are the same.
    void record(gpu::FrameCommands& commands, std::span<const PictureSide> sides, uint32_t paths);

private:
    void choose(const PictureSide& side);

    const FrameBuffers& buffers_;
    ComputePass primary_, direct_, indirect_;
};

} // namespace vigil::vkpt
