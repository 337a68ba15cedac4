// SPDX-License-Identifier: GPL-2.0-or-later
// The light lists of all PVS clusters on the GPU, as shaders/light/light_list.glsl reads them.
#pragma once

#include "refresh/vkpt/gpu/growing_buffer.h"
#include "refresh/vkpt/light/cluster_lists.h"

namespace vigil::vkpt {

class ListBuffers {
public:
    explicit ListBuffers(const gpu::Device& device);

    /// Takes over the lists where they are new. Returns true if a buffer was made anew.
    bool prepare(const ClusterLists& lists, ClusterLists::Changes changes);
    void upload(gpu::FrameCommands& commands);
    /// Puts the buffers at the bindings of light_list.glsl.
    void bind(LightTechnique::Bindings& bindings) const;

private:
    gpu::GrowingBuffer still_ranges_, still_ids_, moving_ranges_, moving_ids_, counts_;
};

} // namespace vigil::vkpt
