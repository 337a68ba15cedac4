// SPDX-License-Identifier: GPL-2.0-or-later
// The pass behind pt_view cdq: radiance that arrives at the crosshair, by direction
// (shaders/debug/direction_map.comp). It belongs to none of the frame's paths, so that octree and
// caches do not learn from a view.
#pragma once

#include "refresh/vkpt/pathtrace/frame_buffers.h"

namespace vigil::vkpt {

class DirectionMap {
public:
    /// `buffers` outlive it.
    DirectionMap(gpu::PipelineCompiler& compiler, const FrameBuffers& buffers)
        : buffers_(buffers), pass_(Pass::DirectionMap, compiler, buffers.layout()) {}

    /// Has the pipeline made that record() will need.
    void prepare(std::span<const PictureSide> sides);
    /// Records the pass for the side that the crosshair looks at; behind the frame's `paths` paths.
    void record(gpu::FrameCommands& commands, std::span<const PictureSide> sides, uint32_t paths);

private:
    const FrameBuffers& buffers_;
    ComputePass pass_;
};

} // namespace vigil::vkpt
