// SPDX-License-Identifier: GPL-2.0-or-later
// A compute shader of the tests that runs on the renderer's scene: sets 0 to 2 as the path tracer
// bound them for the last frame, and buffers of its own in set 3.
#pragma once

#include "refresh/vkpt/gpu/commands.h"
#include "refresh/vkpt/gpu/pipeline.h"
#include "refresh/vkpt/renderer.h"

#include <string>
#include <string_view>
#include <vector>

namespace vigil::test {

/// Code of a shader of tests/vkpt; empty if there is none of that name.
std::span<const uint32_t> test_shader_code(std::string_view name);

class TestPass {
public:
    /// `name` as in test_shader_code; the scene's features are compiled in.
    TestPass(vkpt::VkptRenderer& renderer, const std::string& name);
    /// The same for scenes that have at most these features.
    TestPass(vkpt::VkptRenderer& renderer, const std::string& name,
             const vkpt::SceneFeatures& features);

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

    vkpt::VkptRenderer& renderer_;
    const gpu::Device& device_;
    std::string name_;
    vkpt::SceneFeatures features_;
    gpu::Buffer unused_;
    std::vector<gpu::Buffer> buffers_;
    gpu::DescriptorSet set_;
    gpu::Handle<VkPipelineLayout> layout_;
    gpu::ComputePipeline pipeline_; // made by the first run()
};

} // namespace vigil::test
