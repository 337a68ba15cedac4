// SPDX-License-Identifier: GPL-2.0-or-later
// The swapchain in a real window (SDL 2) under core and synchronisation validation: frames through
// resizes, vsync changes, letterboxing and dropped frames without a message. Skipped without a
// display. It does not read the screen back: no window system offers that portably.
#include "common/error.h"
#include "gpu/validated.h"
#include "refresh/refresh.h"
#include "refresh/vkpt/gpu/commands.h"
#include "refresh/vkpt/gpu/swapchain.h"
#include "validation_text.h"

#include <SDL.h>
#include <SDL_vulkan.h>
#include <cstdlib>
#include <gtest/gtest.h>

namespace vigil::vkpt {
namespace {

constexpr uint32_t frames_in_flight = 2;

class TestWindow : public refresh::SurfaceProvider {
public:
    TestWindow() {
        window_ = SDL_CreateWindow("swapchain test", 0, 0, 160, 120,
                                   SDL_WINDOW_VULKAN | SDL_WINDOW_RESIZABLE);
        if (!window_) fail("SDL: {}", SDL_GetError());
    }
    ~TestWindow() override { SDL_DestroyWindow(window_); }
    TestWindow(const TestWindow&) = delete;
    TestWindow& operator=(const TestWindow&) = delete;

    std::vector<std::string> instance_extensions() const override {
        unsigned count = 0;
        SDL_Vulkan_GetInstanceExtensions(window_, &count, nullptr);
        std::vector<const char*> names(count);
        SDL_Vulkan_GetInstanceExtensions(window_, &count, names.data());
        return {names.begin(), names.end()};
    }
    VkSurfaceKHR_T* create_surface(VkInstance_T* instance) override {
        VkSurfaceKHR surface = VK_NULL_HANDLE;
        if (!SDL_Vulkan_CreateSurface(window_, instance, &surface)) fail("SDL: {}", SDL_GetError());
        return surface;
    }
    glm::ivec2 framebuffer_size() const override {
        if (minimised) return {0, 0};
        glm::ivec2 size{0};
        SDL_Vulkan_GetDrawableSize(window_, &size.x, &size.y);
        return size;
    }

    void resize(int width, int height) {
        SDL_SetWindowSize(window_, width, height);
        SDL_PumpEvents();
    }

    bool minimised = false;

private:
    SDL_Window* window_ = nullptr;
};

class SwapchainTest : public testing::Test {
protected:
    // One connection for all tests: an X server may reset itself when its last client leaves, and
    // refuses the next one meanwhile.
    static void SetUpTestSuite() {
        if (!has_display()) return;
        ASSERT_EQ(SDL_Init(SDL_INIT_VIDEO), 0) << SDL_GetError();
    }
    static void TearDownTestSuite() { SDL_Quit(); }

    static bool has_display() { return std::getenv("DISPLAY") || std::getenv("WAYLAND_DISPLAY"); }

