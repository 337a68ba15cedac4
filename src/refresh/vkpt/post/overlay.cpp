// SPDX-License-Identifier: GPL-2.0-or-later
#include "refresh/vkpt/post/overlay.h"

#include "common/error.h"
#include "refresh/vkpt/gpu/commands.h"

#include <algorithm>
#include <backends/imgui_impl_vulkan.h>
#include <imgui.h>

namespace vigil::vkpt {

namespace {

void check_imgui(VkResult result) {
    gpu::check(result, "overlay (imgui_impl_vulkan)");
}

/// Keeps what the picture holds and draws over it.
gpu::Handle<VkRenderPass> make_render_pass(const gpu::Device& device, VkFormat format) {
    VkAttachmentDescription picture{};
    picture.format = format;
    picture.samples = VK_SAMPLE_COUNT_1_BIT;
    picture.loadOp = VK_ATTACHMENT_LOAD_OP_LOAD;
    picture.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
    picture.stencilLoadOp = VK_ATTACHMENT_LOAD_OP_DONT_CARE;
    picture.stencilStoreOp = VK_ATTACHMENT_STORE_OP_DONT_CARE;
    picture.initialLayout = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
    picture.finalLayout = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
    const VkAttachmentReference reference{0, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};
    VkSubpassDescription subpass{};
    subpass.pipelineBindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS;
    subpass.colorAttachmentCount = 1;
    subpass.pColorAttachments = &reference;

    // After whatever wrote the picture, before whatever reads it.
    VkSubpassDependency before{};
    before.srcSubpass = VK_SUBPASS_EXTERNAL;
    before.dstSubpass = 0;
    before.srcStageMask = VK_PIPELINE_STAGE_ALL_COMMANDS_BIT;
    before.srcAccessMask = VK_ACCESS_MEMORY_WRITE_BIT;
    before.dstStageMask = VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT;
    before.dstAccessMask =
        VK_ACCESS_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT;
    VkSubpassDependency after{};
    after.srcSubpass = 0;
    after.dstSubpass = VK_SUBPASS_EXTERNAL;
    after.srcStageMask = VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT;
    after.srcAccessMask = VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT;
    after.dstStageMask = VK_PIPELINE_STAGE_ALL_COMMANDS_BIT;
    after.dstAccessMask = VK_ACCESS_MEMORY_READ_BIT | VK_ACCESS_MEMORY_WRITE_BIT;
    const VkSubpassDependency dependencies[] = {before, after};

    auto info = gpu::structure<VkRenderPassCreateInfo>(VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO);
    info.attachmentCount = 1;
    info.pAttachments = &picture;
    info.subpassCount = 1;
    info.pSubpasses = &subpass;
    info.dependencyCount = 2;
    info.pDependencies = dependencies;
    return device.make(vkCreateRenderPass, vkDestroyRenderPass, info, "vkCreateRenderPass",
                       VK_OBJECT_TYPE_RENDER_PASS, "overlay");
}

// From 1.92 on the lists say which textures they need, and the backend makes and replaces them
// while it draws. Before that there is one, the font atlas, and we upload it.
#if IMGUI_VERSION_NUM >= 19200
constexpr uint32_t most_textures = IMGUI_IMPL_VULKAN_MINIMUM_IMAGE_SAMPLER_POOL_SIZE;
#else
constexpr uint32_t most_textures = 1;
#endif

gpu::Handle<VkDescriptorPool> make_descriptor_pool(const gpu::Device& device) {
    const VkDescriptorPoolSize size{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, most_textures};
    auto info =
        gpu::structure<VkDescriptorPoolCreateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO);
    info.flags = VK_DESCRIPTOR_POOL_CREATE_FREE_DESCRIPTOR_SET_BIT;
    info.maxSets = most_textures;
    info.poolSizeCount = 1;
    info.pPoolSizes = &size;
    return device.make(vkCreateDescriptorPool, vkDestroyDescriptorPool, info,
                       "vkCreateDescriptorPool");
}

void upload_fonts([[maybe_unused]] const gpu::Device& device) {
#if IMGUI_VERSION_NUM >= 19200
    ImGui::GetIO().BackendFlags |= ImGuiBackendFlags_RendererHasTextures;
#elif IMGUI_VERSION_NUM >= 19000
    ImGui_ImplVulkan_CreateFontsTexture(); // submits and waits by itself
#else
    gpu::run_now(device,
                 [](VkCommandBuffer commands) { ImGui_ImplVulkan_CreateFontsTexture(commands); });
    ImGui_ImplVulkan_DestroyFontUploadObjects();
#endif
}

/// Says for which render pass the backend's pipeline is.
bool init_backend(ImGui_ImplVulkan_InitInfo& info, VkRenderPass render_pass) {
#if IMGUI_VERSION_NUM >= 19240
    info.PipelineInfoMain.RenderPass = render_pass;
    info.PipelineInfoMain.MSAASamples = VK_SAMPLE_COUNT_1_BIT;
    return ImGui_ImplVulkan_Init(&info);
#else
    info.MSAASamples = VK_SAMPLE_COUNT_1_BIT;
#if IMGUI_VERSION_NUM >= 19030
    info.RenderPass = render_pass;
    return ImGui_ImplVulkan_Init(&info);
#else
    return ImGui_ImplVulkan_Init(&info, render_pass);
#endif
#endif
}

/// Whether the font atlas that is current now was uploaded.
bool has_fonts() {
#if IMGUI_VERSION_NUM >= 19200
    return true; // the backend sees to it
#else
    return ImGui::GetIO().Fonts->TexID != ImTextureID{};
#endif
}

void forget_fonts() {
#if IMGUI_VERSION_NUM >= 19200
    // The backend is gone, its successor will make them again: the client need not know.
    ImGui::GetIO().BackendFlags |= ImGuiBackendFlags_RendererHasTextures;
#else
    ImGui::GetIO().Fonts->SetTexID(ImTextureID{});
#endif
}

/// Lists built before the atlas was uploaded name no texture; there is only one they can mean.
void name_fonts([[maybe_unused]] ImDrawData& draw_data) {
#if IMGUI_VERSION_NUM < 19200
    for (int list = 0; list < draw_data.CmdListsCount; ++list) {
        for (ImDrawCmd& command : draw_data.CmdLists[list]->CmdBuffer) {
            if (!command.TextureId) command.TextureId = ImGui::GetIO().Fonts->TexID;
        }
    }
#endif
}

} // namespace

