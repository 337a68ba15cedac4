// SPDX-License-Identifier: GPL-2.0-or-later
// The images of a window: made for the device's surface, remade when the window changes, acquired,
// filled by a blit from the finished picture and presented. Follows the Vulkan specification's
// chapter on window system integration. It records no render pass and knows no frame rate.
#pragma once

#include "refresh/vkpt/gpu/image.h"

#include <optional>
#include <vector>

namespace vigil::gpu {

/// What Swapchain::acquire hands out for one frame.
struct SwapchainTarget {
    uint32_t index = 0;
    VkImage image = VK_NULL_HANDLE;
    VkExtent2D extent{}; // of the window, in pixels
    VkSemaphore acquired =
        VK_NULL_HANDLE; // the frame's submit waits for it, at Swapchain::wait_stage
    VkSemaphore finished = VK_NULL_HANDLE; // the frame's submit signals it
};

/// One frame: FrameCommands::begin, acquire, blit, FrameCommands::submit(target.acquired,
/// Swapchain::wait_stage, target.finished), present. All on one thread.
class Swapchain {
public:
    static constexpr VkPipelineStageFlags wait_stage = VK_PIPELINE_STAGE_TRANSFER_BIT;

    /// `window` is the provider of `device`'s surface and outlives this object; `frames_in_flight`
    /// is the number of FrameCommands the caller rotates. Makes no images before the first acquire.
    Swapchain(const Device& device, const refresh::SurfaceProvider& window,
              uint32_t frames_in_flight);
    ~Swapchain(); // waits for the device
    Swapchain(const Swapchain&) = delete;
    Swapchain& operator=(const Swapchain&) = delete;

    /// The next image, or nothing when there is nothing to show this frame: the window is
    /// minimised, hidden, or changes faster than images can be made. Call it after the frame's
    /// FrameCommands::begin, which proves that an earlier frame's semaphore is free. With `vsync`
    /// frames wait for the display (FIFO); without, MAILBOX or else IMMEDIATE if offered. An image
    /// that was not presented (its frame failed before the submit) is handed out again.
    /// Throws Error when the surface or the device is lost.
    std::optional<SwapchainTarget> acquire(bool vsync);

    /// Records the copy of the whole `picture` (TRANSFER_SRC_OPTIMAL layout, all writes made
    /// visible to transfers) to `area` of the target, scaled with linear filtering; the rest of the
    /// target becomes black. `area` is clipped to the target; a clipped area still shows the whole
    /// picture.
    void blit(VkCommandBuffer commands, const SwapchainTarget& target, const Image& picture,
              VkRect2D area) const;
    /// The same to the whole target.
    void blit(VkCommandBuffer commands, const SwapchainTarget& target, const Image& picture) const;

    /// Queues the image for the display; call after the frame's submit.
    void present(const SwapchainTarget& target);

    VkFormat format() const { return format_; }
    VkPresentModeKHR present_mode() const { return present_mode_; }
    /// How often images were made; for tests.
    int generation() const { return generation_; }

private:
    enum class Acquired { Image, Nothing, OutOfDate };

    bool create(VkExtent2D window_size, bool vsync);
    void destroy();
    Acquired try_acquire();

    const Device* device_;
    const refresh::SurfaceProvider* window_;
    VkFormat format_ = VK_FORMAT_UNDEFINED;
    VkPresentModeKHR present_mode_ = VK_PRESENT_MODE_FIFO_KHR;
    Handle<VkSwapchainKHR> swapchain_;
    std::vector<VkImage> images_;               // owned by swapchain_
    std::vector<Handle<VkSemaphore>> finished_; // per image
    std::vector<Handle<VkSemaphore>> acquired_; // per frame in flight, used in turn
    size_t next_acquired_ = 0;
    std::optional<SwapchainTarget> pending_; // acquired, not presented
    VkExtent2D extent_{};                    // of the images
    VkExtent2D window_size_{};               // the window's size when they were made
    bool vsync_ = true;
    bool out_of_date_ = true;
    bool suboptimal_ = false; // remade once per size: some drivers never stop saying so
    bool remade_suboptimal_ = false;
    int generation_ = 0;
};

} // namespace vigil::gpu
