// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/gpu/buffer.h"

#include "common/error.h"

#include <algorithm>

namespace vigil::gpu {

namespace {

std::string size_text(uint64_t bytes) {
    if (bytes < 1024) return fmt::format("{} bytes", bytes);
    const double kib = static_cast<double>(bytes) / 1024.0;
    return kib < 1024.0 ? fmt::format("{:.1f} KiB", kib) : fmt::format("{:.1f} MiB", kib / 1024.0);
}

} // namespace

Buffer::Buffer(const Device& device, uint64_t bytes, MemoryUse use, const char* name,
               VkBufferUsageFlags extra_usage)
    : device_(&device), bytes_(std::max<uint64_t>(bytes, 16)) {
    if (use == MemoryUse::Device && bytes_ > device.features().max_storage_buffer_bytes)
        fail("{} needs {}, but this device's buffers end at {}", name, size_text(bytes_),
             size_text(device.features().max_storage_buffer_bytes));
    auto info = structure<VkBufferCreateInfo>(VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO);
    info.size = bytes_;
    info.usage = VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT | extra_usage;
    if (use == MemoryUse::Device)
        info.usage |= VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT;
    buffer_ = device.make(vkCreateBuffer, vkDestroyBuffer, info, "vkCreateBuffer",
                          VK_OBJECT_TYPE_BUFFER, name);

    VkMemoryRequirements needs;
    vkGetBufferMemoryRequirements(device.handle(), buffer_.get(), &needs);
    VkMemoryPropertyFlags wanted =
        VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
    VkMemoryPropertyFlags preferred = 0;
    if (use == MemoryUse::Device) wanted = VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT;
    if (use == MemoryUse::Readback) preferred = VK_MEMORY_PROPERTY_HOST_CACHED_BIT;
    auto flags = structure<VkMemoryAllocateFlagsInfo>(VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_FLAGS_INFO);
    flags.flags = VK_MEMORY_ALLOCATE_DEVICE_ADDRESS_BIT;
    auto allocate = structure<VkMemoryAllocateInfo>(VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO);
    if (extra_usage & VK_BUFFER_USAGE_SHADER_DEVICE_ADDRESS_BIT) allocate.pNext = &flags;
    allocate.allocationSize = needs.size;
    allocate.memoryTypeIndex = device.memory_type(needs.memoryTypeBits, wanted, preferred);
    VkDeviceMemory memory = VK_NULL_HANDLE;
    const VkResult result = vkAllocateMemory(device.handle(), &allocate, nullptr, &memory);
    if (result != VK_SUCCESS) fail("out of device memory: {} needs {}", name, size_text(bytes_));
    memory_ = {device.handle(), memory, vkFreeMemory};
    share_ = MemoryShare(device.usage(), name, needs.size);
    check(vkBindBufferMemory(device.handle(), buffer_.get(), memory, 0), "vkBindBufferMemory");
    if (use != MemoryUse::Device) {
        void* pointer = nullptr;
        check(vkMapMemory(device.handle(), memory, 0, VK_WHOLE_SIZE, 0, &pointer), "vkMapMemory");
        mapped_ = static_cast<std::byte*>(pointer);
    }
}

VkBufferView Buffer::texels(VkFormat format) const {
    const bool records = format == VK_FORMAT_R32G32B32A32_UINT;
    Handle<VkBufferView>& view = views_[records ? 1 : 0];
    if (view) return view.get();
    const uint64_t texel_bytes = records ? 16 : 4;
    const uint32_t limit = device_->properties().limits.maxTexelBufferElements;
    if (bytes_ / texel_bytes > limit)
        fail("{} need {}, but this device reads at most {} texels of {} bytes", name(),
             size_text(bytes_), limit, texel_bytes);
    auto info = structure<VkBufferViewCreateInfo>(VK_STRUCTURE_TYPE_BUFFER_VIEW_CREATE_INFO);
    info.buffer = buffer_.get();
    info.format = format;
    info.range = VK_WHOLE_SIZE;
    view = device_->make(vkCreateBufferView, vkDestroyBufferView, info, "vkCreateBufferView");
    return view.get();
}

bool grow(const Device& device, Buffer& buffer, uint64_t bytes, const char* name,
          VkBufferUsageFlags extra_usage) {
    if (buffer && buffer.bytes() >= bytes) return false;
    device.wait_idle();
    buffer = Buffer(device, std::max<uint64_t>(bytes + bytes / 2, 256), MemoryUse::Device, name,
                    extra_usage);
    return true;
}

} // namespace vigil::gpu