Overlay::Overlay(const gpu::Device& device, VkFormat picture_format, uint32_t frames_in_flight)
    : Overlay(device) { // so that the destructor stops what was started before a fault
    frames_in_flight_ = std::max(frames_in_flight, 1u);
    framebuffers_.resize(frames_in_flight_);
    render_pass_ = make_render_pass(device, picture_format);
    if (!ImGui::GetCurrentContext()) fail("overlay: there is no ImGui context");
    start_imgui();
}

Overlay::~Overlay() {
    vkDeviceWaitIdle(device_->handle());
    stop_imgui();
}

void Overlay::start_imgui() {
    context_ = ImGui::GetCurrentContext();
    descriptor_pool_ = make_descriptor_pool(*device_);
    ImGui_ImplVulkan_InitInfo info{};
    info.Instance = device_->instance();
    info.PhysicalDevice = device_->physical();
    info.Device = device_->handle();
    info.QueueFamily = device_->queue_family();
    info.Queue = device_->queue();
    info.DescriptorPool = descriptor_pool_.get();
    info.MinImageCount = 2;                            // the least that imgui accepts
    info.ImageCount = std::max(frames_in_flight_, 2u); // how many vertex buffers it rotates
    info.CheckVkResultFn = check_imgui;
    init_backend(info, render_pass_.get());
    upload_fonts(*device_);
}

void Overlay::stop_imgui() {
    if (!context_) return;
    ImGuiContext* const current = ImGui::GetCurrentContext();
    ImGui::SetCurrentContext(context_);
    if (ImGui::GetIO().BackendRendererUserData) ImGui_ImplVulkan_Shutdown();
    forget_fonts();
    ImGui::SetCurrentContext(current);
    context_ = nullptr;
}

gpu::Handle<VkFramebuffer> Overlay::make_framebuffer(const gpu::Image& picture) const {
    const VkImageView view = picture.view();
    auto info = gpu::structure<VkFramebufferCreateInfo>(VK_STRUCTURE_TYPE_FRAMEBUFFER_CREATE_INFO);
    info.renderPass = render_pass_.get();
    info.attachmentCount = 1;
    info.pAttachments = &view;
    info.width = picture.width();
    info.height = picture.height();
    info.layers = 1;
    return device_->make(vkCreateFramebuffer, vkDestroyFramebuffer, info, "vkCreateFramebuffer");
}

void Overlay::draw(VkCommandBuffer commands, const gpu::Image& picture, ImDrawData* draw_data) {
    if (draw_data->TotalVtxCount == 0) return;
    const ImVec2 display = draw_data->DisplaySize;
    if (display.x <= 0.0f || display.y <= 0.0f) return;

    // A client that rebuilt its fonts (another size of screen) has reset the texture's id.
    if (!has_fonts()) {
        device_->wait_idle();
        stop_imgui();
        start_imgui();
    }
    name_fonts(*draw_data);

    const VkExtent2D extent{picture.width(), picture.height()};
    draw_data->FramebufferScale = ImVec2(static_cast<float>(extent.width) / display.x,
                                         static_cast<float>(extent.height) / display.y);
    gpu::Handle<VkFramebuffer>& framebuffer = framebuffers_[next_framebuffer_];
    next_framebuffer_ = (next_framebuffer_ + 1) % framebuffers_.size();
    framebuffer = make_framebuffer(picture);

    auto begin = gpu::structure<VkRenderPassBeginInfo>(VK_STRUCTURE_TYPE_RENDER_PASS_BEGIN_INFO);
    begin.renderPass = render_pass_.get();
    begin.framebuffer = framebuffer.get();
    begin.renderArea = {{0, 0}, extent};
    vkCmdBeginRenderPass(commands, &begin, VK_SUBPASS_CONTENTS_INLINE);
    ImGui_ImplVulkan_RenderDrawData(draw_data, commands);
    vkCmdEndRenderPass(commands);
}

} // namespace vigil::vkpt