    void SetUp() override {
        if (!has_display()) GTEST_SKIP() << "no display: windows cannot be tested";
        window_.emplace();
        device_.emplace(test::validated(), &*window_);
        for (uint32_t i = 0; i < frames_in_flight; ++i)
            frames_.emplace_back(*device_);
        picture_ = gpu::Image(*device_, 64, 48, VK_FORMAT_R8G8B8A8_UNORM,
                              VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT,
                              "picture");
        gpu::run_now(*device_, [&](VkCommandBuffer commands) {
            gpu::transition(commands, picture_.handle(), VK_IMAGE_LAYOUT_UNDEFINED,
                            VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
        });
        swapchain_.emplace(*device_, *window_, frames_in_flight);
    }
    void TearDown() override {
        if (!device_) return;
        swapchain_.reset();
        device_->wait_idle();
        EXPECT_EQ(device_->validation_messages(), 0) << messages_.text();
    }

    /// Shows one frame in the part of the window that `area` names; false if it was dropped.
    bool show(bool vsync, std::optional<VkRect2D> area = {}) {
        gpu::FrameCommands& frame = frames_[next_++ % frames_in_flight];
        frame.begin();
        const std::optional<gpu::SwapchainTarget> target = swapchain_->acquire(vsync);
        if (!target) {
            frame.submit(VK_NULL_HANDLE, 0, VK_NULL_HANDLE);
            return false;
        }
        if (area)
            swapchain_->blit(frame.commands(), *target, picture_, *area);
        else
            swapchain_->blit(frame.commands(), *target, picture_);
        frame.submit(target->acquired, gpu::Swapchain::wait_stage, target->finished);
        swapchain_->present(*target);
        shown_ = target->extent;
        return true;
    }

    ValidationText messages_;
    std::optional<TestWindow> window_;
    std::optional<gpu::Device> device_;
    std::vector<gpu::FrameCommands> frames_;
    gpu::Image picture_;
    std::optional<gpu::Swapchain> swapchain_;
    VkExtent2D shown_{};
    size_t next_ = 0;
};

TEST_F(SwapchainTest, ShowsFramesWithoutRemakingImages) {
    for (int i = 0; i < 12; ++i)
        EXPECT_TRUE(show(true));
    EXPECT_EQ(swapchain_->generation(), 1);
    EXPECT_EQ(shown_.width, 160u);
    EXPECT_EQ(shown_.height, 120u);
}

TEST_F(SwapchainTest, StoresBytesAsTheyAre) {
    ASSERT_TRUE(show(true));
    const VkFormat format = swapchain_->format();
    EXPECT_TRUE(format == VK_FORMAT_B8G8R8A8_UNORM || format == VK_FORMAT_R8G8B8A8_UNORM ||
                format == VK_FORMAT_A8B8G8R8_UNORM_PACK32);
}

TEST_F(SwapchainTest, FollowsTheWindowsSize) {
    for (const glm::ivec2 size : {glm::ivec2{200, 100}, {90, 130}, {320, 240}, {91, 131}}) {
        show(true);
        window_->resize(size.x, size.y);
        bool arrived = false;
        for (int i = 0; i < 50 && !arrived; ++i) {
            SDL_PumpEvents();
            show(true);
            arrived = shown_.width == static_cast<uint32_t>(size.x) &&
                      shown_.height == static_cast<uint32_t>(size.y);
        }
        EXPECT_TRUE(arrived) << size.x << " x " << size.y;
    }
}

TEST_F(SwapchainTest, SwitchesVsyncWhileRunning) {
    for (int i = 0; i < 12; ++i) {
        const bool vsync = i / 3 % 2 == 0;
        EXPECT_TRUE(show(vsync));
        if (vsync) {
            EXPECT_EQ(swapchain_->present_mode(), VK_PRESENT_MODE_FIFO_KHR);
        }
    }
    EXPECT_EQ(swapchain_->generation(), 4);
}

TEST_F(SwapchainTest, DropsFramesWhileMinimised) {
    EXPECT_TRUE(show(true));
    window_->minimised = true;
    for (int i = 0; i < 5; ++i)
        EXPECT_FALSE(show(true));
    window_->minimised = false;
    for (int i = 0; i < 5; ++i)
        EXPECT_TRUE(show(true));
}

TEST_F(SwapchainTest, HandsOutAnImageAgainWhoseFrameFailed) {
    ASSERT_TRUE(show(true));
    const std::optional<gpu::SwapchainTarget> lost = swapchain_->acquire(true);
    ASSERT_TRUE(lost);
    const std::optional<gpu::SwapchainTarget> again = swapchain_->acquire(true);
    ASSERT_TRUE(again);
    EXPECT_EQ(lost->index, again->index);
    EXPECT_EQ(lost->acquired, again->acquired);
    for (int i = 0; i < 8; ++i)
        EXPECT_TRUE(show(true));
}

TEST_F(SwapchainTest, ClipsAndLetterboxes) {
    EXPECT_TRUE(show(true, VkRect2D{{0, 15}, {160, 90}}));
    EXPECT_TRUE(show(true, VkRect2D{{-50, -50}, {1000, 1000}}));
    EXPECT_TRUE(show(true, VkRect2D{{40, 30}, {0, 0}}));
    EXPECT_TRUE(show(true, VkRect2D{{500, 500}, {10, 10}}));
}

} // namespace
} // namespace vigil::vkpt
