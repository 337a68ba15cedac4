// SPDX-License-Identifier: GPL-2.0-or-later
// The light cuts of all PVS clusters on the GPU, as shaders/light/cut_lists.glsl reads them: those
// of the static world's lights, and after them those of lights that can move.
#pragma once

#include "refresh/vkpt/gpu/growing_buffer.h"
#include "refresh/vkpt/light/cluster_lists.h"
#include "refresh/vkpt/light/light_cuts.h"

namespace vigil::vkpt {

class ClusterCuts {
public:
    explicit ClusterCuts(const gpu::Device& device);

    /// Brings the cuts to this frame's lights and to the lists that are new; they have at most
    /// `size` entries. Returns true if a buffer was made anew.
    bool prepare(const ClusterLists& lists, ClusterLists::Changes changes, const LightSet& lights,
                 uint32_t size);
    void upload(gpu::FrameCommands& commands);
    /// Puts the buffers at the bindings of cut_lists.glsl.
    void bind(LightTechnique::Bindings& bindings) const;

private:
    LightCuts cuts_;
    gpu::GrowingBuffer clusters_, entries_, order_, places_, groups_;
    uint32_t size_ = 0; // most entries of a cut
    uint64_t revision_ = 0;
};

} // namespace vigil::vkpt
