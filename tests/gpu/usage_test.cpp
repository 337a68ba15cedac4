// SPDX-License-Identifier: GPL-2.0-or-later
// Memory and uploads are counted by the names of buffers and images, from when they are made until
// they are gone.
#include "gpu/validated.h"
#include "refresh/vkpt/gpu/commands.h"
#include "refresh/vkpt/gpu/image.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace vigil::gpu {
namespace {

class UsageTest : public testing::Test {
protected:
    UsageTest() : device_(test::validated(), nullptr) {}
    ~UsageTest() override { EXPECT_EQ(device_.validation_messages(), 0); }

    uint64_t bytes_of(std::string_view name) const {
        const ByteCounts memory = device_.usage().memory();
        const auto found = memory.find(name);
        return found == memory.end() ? 0 : found->second;
    }

    Device device_;
};

TEST_F(UsageTest, MemoryIsThatOfWhatLives) {
    {
        Buffer one(device_, 1000, MemoryUse::Device, "heap");
        const uint64_t single = bytes_of("heap");
        EXPECT_GE(single, 1000u);
        const Buffer two(device_, 1000, MemoryUse::Device, "heap");
        EXPECT_EQ(bytes_of("heap"), 2 * single);
        EXPECT_EQ(two.name(), "heap");
        // Moved, it is counted once; replaced, what was there is gone.
        Buffer moved = std::move(one);
        EXPECT_EQ(bytes_of("heap"), 2 * single);
        moved = Buffer(device_, 1000, MemoryUse::Upload, "other");
        EXPECT_EQ(bytes_of("heap"), single);
        EXPECT_GE(bytes_of("other"), 1000u);
        const Image image(device_, 16, 16, VK_FORMAT_R8G8B8A8_UNORM,
                          VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT, "picture");
        EXPECT_GE(bytes_of("picture"), 1024u);
    }
    EXPECT_TRUE(device_.usage().memory().empty());
}

TEST_F(UsageTest, UploadsAreThoseSinceTheLastLook) {
    const std::array<uint32_t, 5> values{1, 2, 3, 4, 5};
    const Buffer made = make_buffer(device_, std::as_bytes(std::span(values)), "made");
    const Buffer empty(device_, 64, MemoryUse::Device, "filled");
    FrameCommands commands(device_);
    commands.begin();
    commands.upload(empty, 4, std::as_bytes(std::span(values)));
    commands.upload(empty, 24, std::as_bytes(std::span(values).first(2)));
    commands.upload(empty, 0, {});
    commands.submit(VK_NULL_HANDLE, 0, VK_NULL_HANDLE);
    commands.finish();
    EXPECT_EQ(device_.usage().take_uploads(), (ByteCounts{{"filled", 28}, {"made", 20}}));
    EXPECT_TRUE(device_.usage().take_uploads().empty());
}

} // namespace
} // namespace vigil::gpu
