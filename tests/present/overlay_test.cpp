// SPDX-License-Identifier: GPL-2.0-or-later
// The overlay on a device with core and synchronisation validation: what it draws lands where ImGui
// put it, the rest of the picture stays, and nothing is reported, over changing picture sizes and
// rebuilt fonts. The look of widgets is ImGui's own business.
#include "refresh/vkpt/post/overlay.h"

#include "gpu/validated.h"
#include "refresh/vkpt/gpu/commands.h"
#include "validation_text.h"

#include <array>
#include <gtest/gtest.h>
#include <imgui.h>
#include <optional>

namespace vigil::vkpt {
namespace {

constexpr uint32_t frames_in_flight = 2;
constexpr VkFormat format = VK_FORMAT_R8G8B8A8_UNORM;
using Pixel = std::array<uint8_t, 4>;
constexpr Pixel background{10, 20, 30, 255};

/// A current ImGui context with the default font, for the lifetime of a test.
class Context {
public:
    Context() {
        ImGui::CreateContext();
        ImGui::GetIO().IniFilename = nullptr;
        build_fonts(13.0f);
    }
    ~Context() { ImGui::DestroyContext(); }
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    static void build_fonts(float size) {
        ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
        fonts.Clear();
        ImFontConfig config;
        config.SizePixels = size;
        fonts.AddFontDefault(&config);
#if IMGUI_VERSION_NUM >= 19200
        ImGui::GetIO().BackendFlags |= ImGuiBackendFlags_RendererHasTextures;
#else
        fonts.Build();
#endif
    }

    /// One frame that covers the left half of a `width` x `height` display with pure red.
    static ImDrawData* red_half(float width, float height) {
        ImGui::GetIO().DisplaySize = ImVec2(width, height);
        ImGui::GetIO().DeltaTime = 1.0f / 60.0f;
        ImGui::NewFrame();
        ImGui::GetForegroundDrawList()->AddRectFilled(ImVec2(0, 0), ImVec2(width / 2, height),
                                                      IM_COL32(255, 0, 0, 255));
        ImGui::GetForegroundDrawList()->AddText(ImVec2(2, 2), IM_COL32(255, 255, 255, 255),
                                                "Vigil");
        ImGui::Render();
        return ImGui::GetDrawData();
    }
};

class OverlayTest : public testing::Test {
protected:
    OverlayTest() {
        device_.emplace(test::validated(), nullptr);
        for (uint32_t i = 0; i < frames_in_flight; ++i)
            frames_.emplace_back(*device_);
    }
    ~OverlayTest() override { device_->wait_idle(); }

    gpu::Image make_picture(uint32_t width, uint32_t height) const {
        return {*device_,
                width,
                height,
                format,
                VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT |
                    VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT,
                "picture"};
    }

