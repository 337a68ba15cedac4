// SPDX-License-Identifier: GPL-2.0-or-later
// The node buffer seen as texels, for shaders compiled with TRACE_TEXEL=1: a view of format
// R32G32B32A32_UINT and its place in a descriptor set. Vulkan promises 65,536 texels (1 MiB, a
// level of 18,000 triangles); drivers in use offer millions.
#pragma once

#include "common/error.h"
#include "refresh/vkpt/gpu/buffer.h"

#include <glm/glm.hpp>

namespace vigil::vkpt {

class NodeView {
public:
    NodeView() = default;
    /// `nodes` was made with VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT and outlives the view. Throws
    /// Error when the device's texel buffers are too short for it.
    NodeView(const gpu::Device& device, const gpu::Buffer& nodes) : device_(&device) {
        const uint32_t limit = device.properties().limits.maxTexelBufferElements;
        if (nodes.bytes() / sizeof(glm::uvec4) > limit)
            fail("the level needs {} bytes of hierarchy; this device reads at most {} texels of 16",
                 nodes.bytes(), limit);
        VkBufferViewCreateInfo info{};
        info.sType = VK_STRUCTURE_TYPE_BUFFER_VIEW_CREATE_INFO;
        info.buffer = nodes.handle();
        info.format = VK_FORMAT_R32G32B32A32_UINT;
        info.range = VK_WHOLE_SIZE;
        VkBufferView view = VK_NULL_HANDLE;
        gpu::check(vkCreateBufferView(device.handle(), &info, nullptr, &view),
                   "vkCreateBufferView");
        view_ = {device.handle(), view, vkDestroyBufferView};
    }

    /// Points a binding of type VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER at the view; the GPU must
    /// not be using the set.
    void bind(VkDescriptorSet set, uint32_t binding) const {
        const VkBufferView view = view_.get();
        VkWriteDescriptorSet write{};
        write.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
        write.dstSet = set;
        write.dstBinding = binding;
        write.descriptorCount = 1;
        write.descriptorType = VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER;
        write.pTexelBufferView = &view;
        vkUpdateDescriptorSets(device_->handle(), 1, &write, 0, nullptr);
    }

private:
    const gpu::Device* device_ = nullptr;
    gpu::Handle<VkBufferView> view_;
};

} // namespace vigil::vkpt
