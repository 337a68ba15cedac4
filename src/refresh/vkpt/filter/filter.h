// SPDX-License-Identifier: GPL-2.0-or-later
// From a frame's noisy light to a calm picture: what frames before saw of the same surfaces, then
// what neighbouring pixels see (shaders/filter; docs/internals/filter.md). It owns what is kept per
// pixel for that, and exists on the GPU only while it is on.
#pragma once

#include "refresh/vkpt/gpu/growing_buffer.h"
#include "refresh/vkpt/light/light_changes.h"
#include "refresh/vkpt/pathtrace/frame_buffers.h"

#include <optional>

namespace vigil::vkpt {

class Filter {
public:
    /// `buffers` outlive it.
    Filter(const gpu::Device& device, gpu::PipelineCompiler& compiler, FrameBuffers& buffers);

    /// Whether a frame with these settings is filtered.
    static bool wanted(const refresh::Settings& settings);
    /// Makes what a filtered frame needs, or gives it back. Returns whether `buffers` are to be
    /// bound anew. Where memory does not suffice it says so once, and frames stay as they are
    /// traced.
    bool prepare(const refresh::Settings& settings, const LightSet& lights);
    /// Has the pipelines made that record() will need.
    void prepare_pipelines();
    /// The next frame has no past.
    void forget();
    /// Fills the filter's part of a frame's parameters, and takes its camera for the past of the
    /// next.
    void describe(FrameDescription& params);
    /// Records the passes, if the frame that was described last is filtered.
    void record(gpu::FrameCommands& commands, std::span<const PictureSide> sides, uint32_t paths);

    bool on() const { return on_; }
    /// Which pixels of filtered sides trace indirect light in the frame that was described last
    /// (shared/indirect_turn.h): all, unless pt_indirect_rate says half of them.
    uint32_t indirect_turn() const { return indirect_turn_; }
    /// Bytes that it takes on the GPU.
    uint64_t bytes() const;

private:
    struct Kept { // by pixel
        gpu::Buffer surfaces, history, statistics, light, resolved, tiles;
    };
    Kept make_buffers() const;
    bool follow(const refresh::Settings& settings);

    const gpu::Device& device_;
    FrameBuffers& buffers_;
    gpu::Buffer unused_;
    Kept kept_;
    gpu::DescriptorSet set_;
    gpu::PipelineLayout layout_;
    gpu::GrowingBuffer light_changes_;
    ComputePass tiles_, temporal_, atrous_, compose_, taa_pass_;
    LightChanges changes_;
    bool changed_ = false;  // a lamp, in the frame that was prepared last
    glm::uvec2 size_{0, 0}; // that the buffers are for, at most
    int steps_ = 0;         // over neighbours
    bool on_ = false;
    bool taa_ = false;
    bool jitters_ = false;                  // then, camera rays move within the pixel
    std::optional<glm::uvec2> failed_size_; // that memory did not suffice for
    bool halves_indirect_ = false;
    uint32_t indirect_turn_ = shader::INDIRECT_ALL;
    bool has_past_ = false;
    uint32_t frame_ = 0;      // counts filtered frames
    FrameDescription last_{}; // of the frame before
};

} // namespace vigil::vkpt
