// SPDX-License-Identifier: GPL-2.0-or-later
// Console and menus over the finished picture: draws Dear ImGui's lists with imgui_impl_vulkan, the
// backend that comes with the library (1.86 or newer). The client owns the ImGui context, its fonts
// and its input; the only textures are those of the font atlas.
#pragma once

#include "refresh/vkpt/gpu/image.h"

#include <vector>

struct ImDrawData;
struct ImGuiContext;

namespace vigil::vkpt {

/// Make it when there is something to draw for the first time; a program without a console pays
/// nothing. One at a time per ImGui context. Destroy it before the context.
class Overlay {
public:
    /// Needs a current ImGui context, whose fonts it uploads; waits for the upload.
    /// `picture_format` is that of every picture drawn on; it must be renderable with blending.
    /// At most `frames_in_flight` frames with a draw() each are unfinished at any time.
    /// Throws Error.
    Overlay(const gpu::Device& device, VkFormat picture_format, uint32_t frames_in_flight);
    ~Overlay(); // waits for the device
    Overlay(const Overlay&) = delete;
    Overlay& operator=(const Overlay&) = delete;

    /// Records the drawing of `draw_data` over `picture`, which needs
    /// VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT and is in TRANSFER_SRC_OPTIMAL layout before and after;
    /// earlier writes to it and later reads of it need no further barrier. ImGui's display is
    /// stretched to the whole picture. Once per frame.
    void draw(VkCommandBuffer commands, const gpu::Image& picture, ImDrawData* draw_data);

private:
    explicit Overlay(const gpu::Device& device) : device_(&device) {}
    void start_imgui();
    void stop_imgui();
    gpu::Handle<VkFramebuffer> make_framebuffer(const gpu::Image& picture) const;

    const gpu::Device* device_;
    uint32_t frames_in_flight_ = 1;
    ImGuiContext* context_ = nullptr; // with which the backend was started
    gpu::Handle<VkRenderPass> render_pass_;
    gpu::Handle<VkDescriptorPool> descriptor_pool_;
    // One per frame in flight: pictures come and go with the window's size, and a framebuffer made
    // anew for each frame cannot outlive its picture's view unnoticed.
    std::vector<gpu::Handle<VkFramebuffer>> framebuffers_;
    size_t next_framebuffer_ = 0;
};

} // namespace vigil::vkpt
