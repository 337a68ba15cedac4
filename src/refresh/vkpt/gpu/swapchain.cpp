// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/gpu/swapchain.h"

#include "common/error.h"
#include "refresh/refresh.h"

#include <algorithm>
#include <array>

namespace vigil::gpu {

namespace {

// A hidden window may never get an image; a frame is then dropped so that input is still served.
constexpr uint64_t acquire_timeout_ns = 250'000'000;

Handle<VkSemaphore> make_semaphore(const Device& device, const char* name) {
    auto info = structure<VkSemaphoreCreateInfo>(VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO);
    return device.make(vkCreateSemaphore, vkDestroySemaphore, info, "vkCreateSemaphore",
                       VK_OBJECT_TYPE_SEMAPHORE, name);
}

/// The picture holds sRGB-encoded bytes, so the window's format must store them as they are.
VkSurfaceFormatKHR choose_format(const Device& device) {
    const auto offered = enumerate<VkSurfaceFormatKHR>("vkGetPhysicalDeviceSurfaceFormatsKHR",
                                                       vkGetPhysicalDeviceSurfaceFormatsKHR,
                                                       device.physical(), device.surface());
    for (const VkFormat wanted :
         {VK_FORMAT_B8G8R8A8_UNORM, VK_FORMAT_R8G8B8A8_UNORM, VK_FORMAT_A8B8G8R8_UNORM_PACK32}) {
        VkFormatProperties properties;
        vkGetPhysicalDeviceFormatProperties(device.physical(), wanted, &properties);
        if (!(properties.optimalTilingFeatures & VK_FORMAT_FEATURE_BLIT_DST_BIT)) continue;
        for (const VkSurfaceFormatKHR& format : offered) {
            // VK_FORMAT_UNDEFINED: the surface takes any format.
            const bool matches = format.format == wanted || format.format == VK_FORMAT_UNDEFINED;
            if (matches && format.colorSpace == VK_COLOR_SPACE_SRGB_NONLINEAR_KHR)
                return {wanted, format.colorSpace};
        }
    }
    fail("the window offers no 8-bit UNORM format. Use another vid_driver.");
}

VkPresentModeKHR choose_present_mode(const Device& device, bool vsync) {
    if (vsync) return VK_PRESENT_MODE_FIFO_KHR; // always offered
    const auto offered = enumerate<VkPresentModeKHR>("vkGetPhysicalDeviceSurfacePresentModesKHR",
                                                     vkGetPhysicalDeviceSurfacePresentModesKHR,
                                                     device.physical(), device.surface());
    for (const VkPresentModeKHR mode :
         {VK_PRESENT_MODE_MAILBOX_KHR, VK_PRESENT_MODE_IMMEDIATE_KHR}) {
        if (std::find(offered.begin(), offered.end(), mode) != offered.end()) return mode;
    }
    return VK_PRESENT_MODE_FIFO_KHR;
}

VkCompositeAlphaFlagBitsKHR choose_alpha(VkCompositeAlphaFlagsKHR offered) {
    for (const VkCompositeAlphaFlagBitsKHR alpha :
         {VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR, VK_COMPOSITE_ALPHA_INHERIT_BIT_KHR,
          VK_COMPOSITE_ALPHA_PRE_MULTIPLIED_BIT_KHR}) {
        if (offered & alpha) return alpha;
    }
    return VK_COMPOSITE_ALPHA_POST_MULTIPLIED_BIT_KHR;
}

/// Size in pixels, (0, 0) while nothing can be shown. Most systems dictate it; Wayland lets the
/// application choose (a current extent of all ones).
VkExtent2D choose_extent(const VkSurfaceCapabilitiesKHR& surface, VkExtent2D window) {
    if (surface.currentExtent.width != UINT32_MAX) return surface.currentExtent;
    if (window.width == 0 || window.height == 0) return {0, 0};
    return {
        std::clamp(window.width, surface.minImageExtent.width, surface.maxImageExtent.width),
        std::clamp(window.height, surface.minImageExtent.height, surface.maxImageExtent.height)};
}

bool operator==(VkExtent2D a, VkExtent2D b) {
    return a.width == b.width && a.height == b.height;
}

VkExtent2D size_of(const refresh::SurfaceProvider& window) {
    const glm::ivec2 size = window.framebuffer_size();
    return {static_cast<uint32_t>(std::max(size.x, 0)), static_cast<uint32_t>(std::max(size.y, 0))};
}

/// `area` without what lies outside of `target`.
VkRect2D clip(VkRect2D area, VkExtent2D target) {
    const auto clip_axis = [](int32_t& offset, uint32_t& length, uint32_t limit) {
        const int64_t end = std::clamp<int64_t>(int64_t{offset} + length, 0, limit);
        offset = static_cast<int32_t>(std::clamp<int64_t>(offset, 0, limit));
        length = static_cast<uint32_t>(std::max<int64_t>(end - offset, 0));
    };
    clip_axis(area.offset.x, area.extent.width, target.width);
    clip_axis(area.offset.y, area.extent.height, target.height);
    return area;
}

} // namespace

Swapchain::Swapchain(const Device& device, const refresh::SurfaceProvider& window,
                     uint32_t frames_in_flight)
    : device_(&device), window_(&window), acquired_(std::max(frames_in_flight, 1u)) {}

Swapchain::~Swapchain() {
    destroy();
}

void Swapchain::destroy() {
    // Also waits for the presentations that wait on finished_: they run on the same queue.
    vkDeviceWaitIdle(device_->handle());
    pending_.reset();
    finished_.clear();
    images_.clear();
    swapchain_.reset();
}

/// Makes new images; false when the window has no area now.
bool Swapchain::create(VkExtent2D window_size, bool vsync) {
    VkSurfaceCapabilitiesKHR surface;
    check(vkGetPhysicalDeviceSurfaceCapabilitiesKHR(device_->physical(), device_->surface(),
                                                    &surface),
          "vkGetPhysicalDeviceSurfaceCapabilitiesKHR");
    const VkExtent2D extent = choose_extent(surface, window_size);
    if (extent.width == 0 || extent.height == 0) return false;
    out_of_date_ = true; // until all of what follows has worked
    if (!(surface.supportedUsageFlags & VK_IMAGE_USAGE_TRANSFER_DST_BIT))
        fail("the window's images cannot be copied to. Use another vid_driver.");
    const VkSurfaceFormatKHR format = choose_format(*device_);
    const VkPresentModeKHR mode = choose_present_mode(*device_, vsync);

    auto info = structure<VkSwapchainCreateInfoKHR>(VK_STRUCTURE_TYPE_SWAPCHAIN_CREATE_INFO_KHR);
    info.surface = device_->surface();
    // One more than the driver holds back, so that acquiring need not wait for the display.
    info.minImageCount = surface.minImageCount + 1;
    if (surface.maxImageCount > 0)
        info.minImageCount = std::min(info.minImageCount, surface.maxImageCount);
    info.imageFormat = format.format;
    info.imageColorSpace = format.colorSpace;
    info.imageExtent = extent;
    info.imageArrayLayers = 1;
    info.imageUsage = VK_IMAGE_USAGE_TRANSFER_DST_BIT;
    info.imageSharingMode = VK_SHARING_MODE_EXCLUSIVE;
    info.preTransform = surface.currentTransform;
    info.compositeAlpha = choose_alpha(surface.supportedCompositeAlpha);
    info.presentMode = mode;
    info.clipped = VK_TRUE;
    info.oldSwapchain = swapchain_.get();
    VkSwapchainKHR created = VK_NULL_HANDLE;
    const VkResult result = vkCreateSwapchainKHR(device_->handle(), &info, nullptr, &created);
    // The old one is retired even if the new one could not be made.
    destroy();
    check(result, "vkCreateSwapchainKHR");
    swapchain_ = {device_->handle(), created, vkDestroySwapchainKHR};

    images_ = enumerate<VkImage>("vkGetSwapchainImagesKHR", vkGetSwapchainImagesKHR,
                                 device_->handle(), created);
    for (size_t i = 0; i < images_.size(); ++i)
        finished_.push_back(make_semaphore(*device_, "window image finished"));
    // An image acquired but never presented leaves its semaphore signalled: start afresh.
    for (Handle<VkSemaphore>& semaphore : acquired_)
        semaphore = make_semaphore(*device_, "window image acquired");

    remade_suboptimal_ = suboptimal_ && extent == extent_;
    suboptimal_ = false;
    out_of_date_ = false;
    format_ = format.format;
    present_mode_ = mode;
    extent_ = extent;
    window_size_ = window_size;
    vsync_ = vsync;
    ++generation_;
    return true;
}

Swapchain::Acquired Swapchain::try_acquire() {
    const VkSemaphore semaphore = acquired_[next_acquired_].get();
    uint32_t index = 0;
    const VkResult result = vkAcquireNextImageKHR(
        device_->handle(), swapchain_.get(), acquire_timeout_ns, semaphore, VK_NULL_HANDLE, &index);
    if (result == VK_TIMEOUT || result == VK_NOT_READY) return Acquired::Nothing;
    if (result == VK_ERROR_OUT_OF_DATE_KHR) return Acquired::OutOfDate;
    if (result != VK_SUBOPTIMAL_KHR) check(result, "vkAcquireNextImageKHR");
    if (result == VK_SUBOPTIMAL_KHR) suboptimal_ = true;
    next_acquired_ = (next_acquired_ + 1) % acquired_.size();
    pending_ = SwapchainTarget{index, images_[index], extent_, semaphore, finished_[index].get()};
    return Acquired::Image;
}

std::optional<SwapchainTarget> Swapchain::acquire(bool vsync) {
    if (pending_) return pending_;
    // A window that is being dragged can outrun its images; two attempts, then the next frame.
    for (int attempt = 0; attempt < 2; ++attempt) {
        const VkExtent2D size = size_of(*window_);
        if (size.width == 0 || size.height == 0) return std::nullopt;
        if (out_of_date_ || (suboptimal_ && !remade_suboptimal_) || vsync != vsync_ ||
            !(size == window_size_)) {
            if (!create(size, vsync)) return std::nullopt;
        }
        switch (try_acquire()) {
        case Acquired::Image:
            return pending_;
        case Acquired::Nothing:
            return std::nullopt;
        case Acquired::OutOfDate:
            out_of_date_ = true;
        }
    }
    return std::nullopt;
}

void Swapchain::blit(VkCommandBuffer commands, const SwapchainTarget& target, const Image& picture,
                     VkRect2D area) const {
    const ImageAccess unknown{wait_stage, 0, VK_IMAGE_LAYOUT_UNDEFINED};
    const ImageAccess written{VK_PIPELINE_STAGE_TRANSFER_BIT, VK_ACCESS_TRANSFER_WRITE_BIT,
                              VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL};
    const ImageAccess shown{VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT, 0,
                            VK_IMAGE_LAYOUT_PRESENT_SRC_KHR};
    transition(commands, target.image, unknown, written);

    area = clip(area, target.extent);
    if (!(area.extent == target.extent)) {
        const VkClearColorValue black{{0.0f, 0.0f, 0.0f, 1.0f}};
        const VkImageSubresourceRange range{VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
        vkCmdClearColorImage(commands, target.image, written.layout, &black, 1, &range);
        transition(commands, target.image, written, written);
    }
    if (area.extent.width > 0 && area.extent.height > 0) {
        const VkExtent2D size{picture.width(), picture.height()};
        VkImageBlit region{};
        region.srcSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
        region.srcOffsets[1] = {static_cast<int32_t>(size.width), static_cast<int32_t>(size.height),
                                1};
        region.dstSubresource = region.srcSubresource;
        region.dstOffsets[0] = {area.offset.x, area.offset.y, 0};
        region.dstOffsets[1] = {area.offset.x + static_cast<int32_t>(area.extent.width),
                                area.offset.y + static_cast<int32_t>(area.extent.height), 1};
        const VkFilter filter = size == area.extent ? VK_FILTER_NEAREST : VK_FILTER_LINEAR;
        vkCmdBlitImage(commands, picture.handle(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
                       target.image, written.layout, 1, &region, filter);
    }
    transition(commands, target.image, written, shown);
}

void Swapchain::blit(VkCommandBuffer commands, const SwapchainTarget& target,
                     const Image& picture) const {
    blit(commands, target, picture, {{0, 0}, target.extent});
}

void Swapchain::present(const SwapchainTarget& target) {
    const VkSwapchainKHR swapchain = swapchain_.get();
    auto info = structure<VkPresentInfoKHR>(VK_STRUCTURE_TYPE_PRESENT_INFO_KHR);
    info.waitSemaphoreCount = 1;
    info.pWaitSemaphores = &target.finished;
    info.swapchainCount = 1;
    info.pSwapchains = &swapchain;
    info.pImageIndices = &target.index;
    const VkResult result = vkQueuePresentKHR(device_->queue(), &info);
    pending_.reset();
    if (result == VK_ERROR_OUT_OF_DATE_KHR)
        out_of_date_ = true;
    else if (result == VK_SUBOPTIMAL_KHR)
        suboptimal_ = true;
    else
        check(result, "vkQueuePresentKHR");
}

} // namespace vigil::gpu
