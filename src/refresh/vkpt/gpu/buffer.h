// SPDX-License-Identifier: GPL-2.0-or-later
// A VkBuffer with its own memory. growing_buffer.h has one whose size follows its contents.
#pragma once

#include "refresh/vkpt/gpu/device.h"

#include <array>
#include <cstddef>
#include <span>

namespace vigil::gpu {

enum class MemoryUse {
    Device,   // fast for the GPU; filled by copies
    Upload,   // written by the host, read once by the GPU
    Readback, // written by the GPU, read by the host
};

class Buffer {
public:
    Buffer() = default;
    /// `bytes` is raised to at least 16, so that an empty list is still a valid binding. Throws
    /// Error when memory is out or the size exceeds the device's largest storage buffer; `name`
    /// appears in the message.
    Buffer(const Device& device, uint64_t bytes, MemoryUse use, const char* name,
           VkBufferUsageFlags extra_usage = 0);

    VkBuffer handle() const { return buffer_.get(); }
    uint64_t bytes() const { return bytes_; }
    /// That it was made with; nothing without a buffer.
    const std::string& name() const { return share_.name(); }
    explicit operator bool() const { return static_cast<bool>(buffer_); }

    /// A buffer of MemoryUse::Device as texels of `format`, R32_UINT or R32G32B32A32_UINT: shaders
    /// read them through the texture path. It lives as long as the buffer. Vulkan promises 65,536
    /// texels, drivers in use offer millions. Throws Error with the buffer's name when the device's
    /// texel buffers are too short for it.
    VkBufferView texels(VkFormat format) const;

    /// Host pointer; null for MemoryUse::Device.
    std::byte* mapped() const { return mapped_; }
    template <typename T> std::span<T> mapped_as() const {
        return {reinterpret_cast<T*>(mapped_), static_cast<size_t>(bytes_ / sizeof(T))};
    }

private:
    MemoryShare share_;
    Handle<VkDeviceMemory> memory_; // freed after buffer_ (declared before it)
    Handle<VkBuffer> buffer_;
    mutable std::array<Handle<VkBufferView>, 2>
        views_; // of words and of records, made when asked for
    const Device* device_ = nullptr;
    uint64_t bytes_ = 0;
    std::byte* mapped_ = nullptr;
};

/// Makes `buffer` anew, with half as much to spare, where it has not `bytes`; waits until the
/// device is idle then, and returns true.
bool grow(const Device& device, Buffer& buffer, uint64_t bytes, const char* name,
          VkBufferUsageFlags extra_usage = 0);

/// Views any contiguous range of trivially copyable values as bytes.
template <typename Range> std::span<const std::byte> bytes_of(const Range& range) {
    return std::as_bytes(std::span(range));
}
template <typename T> std::span<const std::byte> bytes_of_value(const T& value) {
    return std::as_bytes(std::span(&value, 1));
}

} // namespace vigil::gpu
