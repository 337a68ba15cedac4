// SPDX-License-Identifier: GPL-2.0-or-later
// A compute shader beside the path tracer's own, for measurements and tests: sets 0 to 2 as they
// were bound for the last frame, and buffers of its own in set 3.
#pragma once

#include "refresh/vkpt/gpu/commands.h"
#include "refresh/vkpt/gpu/pipeline.h"
#include "refresh/vkpt/renderer.h"

#include <string>
#include <vector>

namespace vigil::vkpt {

class SidePass {
public:
    /// `code` must outlive it; `name` is for labels. It is compiled for scenes that have at most
    /// these features.
    SidePass(VkptRenderer& renderer, std::span<const uint32_t> code, std::string name,
             const SceneFeatures& features);

    /// Makes a buffer of set 3, holding these bytes or zeros; call in the order of the bindings.
    void add_buffer(std::span<const std::byte> bytes);
    void add_buffer(size_t bytes);
    /// Forgets the buffers, so that others can be added in their places: as many as before.
    void clear_buffers() { buffers_.clear(); }

    /// Runs `groups` work groups with two push constants and waits.
    void run(glm::uvec3 groups, glm::uvec2 push);

    template <typename T> std::vector<T> read(size_t binding, size_t count) const {
        return gpu::download_now_as<T>(device_, buffers_[binding], 0, count);
    }

private:
    void make_pipeline();

    VkptRenderer& renderer_;
    const gpu::Device& device_;
    std::span<const uint32_t> code_;
    std::string name_;
    SceneFeatures features_;
    gpu::Buffer unused_;
    std::vector<gpu::Buffer> buffers_;
    gpu::DescriptorSet set_;
    gpu::PipelineLayout layout_;
    gpu::ComputePipeline pipeline_; // made by the first run()
};

} // namespace vigil::vkpt