    /// Fills `picture` with the background and leaves it as a finished picture is.
    static void fill(VkCommandBuffer commands, const gpu::Image& picture) {
        gpu::transition(commands, picture.handle(), VK_IMAGE_LAYOUT_UNDEFINED,
                        VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
        const VkClearColorValue color{{10.0f / 255.0f, 20.0f / 255.0f, 30.0f / 255.0f, 1.0f}};
        const VkImageSubresourceRange range{VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
        vkCmdClearColorImage(commands, picture.handle(), VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                             &color, 1, &range);
        gpu::transition(commands, picture.handle(), VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                        VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
    }

    /// Draws `data` over a filled picture and returns the pixels.
    std::vector<Pixel> draw(Overlay& overlay, const gpu::Image& picture, ImDrawData* data) {
        gpu::FrameCommands& frame = frames_[next_++ % frames_in_flight];
        frame.begin();
        fill(frame.commands(), picture);
        overlay.draw(frame.commands(), picture, data);
        const size_t count = size_t{picture.width()} * picture.height();
        const gpu::Buffer pixels(*device_, count * sizeof(Pixel), gpu::MemoryUse::Readback,
                                 "pixels");
        VkBufferImageCopy region{};
        region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
        region.imageExtent = {picture.width(), picture.height(), 1};
        vkCmdCopyImageToBuffer(frame.commands(), picture.handle(),
                               VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, pixels.handle(), 1, &region);
        VkMemoryBarrier to_host{};
        to_host.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER;
        to_host.srcAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT;
        to_host.dstAccessMask = VK_ACCESS_HOST_READ_BIT;
        vkCmdPipelineBarrier(frame.commands(), VK_PIPELINE_STAGE_TRANSFER_BIT,
                             VK_PIPELINE_STAGE_HOST_BIT, 0, 1, &to_host, 0, nullptr, 0, nullptr);
        frame.submit(VK_NULL_HANDLE, 0, VK_NULL_HANDLE);
        frame.finish();
        const std::span<Pixel> mapped = pixels.mapped_as<Pixel>();
        return {mapped.begin(), mapped.begin() + static_cast<ptrdiff_t>(count)};
    }

    ValidationText messages_;
    Context context_; // outlives the overlays
    std::optional<gpu::Device> device_;
    std::vector<gpu::FrameCommands> frames_;
    size_t next_ = 0;
};

/// The left half below the text is red, the right half is untouched.
void expect_red_half(const std::vector<Pixel>& pixels, uint32_t width, uint32_t height) {
    const Pixel red{255, 0, 0, 255};
    size_t wrong = 0;
    for (uint32_t y = height / 2; y < height; ++y) {
        for (uint32_t x = 0; x < width; ++x)
            wrong += pixels[size_t{y} * width + x] != (x < width / 2 ? red : background);
    }
    EXPECT_EQ(wrong, 0u);
}

TEST_F(OverlayTest, DrawsOverThePictureAndKeepsTheRest) {
    // The lists are built before the overlay exists, as on the first frame with a console.
    ImDrawData* const data = Context::red_half(128, 64);
    Overlay overlay(*device_, format, frames_in_flight);
    const gpu::Image picture = make_picture(128, 64);
    const std::vector<Pixel> pixels = draw(overlay, picture, data);
    expect_red_half(pixels, 128, 64);
    size_t white = 0;
    for (const Pixel& pixel : pixels)
        white += pixel[1] > 200 && pixel[2] > 200;
    EXPECT_GT(white, 10u) << "the text is missing";
    EXPECT_EQ(device_->validation_messages(), 0) << messages_.text();
}

TEST_F(OverlayTest, StretchesToPicturesOfAnySize) {
    Overlay overlay(*device_, format, frames_in_flight);
    for (const uint32_t width : {64u, 256u, 32u, 512u, 64u}) {
        const gpu::Image picture = make_picture(width, width / 2);
        expect_red_half(draw(overlay, picture, Context::red_half(128, 64)), width, width / 2);
    }
    EXPECT_EQ(device_->validation_messages(), 0) << messages_.text();
}

TEST_F(OverlayTest, TakesRebuiltFonts) {
    Overlay overlay(*device_, format, frames_in_flight);
    const gpu::Image picture = make_picture(128, 64);
    draw(overlay, picture, Context::red_half(128, 64));
    Context::build_fonts(26.0f);
    expect_red_half(draw(overlay, picture, Context::red_half(128, 64)), 128, 64);
    EXPECT_EQ(device_->validation_messages(), 0) << messages_.text();
}

TEST_F(OverlayTest, EmptyListsLeaveThePictureAlone) {
    Overlay overlay(*device_, format, frames_in_flight);
    const gpu::Image picture = make_picture(32, 32);
    ImGui::GetIO().DisplaySize = ImVec2(32, 32);
    ImGui::NewFrame();
    ImGui::Render();
    for (const Pixel& pixel : draw(overlay, picture, ImGui::GetDrawData()))
        ASSERT_EQ(pixel, background);
    EXPECT_EQ(device_->validation_messages(), 0) << messages_.text();
}

TEST_F(OverlayTest, CanBeMadeAgain) {
    const gpu::Image picture = make_picture(128, 64);
    for (int i = 0; i < 3; ++i) {
        Overlay overlay(*device_, format, frames_in_flight);
        expect_red_half(draw(overlay, picture, Context::red_half(128, 64)), 128, 64);
    }
    EXPECT_EQ(device_->validation_messages(), 0) << messages_.text();
}

} // namespace
} // namespace vigil::vkpt
