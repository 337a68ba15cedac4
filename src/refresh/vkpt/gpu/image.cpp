// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/gpu/image.h"

#include "common/error.h"

namespace vigil::gpu {

Image::Image(const Device& device, uint32_t width, uint32_t height, VkFormat format,
             VkImageUsageFlags usage, const char* name)
    : format_(format), width_(width), height_(height) {
    const uint32_t limit = device.properties().limits.maxImageDimension2D;
    if (width == 0 || height == 0 || width > limit || height > limit)
        fail("{}: {} x {} pixels is outside this device's 1 to {}", name, width, height, limit);
    auto info = structure<VkImageCreateInfo>(VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO);
    info.imageType = VK_IMAGE_TYPE_2D;
    info.format = format;
    info.extent = {width, height, 1};
    info.mipLevels = 1;
    info.arrayLayers = 1;
    info.samples = VK_SAMPLE_COUNT_1_BIT;
    info.tiling = VK_IMAGE_TILING_OPTIMAL;
    info.usage = usage;
    image_ = device.make(vkCreateImage, vkDestroyImage, info, "vkCreateImage", VK_OBJECT_TYPE_IMAGE,
                         name);

    VkMemoryRequirements needs;
    vkGetImageMemoryRequirements(device.handle(), image_.get(), &needs);
    auto allocate = structure<VkMemoryAllocateInfo>(VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO);
    allocate.allocationSize = needs.size;
    allocate.memoryTypeIndex =
        device.memory_type(needs.memoryTypeBits, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
    memory_ = device.make(vkAllocateMemory, vkFreeMemory, allocate, "vkAllocateMemory");
    share_ = MemoryShare(device.usage(), name, needs.size);
    check(vkBindImageMemory(device.handle(), image_.get(), memory_.get(), 0), "vkBindImageMemory");

    auto view_info = structure<VkImageViewCreateInfo>(VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO);
    view_info.image = image_.get();
    view_info.viewType = VK_IMAGE_VIEW_TYPE_2D;
    view_info.format = format;
    view_info.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    view_ = device.make(vkCreateImageView, vkDestroyImageView, view_info, "vkCreateImageView");
}

void transition(VkCommandBuffer commands, VkImage image, ImageAccess from, ImageAccess to) {
    auto barrier = structure<VkImageMemoryBarrier>(VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER);
    barrier.srcAccessMask = from.kinds;
    barrier.dstAccessMask = to.kinds;
    barrier.oldLayout = from.layout;
    barrier.newLayout = to.layout;
    barrier.srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.image = image;
    barrier.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    vkCmdPipelineBarrier(commands, from.stages, to.stages, 0, 0, nullptr, 0, nullptr, 1, &barrier);
}

void transition(VkCommandBuffer commands, VkImage image, VkImageLayout from, VkImageLayout to) {
    constexpr VkPipelineStageFlags all = VK_PIPELINE_STAGE_ALL_COMMANDS_BIT;
    transition(commands, image, {all, VK_ACCESS_MEMORY_WRITE_BIT, from},
               {all, VK_ACCESS_MEMORY_READ_BIT | VK_ACCESS_MEMORY_WRITE_BIT, to});
}

} // namespace vigil::gpu
