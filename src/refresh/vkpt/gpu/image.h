// SPDX-License-Identifier: GPL-2.0-or-later
// A two-dimensional colour image with its view and memory: the finished picture, on which the
// overlay is drawn.
#pragma once

#include "refresh/vkpt/gpu/device.h"

namespace vigil::gpu {

class Image {
public:
    Image() = default;
    Image(const Device& device, uint32_t width, uint32_t height, VkFormat format,
          VkImageUsageFlags usage, const char* name);

    VkImage handle() const { return image_.get(); }
    VkImageView view() const { return view_.get(); }
    VkFormat format() const { return format_; }
    uint32_t width() const { return width_; }
    uint32_t height() const { return height_; }

private:
    MemoryShare share_;
    Handle<VkDeviceMemory> memory_;
    Handle<VkImage> image_;
    Handle<VkImageView> view_;
    VkFormat format_ = VK_FORMAT_UNDEFINED;
    uint32_t width_ = 0;
    uint32_t height_ = 0;
};

/// What touches an image, how, and in which layout.
struct ImageAccess {
    VkPipelineStageFlags stages;
    VkAccessFlags kinds;
    VkImageLayout layout;
};
/// Records a layout transition of a whole colour image.
void transition(VkCommandBuffer commands, VkImage image, ImageAccess from, ImageAccess to);
/// The same with a full memory barrier.
void transition(VkCommandBuffer commands, VkImage image, VkImageLayout from, VkImageLayout to);

} // namespace vigil::gpu
