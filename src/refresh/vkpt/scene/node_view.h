// SPDX-License-Identifier: GPL-2.0-or-later
// The node buffer seen as texels, for shaders compiled with TRACE_TEXEL=1: a view of format
// R32G32B32A32_UINT and its place in a descriptor set. Devices whose texel buffers are too short
// for a level keep the storage buffer.
#pragma once

#include "refresh/vkpt/gpu/buffer.h"

namespace vigil::vkpt {

class NodeView {
public:
    NodeView() = default;
    /// `nodes` was made with VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT and is as long as `fits`
    /// allows.
    NodeView(const gpu::Device& device, const gpu::Buffer& nodes) : device_(&device) {
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

    /// Whether a view of that many bytes is possible (every device offers 65,536 texels of 16
    /// bytes, most offer millions).
    static bool fits(const gpu::Device& device, uint64_t bytes) {
        return bytes / 16 <= device.properties().limits.maxTexelBufferElements;
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
